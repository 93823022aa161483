// Twin of the stage `perturb`: the multiplexer of [Peercy97 fig. 3], or the displacement of fig. 2.
#pragma once

#include "golden/triangle/packet.h"
#include "golden/vector.h"

namespace wrinkle::exact {

// N' = A - fu B - fv C; A = Pu x Pv, B = Pv x N, C = N x Pu [Peercy97 eq. 1-2].
inline Vec3 displace(const DrawWords& draw, Vec3 a, Vec3 b, Vec3 c, Vec2 gradient) {
  return draw.bump ? a - gradient.x * b - gradient.y * c : a;
}

inline Vec3 perturb(const DrawWords& draw, Vec3 interpolated_n, Vec3 texture_n) {
  return draw.bump ? texture_n : interpolated_n;
}

}  // namespace wrinkle::exact

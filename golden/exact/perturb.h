// Twin of the stage `perturb`: the multiplexer of [Peercy97 fig. 3], or the displacement of fig. 2.
#pragma once

#include "golden/exact/fragments.h"
#include "golden/triangle/packet.h"
#include "golden/vector.h"

namespace wrinkle::exact {

// N' = A - fu B - fv C; A = Pu x Pv, B = Pv x N, C = N x Pu [Peercy97 eq. 1-2].
inline Vec3 displace(const DrawWords& draw, Vec3 a, Vec3 b, Vec3 c, Vec2 gradient) {
  return draw.bump ? a - gradient.x * b - gradient.y * c : a;
}

// The perturbed normal of fragment i, by the datapath of the configuration.
inline Vec3 perturb(const Shape& config, const DrawWords& draw, const Fragments& batch, std::size_t i) {
  if (config.frame_unbounded != 0)
    return displace(draw, batch.interpolated_a[i], batch.interpolated_b[i], batch.interpolated_c[i], batch.gradient[i]);
  return draw.bump ? batch.texture_n[i] : batch.interpolated_n[i];
}

}  // namespace wrinkle::exact

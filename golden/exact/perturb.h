// Twin of the stage `perturb`: the multiplexer of [Peercy97 fig. 3].
#pragma once

#include "golden/triangle/packet.h"
#include "golden/vector.h"

namespace wrinkle::exact {

inline Vec3 perturb(const DrawWords& draw, Vec3 interpolated_n, Vec3 texture_n) {
  return draw.bump ? texture_n : interpolated_n;
}

}  // namespace wrinkle::exact

// Twin of the stage `perspective`.
#pragma once

#include "golden/exact/interpolate.h"

namespace wrinkle::exact {

// u, v of u*q, v*q.
inline Vec2 divide(const Config& config, const Interpolated& interpolated) {
  if (config.perspective == 0) return {interpolated.u, interpolated.v};
  return {interpolated.u / interpolated.q, interpolated.v / interpolated.q};
}

}  // namespace wrinkle::exact

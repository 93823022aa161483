// Twin of the stage `perspective`.
#pragma once

#include "golden/config/config.h"
#include "golden/vector.h"

namespace wrinkle::exact {

// u, v of u*q, v*q.
inline Vec2 divide(const Shape& config, double u, double v, double q) {
  if (config.perspective == 0) return {u, v};
  return {u / q, v / q};
}

}  // namespace wrinkle::exact

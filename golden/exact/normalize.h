// Twin of the stage `normalize`.
#pragma once

#include "golden/config/config.h"
#include "golden/vector.h"

namespace wrinkle::exact {

// `normalizer` is Config::normalizer_n, _l or _h. Zero stays zero. Where the vectors are normalized after the dot
// products, this is mantissa times scale, and `light` has the same products of it.
inline Vec3 normalize(int normalizer, Vec3 v) {
  return normalizer == static_cast<int>(Normalizer::kNone) ? v : wrinkle::normalize(v);
}

}  // namespace wrinkle::exact

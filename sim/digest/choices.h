// Choices that a configuration drawn at random hardly ever has, since they demand much of the others.
#pragma once

#include <algorithm>

#include "golden/config/config.h"

namespace wrinkle {

// Changes the choices of a legal configuration to what `sharing = on` demands.
inline void share_units(Config& c) {
  c.sharing = 1;
  while (Shape(c).normal_like_light == 0) --c.datapath;  // the first one's is
  c.light_vectors = c.normalize_order = 0;
  c.lighting = static_cast<int>(Lighting::kHalfangle);
  c.normalizer_n = std::max(c.normalizer_n, static_cast<int>(Normalizer::kFaithful));
  c.normalizer_l = c.normalizer_h = c.normalizer_n;
}

// Changes the choices of a legal configuration to what `normalize_order = after` demands.
inline void normalize_after(Config& c) {
  c.normalize_order = static_cast<int>(NormalizeOrder::kAfter);
  while (Shape(c).normal_width == 0) --c.datapath;  // the first one has a normal
  c.light_vectors = c.self_shadow = c.sharing = 0;
  c.lighting %= static_cast<int>(Lighting::kHalfangle) + 1;
  c.normalizer_n = c.normalizer_l = c.normalizer_h = static_cast<int>(Normalizer::kFaithful);
}

}  // namespace wrinkle

// Legal configurations at random. Needs nothing but golden/config.h, so that the tests of golden use it too.
#pragma once

#include <algorithm>
#include <concepts>
#include <limits>

#include "golden/config/config.h"

namespace wrinkle {

// Draws until check() is content. `between(low, high)` draws one integer. The screen is at most 2^largest_screen wide.
template <std::invocable<int, int> Between>
Config random_config(Between&& between, int largest_screen = std::numeric_limits<int>::max()) {
  Config config;
  do {
    for (const Parameter& parameter : parameters()) {
      config.*parameter.member = static_cast<int>(between(parameter.minimum, parameter.maximum));
    }
    if (config.screen_bits > largest_screen) config.screen_bits = largest_screen;
  } while (!check(config).key.empty());
  return config;
}

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

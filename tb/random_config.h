// Legal configurations at random. Needs nothing but golden/config.h, so that the tests of golden use it too.
#pragma once

#include <concepts>
#include <limits>

#include "golden/config/config.h"

namespace wrinkle {

// Draws until check() is content. `between(low, high)` draws one integer. The screen is at most 2^largest_screen wide.
// Whether there is a gloss follows from the parity of all others, where it is legal: it takes no number of the stream.
template <std::invocable<int, int> Between>
Config random_config(Between&& between, int largest_screen = std::numeric_limits<int>::max()) {
  Config config;
  do {
    for (const Parameter& parameter : parameters()) {
      if (parameter.member == &Config::gloss_map) continue;
      config.*parameter.member = static_cast<int>(between(parameter.minimum, parameter.maximum));
    }
    if (config.screen_bits > largest_screen) config.screen_bits = largest_screen;
  } while (!check(config).key.empty());
  int sum = 0;
  for (const Parameter& parameter : parameters()) sum += config.*parameter.member;
  if (Shape(config).glossy != 0) config.gloss_map = sum % 2;
  return config;
}

}  // namespace wrinkle

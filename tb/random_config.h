// Legal configurations at random. Needs nothing but golden/config.h, so that the tests of golden use it too.
#pragma once

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

}  // namespace wrinkle

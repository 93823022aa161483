// Intermediate values by name ("arbitrary output variables"): what `render --aov` writes, from any engine.
#pragma once

#include <string>
#include <vector>

#include "golden/config/config.h"
#include "golden/exact/exact.h"
#include "golden/pixel/pixel.h"

namespace wrinkle {

// The same number of a float64 engine: an element of a value of golden/exact/fragment.def.
using ExactNumber = double (*)(const ExactFragment&, std::size_t element);

// One number of a fragment.
struct AovChannel {
  std::string name;  // N.x, u, triangle ...
  int value = -1;    // index in values(config); -1 for `triangle`
  std::size_t element = 0;
  double scale = 1;             // turns the integer into a real number
  ExactNumber exact = nullptr;  // of `exact_element`; null for `triangle`
  std::size_t exact_element = 0;
  int factor = -1;  // index of the value that it is multiplied by; -1: none
  std::size_t factor_element = 0;
};

// What `--aov` accepts: short names, and STAGE_VALUE of every other value that has an exact twin.
std::string aov_help();

// Throws InputError for a name that does not exist, or for a value that the configuration does not have.
std::vector<AovChannel> aov_channels(const Config& config, const std::vector<std::string>& names);

}  // namespace wrinkle

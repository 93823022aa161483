// Intermediate values by name ("arbitrary output variables"): what `render --aov` writes, from any engine.
#pragma once

#include <string>
#include <vector>

#include "golden/config/config.h"
#include "golden/exact/exact.h"
#include "golden/pixel/pixel.h"

namespace wrinkle {

// One number of a fragment.
struct AovChannel {
  std::string name;  // N.x, u, triangle ...
  int value = -1;    // index in values(config); -1 for `triangle`
  std::size_t element = 0;
  double scale = 1;                                 // turns the integer into a real number
  double (*exact)(const ExactFragment&) = nullptr;  // the same number of a float64 engine
  int factor = -1;                                  // index of the value that it is multiplied by; -1: none
  std::size_t factor_element = 0;
};

// Names that aov_channels() accepts, with what they are.
struct AovName {
  std::string_view name, description;
};
std::vector<AovName> aov_names();

// Throws InputError for a name that does not exist, or for a value that the configuration does not have.
std::vector<AovChannel> aov_channels(const Config& config, const std::vector<std::string>& names);

}  // namespace wrinkle

// Which frames a digest consists of.
#pragma once

#include <vector>

#include "sim/digest/table.h"

namespace wrinkle {

// Every named configuration with the paper's patch by Fig. 1, 5 and 6, the teapot and a frame of random triangles; and
// a hundred random configurations, eight more with `sharing`, eight with `normalize_order = after` and sixteen with a
// gloss map, each with a frame of random triangles.
std::vector<DigestFrame> planned_frames();

}  // namespace wrinkle

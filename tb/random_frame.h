// Random configurations and frames, reproducible from a seed: what the soak tests and `stress` feed the machine with.
#pragma once

#include <cstdint>

#include "golden/config/config.h"
#include "golden/triangle/draw.h"

namespace wrinkle {

struct RandomFrame {
  std::uint64_t seed = 1;
  int width = 0, height = 0;  // 0: the whole screen of the configuration
  double fragments = 100000;  // about as many; no bound
  int draws = 8;
};

// Triangles of all sizes from below a sub-pixel to the whole guard band, both windings, slivers, on and off the screen;
// any vectors, zero and opposed ones included; textures of random texels, sizes and wraps. The digests that are kept
// (docs/commands.md, "verify") draw these frames: what is drawn from the random numbers, and in what order, stays.
Frame random_frame(const Config& config, const RandomFrame& wish);

// A legal configuration with every parameter drawn at random.
Config random_config(std::uint64_t seed);

}  // namespace wrinkle

// The planes part of a packet: every interpolated component as a value and two gradients.
#pragma once

#include <array>
#include <cstdint>

#include "golden/triangle/corners.h"

namespace wrinkle {

// Corner values of all components, rounded once to `fraction_bits + G` bits, and the gradients per pixel that all
// pieces of the triangle share, each the nearest of that precision to the exact rational.
struct Planes {
  struct Plane {
    std::array<std::int64_t, 3> corner{};
    std::int64_t dx = 0, dy = 0;  // modulo 2^(width + G)
  };
  std::array<Plane, kComponents> planes{};
  int lod = 0;  // without perspective
};

// Throws std::invalid_argument when a vector is not of about unit length, and what texture_corners() throws.
Planes make_planes(const Shape& config, const Corners& corners, const DrawWords& draw);

// The planes anchored at the first pixel of a piece, ready for the words: half an output LSB is added for the rounding.
std::array<PlaneWords, kComponents> anchor(const Shape& config, const Corners& corners, const Planes& planes,
                                           bool mirror, int y, const EdgeWords& start);

}  // namespace wrinkle

// The planes part of a packet: every plane as a value and two gradients.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "golden/triangle/corners.h"

namespace wrinkle {

// Corner values of all planes, rounded once to `fraction_bits + G` bits, and the gradients per pixel that all
// pieces of the triangle share, each the nearest of that precision to the exact rational.
struct Planes {
  struct Plane {
    std::array<std::int64_t, 3> corner{};
    std::int64_t dx = 0, dy = 0;  // modulo 2^(width + G)
  };
  std::vector<Plane> planes;  // in the order of plane_formats()
  int lod = 0;                // where the level of detail is held
};

// Throws std::invalid_argument when a vector is not of about unit length, and what texture_corners() throws.
Planes make_planes(const Shape& config, const Corners& corners, const DrawWords& draw);

// Anchors the planes at the first pixel of a piece, ready for the words: half an output LSB is added for the rounding.
void anchor(const Shape& config, const Corners& corners, const Planes& planes, TriangleWords& piece);

}  // namespace wrinkle

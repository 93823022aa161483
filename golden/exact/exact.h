// The float64 twins: the same algorithm as the pixel stages, no rounding; and `ideal`, Eq. 1-2 at every pixel.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "golden/config/config.h"
#include "golden/datapath/datapath.h"
#include "golden/triangle/draw.h"

namespace wrinkle {

// One fragment in float64.
struct ExactFragment {
  std::int32_t x = 0, y = 0;
  std::uint32_t triangle = 0;  // ScreenTriangle::id
  std::uint32_t draw = 0;
#define WRINKLE_EXACT(type, name, initial, wire) type name = initial;
#include "golden/exact/fragment.def"
#undef WRINKLE_EXACT
};

using ExactSink = std::function<void(const ExactFragment&)>;

// Fragments of a frame in the order of its triangles; within a triangle by rows. Coverage is the hardware's, exactly.
void draw_exact(const Config& config, const Frame& frame, const ExactSink& sink);

// As draw_exact, but N', L and H of every pixel are computed in world space from the analytic surface and height field
// at the pixel's (u, v) [Peercy97 eq. 1-2]; triangles without a surface are drawn as by
// draw_exact. ScreenTriangle::surface is taken to be in world space.
void draw_ideal(const Config& config, const Frame& frame, const ExactSink& sink);

}  // namespace wrinkle

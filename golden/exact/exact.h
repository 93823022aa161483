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

// The truth that a method is held against: the pixels of draw_exact, each computed in world space from all that the
// scene says, also from what the configuration leaves out. On an analytic surface N', L and H are those of the surface
// and its height field at the pixel's (u, v) [Peercy97 eq. 1-2]. On other triangles position, frame and texture
// coordinates are interpolated as the perspective demands, the frame is made orthonormal at the pixel, and N' comes from
// the normal map in it. Filter, lighting model and self-shadow are the configuration's; the level of detail is the
// pixel's own. Frame::ideal has an entry for each draw; ScreenTriangle::surface is in world space.
void draw_ideal(const Config& config, const Frame& frame, const ExactSink& sink);

}  // namespace wrinkle

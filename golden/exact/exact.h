// The float64 twins: the same algorithm as the pixel stages, no rounding; and `ideal`, Eq. 1-2 at every pixel.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "golden/config/config.h"
#include "golden/triangle/draw.h"

namespace wrinkle {

// One fragment in float64. Names and order as values.def; colour in [0, 1] before quantisation.
struct ExactFragment {
  std::int32_t x = 0, y = 0;
  std::uint32_t triangle = 0;  // ScreenTriangle::id
  std::uint32_t draw = 0;
  Vec3 interpolated_n, interpolated_l, interpolated_h;  // h: of E where the lighting asks for it
  Vec3 interpolated_a, interpolated_b, interpolated_c;  // Pu x Pv, Pv x N, N x Pu with one scale
  double u = 0, v = 0, q = 1, lod = 0, z = 0;
  Vec3 texture_n, decal{1, 1, 1};
  Vec2 gradient;  // fu, fv of full scale 1
  Vec3 perturbed_n;
  Vec3 n, l, h;  // unit, or as interpolated where the normalizer is `none`
  double nl = 0, nh = 0, diffuse = 0, specular = 0;
  Vec3 colour;
};

using ExactSink = std::function<void(const ExactFragment&)>;

// Fragments of a frame in the order of its triangles; within a triangle by rows. Coverage is the hardware's, exactly.
void draw_exact(const Config& config, const Frame& frame, const ExactSink& sink);

// As draw_exact, but N', L and H of every pixel are computed in world space from the analytic surface and height field
// at the pixel's (u, v) [Peercy97 eq. 1-2]; triangles without a surface are drawn as by
// draw_exact. ScreenTriangle::surface is taken to be in world space.
void draw_ideal(const Config& config, const Frame& frame, const ExactSink& sink);

}  // namespace wrinkle

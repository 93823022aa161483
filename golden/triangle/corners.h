// The three corners of a triangle in an order that does not depend on how the mesh lists them, so that the same
// triangle gives the same words whichever corner comes first.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "golden/config/config.h"
#include "golden/triangle/packet.h"

namespace wrinkle {

struct Corners {
  std::array<const ScreenVertex*, 3> v;  // by y, then x
  std::int64_t area = 0;  // twice the area in sub-pixels squared; positive: corner 1 is right of edge 0-2
};

// Throws std::invalid_argument when a corner lies outside the guard band [-2^X, 2^(X+1)) pixels, to which the vertex
// rate clips.
Corners sort_corners(const Shape& config, const ScreenTriangle& triangle);

// Texture coordinates as the hardware gets them, before quantisation: whole repeats are taken off (an even number where
// the texture is mirrored, none where it is clamped) and q is scaled so that the largest is just below 1. Without
// `perspective` q is 1. Throws std::range_error when u or v does not fit uv_integer_bits, std::invalid_argument when
// q is not positive.
struct TextureCorners {
  std::array<double, 3> u{}, v{}, q{1, 1, 1};
};
TextureCorners texture_corners(const Shape& config, const Corners& corners, const DrawWords& draw);

// N, L or H at the corners as the hardware gets them. Where `perspective` is on and a normalizer of any length follows,
// each is scaled by its q, relative to the largest of the triangle: the direction of a linearly interpolated q V is
// that of the perspective-correct V, and the normalizer takes the length away, so the hardware pays nothing. The scale
// is at least 2^-4, beyond which short vectors would cost more in precision than the correction gains.
std::array<Vec3, 3> vector_corners(const Shape& config, const Corners& corners, Vec3 ScreenVertex::*member,
                                   int normalizer);

// The vectors in the place of N at the corners as the hardware gets them, one after the other: scaled by q like L and
// H; those that are held over a triangle replaced by their means; and, where they are unbounded and block_exponent =
// triangle, all by one power of two that brings the largest of the triangle into [1/2, 1). A draw without bump has N
// and zeros. Throws std::invalid_argument when a component does not fit.
std::vector<std::array<Vec3, 3>> frame_corners(const Shape& config, const Corners& corners, const DrawWords& draw);

// LSBs that an unsigned or cyclic component keeps clear of both ends of its format: the accumulated error of the
// interpolator over a whole screen, at most 2^(X - G) LSB, must not carry it round.
std::int64_t interpolation_margin(const Shape& config, int width);

// z in [0, 1] as the hardware gets it: margin/2^Z to 1 - (margin + 1)/2^Z.
double depth_in_format(const Shape& config, double z);

}  // namespace wrinkle

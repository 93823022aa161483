// Maps of the slopes of a height field, for Blinn's bump mapping [Peercy97 fig. 2], with their mip chains.
#pragma once

#include "golden/texel/grid.h"
#include "golden/texel/texture.h"

namespace wrinkle {

// Steepest slope of a normal map that is told apart: some 83 degrees.
inline constexpr double kSteepestSlope = 8;

// Components 0 and 1 hold fu and fv over `scale`, within (-1, 1), component 2 holds 1 / scale; 3 to 5 the decal. The
// levels are means of the finer ones: slopes, unlike unit normals, may be filtered.
struct GradientTexture {
  ExactTexture texture;
  double scale = 1;  // the largest slope has the largest code of `texel_bits`
};

// From a height field, per unit of its u and v (v upwards). `base` gives the size, at least that of the field, and the
// decal; sides are powers of two.
GradientTexture gradient_texture(const ExactTexture& base, const Grid<double>& height, int texel_bits,
                                 Wraps wraps = {});
// From the normals of `base` in tangent space, per unit of length along T and B.
GradientTexture gradient_texture(const ExactTexture& base, int texel_bits);

}  // namespace wrinkle

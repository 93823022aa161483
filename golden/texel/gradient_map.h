// Maps of the slopes of a height field, for Blinn's bump mapping [Peercy97 fig. 2], with their mip chains.
#pragma once

#include "golden/texel/grid.h"
#include "golden/texel/texture.h"

namespace wrinkle {

// Steepest slope of a normal map that is told apart: some 83 degrees.
inline constexpr double kSteepestSlope = 8;

// In components 0 and 1 of the bump map fu and fv over `bump_scale`, by which the largest slope has the largest code of
// `texel_bits`. The levels are means of the finer ones: slopes, unlike unit normals, may be filtered.
//
// From a height field, per unit of its u and v (v upwards). `base` gives the size, at least that of the field, and the
// decal; sides are powers of two.
ExactTexture gradient_texture(const ExactTexture& base, const Grid<double>& height, int texel_bits, Wraps wraps = {});
// From the normals of `base` in tangent space, per unit of length along T and B.
ExactTexture gradient_texture(const ExactTexture& base, int texel_bits);

}  // namespace wrinkle

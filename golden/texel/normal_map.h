// Tangent-space normal maps and their mip chains, in float64.
//
// A texel's normal is (x, y, z) along T, B, N of the surface: x to the right of the image, y up the image (B = N x T is
// along increasing v; the image's rows go down), z out of the surface. That is also glTF's convention.
#pragma once

#include <vector>

#include "golden/config/config.h"
#include "golden/texel/grid.h"
#include "golden/vector.h"
#include "golden/vertex/surface.h"

namespace wrinkle {

using NormalMap = Grid<Vec3>;
using MipChain = std::vector<Grid<Vec3>>;  // of normals, or of colours

// From Pu and Pv of the surface at every texel [Peercy97 eq. 3-6].
NormalMap normal_map(const Grid<double>& height, const Surface& surface, Wraps wraps = {});
// For any surface, as if |Pu| = |Pv| = k and Pu at right angles to Pv [Peercy97 eq. 8-11].
NormalMap normal_map(const Grid<double>& height, double k, Wraps wraps = {});

// Texels of a tangent-space map of `surface` in the space that `surface` lies in [Peercy97 section 2.1].
NormalMap out_of_tangent_space(const NormalMap& map, const Surface& surface);

// From an image of a normal map with components in [0, 1]: n = 2c - 1, not normalized. `scale` other than 1 multiplies
// x and y, and normalizes (glTF's normalTexture.scale).
NormalMap normal_map_from_image(const Grid<Vec3>& image, double scale = 1);

// To the next power of two in each direction (bilinear), at most 2^12 (area mean). The same grid where its
// sides are powers of two already.
template <class T>
Grid<T> resample_to_power_of_two(const Grid<T>& grid, Wraps wraps = {});
// To the given size; the same grid where it has that size.
template <class T>
Grid<T> resample(const Grid<T>& grid, int width, int height, Wraps wraps = {});
// Half the size in each direction (1 stays 1), each texel the mean of those it covers. Sides are powers of two.
template <class T>
Grid<T> halve(const Grid<T>& grid);

// Levels down to 1 x 1, each the means of the finer one; sides of level 0 are powers of two.
MipChain colour_mips(Grid<Vec3> level0);
// (a) Filtered and renormalized: each level the means of the finer one, made unit length (zero stays zero). Level 0 is
// left as it is.
MipChain normal_mips(NormalMap level0);
// (b) The height field filtered, and the normals of every level computed from it.
MipChain normal_mips(const Grid<double>& height, const Surface& surface, Wraps wraps = {});
MipChain normal_mips(const Grid<double>& height, double k, Wraps wraps = {});

}  // namespace wrinkle

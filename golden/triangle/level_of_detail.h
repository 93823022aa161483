// Level of detail: log2 of the texels passed per pixel step. Only + - * / of doubles and integers, so that every
// compiler gives the same bits.
#pragma once

#include <cstdint>

#include "golden/triangle/corners.h"

namespace wrinkle {

// rho^2: the larger of |d(u,v)/dx|^2 and |d(u,v)/dy|^2, in texels of level 0 per pixel, of the affine map (q not used).
double texel_rate_squared(const Shape& config, const Corners& corners, const TextureCorners& texture,
                          const DrawWords& draw);
// The same for u*q / q, exactly at corner `i`.
double texel_rate_squared_at(const Shape& config, const Corners& corners, const TextureCorners& texture,
                             const DrawWords& draw, std::size_t i);

// floor(2^fraction_bits * log2(x)), x > 0.
std::int64_t log2_fixed(double x, int fraction_bits);

// log2(rho) with `fraction_bits`, rounded to nearest, within [lowest, highest]; `lowest` for rho = 0.
std::int64_t level_of_detail(double rho_squared, int fraction_bits, int lowest, int highest);

// Levels beyond which the level of detail at a corner is not told apart: past every mip chain, well inside s5.LB.
inline constexpr int kFarthestLevel = 16;

}  // namespace wrinkle

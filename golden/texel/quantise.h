// From mip chains in float to the texel words of a configuration.
#pragma once

#include <cstdint>

#include "golden/config/config.h"
#include "golden/texel/normal_map.h"
#include "golden/texel/texture.h"

namespace wrinkle {

// One texture from a chain of normals and a chain of colours in [0, 1], either of which may be empty: normals are then
// (0, 0, 1), colours 1. Chains of different sizes are brought to the larger one: the finer levels that the smaller
// chain lacks are interpolated from its level 0.
ExactTexture assemble(const MipChain& normals, const MipChain& decal, Wraps wraps = {});

// Code of a normal component n (full scale 1) in T bits. `range`, 2c - (2^T - 1): c = round((n + 1) / 2 (2^T - 1)), so
// that an 8-bit image of a normal map comes back as its own codes. `offset`, c - 2^(T-1): c = 2^(T-1) + round(n
// (2^(T-1) - 1)), so that (0, 0, 1) is exact. n is limited to [-1, 1].
std::uint64_t normal_code(double n, Decode decode, int texel_bits);
// Code of a slope f of full scale 1 in T bits, c - 2^(T-1) in units of 2^-(T-1): c = 2^(T-1) + round(f 2^(T-1)),
// limited.
std::uint64_t gradient_code(double f, int texel_bits);
// Code of a colour in [0, 1]: round(c (2^T - 1)).
std::uint64_t decal_code(double c, int texel_bits);

// The components that the configuration has (three of normal, or two of slope, if it has bump mapping, three of decal
// if it has that).
Texture quantise(const ExactTexture& exact, const Shape& config);

}  // namespace wrinkle

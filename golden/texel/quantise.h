// From mip chains in float to the texel words of a configuration.
#pragma once

#include <cstdint>

#include "golden/config/config.h"
#include "golden/texel/normal_map.h"
#include "golden/texel/texture.h"

namespace wrinkle {

// One texture from a chain of normals, one of colours and one of gloss (its first component), both in [0, 1]. Each may
// be empty: normals are then (0, 0, 1), colours and gloss 1. Chains of different sizes are brought to the largest one:
// the finer levels that a smaller chain lacks are interpolated from its level 0.
ExactTexture assemble(const MipChain& normals, const MipChain& decal, const MipChain& gloss = {}, Wraps wraps = {});

// Code of a component of the bump map, in [-1, 1] or limited to it, by the format of the datapath: the nearest to
// (offset + value * full scale) / 2, ties up.
std::uint64_t bump_code(double value, const Shape& config);
// Code of a colour or a gloss in [0, 1]: round(c (2^T - 1)).
std::uint64_t decal_code(double c, int texel_bits);

// The components that the configuration has: those of its bump map, then three of base colour and one of gloss.
Texture quantise(const ExactTexture& exact, const Shape& config);

}  // namespace wrinkle

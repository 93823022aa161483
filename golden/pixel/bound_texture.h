// A private copy of a texture, laid out for one pair of wrap modes so that the four texels of a bilinear sample are two
// words of 64 bits: every row is followed by what lies right of its last texel, every level by what lies below.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "golden/texel/texture.h"

namespace wrinkle {

inline constexpr std::size_t kLevels = 16;

struct BoundTexture {
  // Texel (x, y) of a level is [offset + y * stride + x]: in `low` its first components, the bump map
  // (a normal, or fu and fv) or else the decal; in `high` a decal that follows.
  // repeat: x in [0, W]; mirror: [0, 2 W]; clamp: [0, W + 1], shifted by one, so that 0 is left of the texture.
  std::vector<std::uint32_t> low, high;
  std::array<std::int32_t, kLevels> offset{}, stride{};
};

BoundTexture bind_texture(const Texture& texture, Wrap wrap_u, Wrap wrap_v);

}  // namespace wrinkle

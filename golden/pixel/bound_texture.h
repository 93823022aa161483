// A private copy of a texture, laid out for one pair of wrap modes so that the four texels of a bilinear sample lie
// side by side: every texel is followed by the one below, every row by what lies right of its last texel.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "golden/texel/texture.h"

namespace wrinkle {

inline constexpr std::size_t kLevels = 16;

struct BoundTexture {
  // Texels (x, y) and (x, y + 1) of a level are [2 i] and [2 i + 1], i = offset + y * stride + x: in `low` the first
  // components, the bump map (a normal, or fu and fv) or else the decal; in `high` a decal that follows.
  // repeat: x in [0, W]; mirror: [0, 2 W]; clamp: [0, W + 1], shifted by one, so that 0 is left of the texture; y
  // likewise, less the last.
  std::vector<std::uint32_t> low, high;
  std::array<std::int32_t, kLevels> offset{}, stride{};
};

BoundTexture bind_texture(const Texture& texture, Wrap wrap_u, Wrap wrap_v);

}  // namespace wrinkle

// A private copy of a texture, laid out for one pair of wrap modes so that the four texels of a bilinear sample lie
// side by side: every texel is followed by the one below, every row by what lies right of its last texel.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "golden/texel/texture.h"

namespace wrinkle {

inline constexpr std::size_t kLevels = 16;
// Components of a texel in one word of 32 bits.
inline constexpr int kPlaneComponents = 3;

struct BoundTexture {
  // Texels (x, y) and (x, y + 1) of a level are [2 i] and [2 i + 1], i = offset + y * stride + x, of every plane.
  // repeat: x in [0, W]; mirror: [0, 2 W]; clamp: [0, W + 1], shifted by one, so that 0 is left of the texture; y
  // likewise, less the last.
  std::vector<std::vector<std::uint32_t>> planes;
  std::array<std::int32_t, kLevels> offset{}, stride{};
  int bump_components = 0;

  // The plane that component `first` begins: the bump map fills whole planes, so does a base colour, and a gloss ends.
  const std::vector<std::uint32_t>& plane_of(int first) const {
    const bool is_bump = first < bump_components;
    const int before = is_bump ? first : first - bump_components;
    const int bump_planes = (bump_components + kPlaneComponents - 1) / kPlaneComponents;
    return planes[static_cast<std::size_t>(before / kPlaneComponents + (is_bump ? 0 : bump_planes))];
  }
};

// The first `bump_components` of a texel are the bump map.
BoundTexture bind_texture(const Texture& texture, int bump_components, Wrap wrap_u, Wrap wrap_v);

}  // namespace wrinkle

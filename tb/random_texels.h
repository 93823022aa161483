// Texels of random codes, and of given ones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "golden/texel/texture.h"

namespace wrinkle {

// The words of so many texels of a texture. `next()` draws 64 random bits.
template <class Next>
std::vector<std::uint64_t> random_texels(const Texture& texture, int count, Next&& next) {
  const int words = texture.texel_words();
  const int last_bits = texture.components * texture.component_bits - 64 * (words - 1);
  const std::uint64_t last_mask = ~std::uint64_t{0} >> (64 - last_bits);
  std::vector<std::uint64_t> texels;
  texels.reserve(static_cast<std::size_t>(count) * static_cast<std::size_t>(words));
  for (int i = 0; i < count; ++i)
    for (int word = 1; word <= words; ++word)
      texels.push_back(next() & (word == words ? last_mask : ~std::uint64_t{0}));
  return texels;
}

// Sets a component of the texel `index` of a level, which was 0.
inline void put_code(const Texture& texture, std::vector<std::uint64_t>& level, std::size_t index, int component,
                     std::uint64_t code) {
  std::uint64_t* words = &level[index * static_cast<std::size_t>(texture.texel_words())];
  const int first = component * texture.component_bits, shift = first % 64;
  words[first / 64] |= code << shift;
  if (shift + texture.component_bits > 64) words[first / 64 + 1] |= code >> (64 - shift);
}

}  // namespace wrinkle

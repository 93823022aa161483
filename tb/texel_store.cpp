#include "tb/texel_store.h"

#include <algorithm>

namespace wrinkle {

void TexelStore::load(const std::vector<Texture>& textures) {
  words_.clear();
  levels_.clear();
  first_level_.assign(1, 0);
  texel_words_ = 1;
  for (const Texture& texture : textures)
    texel_words_ = std::max(texel_words_, static_cast<std::size_t>(texture.texel_words()));
  for (const Texture& texture : textures) {
    const auto held = static_cast<std::size_t>(texture.texel_words());
    // Verilator takes no bits above a port's own.
    const int last_bits = texture.components * texture.component_bits - 64 * (texture.texel_words() - 1);
    const std::uint64_t last_mask = ~std::uint64_t{0} >> (64 - last_bits);
    for (int level = 0; level <= texture.max_level(); ++level) {
      levels_.push_back({size(), static_cast<std::uint32_t>(texture.width(level)),
                         static_cast<std::uint32_t>(texture.height(level))});
      const std::vector<std::uint64_t>& texels = texture.levels[static_cast<std::size_t>(level)];
      for (std::size_t at = 0; at < texels.size(); at += held) {
        words_.insert(words_.end(), texels.begin() + static_cast<std::ptrdiff_t>(at),
                      texels.begin() + static_cast<std::ptrdiff_t>(at + held));
        words_.back() &= last_mask;
        words_.resize(words_.size() + texel_words_ - held);
      }
    }
    first_level_.push_back(levels_.size());
  }
}

}  // namespace wrinkle

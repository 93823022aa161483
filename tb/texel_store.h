// Where the texels of a run lie in the texture memory.
#pragma once

#include <cstdint>
#include <cstring>
#include <vector>

#include "golden/texel/texture.h"

namespace wrinkle {

// The levels of all textures one after the other, rows in order. Every texel takes the same number of 64-bit words, the
// low one first: what the widest texture of the run needs.
class TexelStore {
 public:
  // Byte address of the texel (0, 0) of a level, and its size.
  struct Level {
    std::uint64_t base;
    std::uint32_t width, height;
  };

  void load(const std::vector<Texture>& textures);

  std::size_t texel_words() const { return texel_words_; }
  // Null for a level that is not there.
  const Level* level(unsigned texture, unsigned level) const {
    if (texture >= first_level_.size() - 1) return nullptr;
    const std::size_t index = first_level_[texture] + level;
    return index < first_level_[texture + 1] ? &levels_[index] : nullptr;
  }
  unsigned char* bytes() { return reinterpret_cast<unsigned char*>(words_.data()); }
  std::uint64_t size() const { return words_.size() * sizeof(std::uint64_t); }

 private:
  std::size_t texel_words_ = 1;
  std::vector<std::uint64_t> words_;
  std::vector<Level> levels_;
  std::vector<std::size_t> first_level_{0};  // per texture, and one past the last
};

}  // namespace wrinkle

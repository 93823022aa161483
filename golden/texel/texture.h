// Textures as the pixel stages see them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "golden/texel/wrap.h"

namespace wrinkle {

// Bits of the widest texel: nine components of a bump map, three of a base colour and a gloss, of ten bits each.
inline constexpr int kMaxTexelWidth = (9 + 3 + 1) * 10;

// A mip chain of packed texels: component 0 (normal x) in the low bits, `component_bits` each. A texel takes
// texel_words() words of its level, the low one first.
// Level l is max(width >> l, 1) by max(height >> l, 1), row-major; sizes are powers of two.
struct Texture {
  int log2_width = 0;
  int log2_height = 0;
  int components = 3;
  int component_bits = 8;
  std::vector<std::vector<std::uint64_t>> levels;

  int max_level() const { return static_cast<int>(levels.size()) - 1; }
  int texel_words() const { return (components * component_bits + 63) / 64; }
  int width(int level) const { return log2_width > level ? 1 << (log2_width - level) : 1; }
  int height(int level) const { return log2_height > level ? 1 << (log2_height - level) : 1; }
};

// The same chain before quantisation, for the exact twin. Components 0-2 hold the normal, of unit length where it was
// normalized, components 3-5 the decal in [0, 1]; a texture without decal leaves those at 1.
struct ExactTexture {
  int log2_width = 0;
  int log2_height = 0;
  std::vector<std::vector<std::array<float, 6>>> levels;

  int max_level() const { return static_cast<int>(levels.size()) - 1; }
  int width(int level) const { return log2_width > level ? 1 << (log2_width - level) : 1; }
  int height(int level) const { return log2_height > level ? 1 << (log2_height - level) : 1; }
};

}  // namespace wrinkle

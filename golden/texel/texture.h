// Textures as the pixel stages see them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "golden/texel/wrap.h"

namespace wrinkle {

// Components of the largest bump map.
inline constexpr std::size_t kMaxBumpComponents = 9;
// Bits of the widest texel: a bump map, three components of a base colour and a gloss, of ten bits each.
inline constexpr int kMaxTexelWidth = (static_cast<int>(kMaxBumpComponents) + 3 + 1) * 10;

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
  // Component of the texel `index` of a level.
  std::uint64_t code(const std::vector<std::uint64_t>& level, std::size_t index, int component) const {
    const std::uint64_t* words = &level[index * static_cast<std::size_t>(texel_words())];
    const int first = component * component_bits, shift = first % 64;
    std::uint64_t bits = words[first / 64] >> shift;
    if (shift + component_bits > 64) bits |= words[first / 64 + 1] << (64 - shift);
    return bits & ((std::uint64_t{1} << component_bits) - 1);
  }
};

// A texel before quantisation. As a scene has it, the bump map is a normal, of unit length where it was normalized; a
// datapath makes of it what its own texels hold. Base colour and gloss are in [0, 1].
struct ExactTexel {
  std::array<float, kMaxBumpComponents> bump{};
  std::array<float, 3> colour{1, 1, 1};
  float gloss = 1;

  bool operator==(const ExactTexel&) const = default;
};

// The same chain before quantisation, for the exact twin.
struct ExactTexture {
  int log2_width = 0;
  int log2_height = 0;
  std::vector<std::vector<ExactTexel>> levels;
  double bump_scale = 1;  // what the components of the bump map were divided by

  int max_level() const { return static_cast<int>(levels.size()) - 1; }
  int width(int level) const { return log2_width > level ? 1 << (log2_width - level) : 1; }
  int height(int level) const { return log2_height > level ? 1 << (log2_height - level) : 1; }
};

}  // namespace wrinkle

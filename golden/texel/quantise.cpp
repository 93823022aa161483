#include "golden/texel/quantise.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace wrinkle {
namespace {

constexpr ExactTexel kFlat{{0, 0, 1}};

int log2_of(int size) { return std::countr_zero(static_cast<unsigned>(size)); }

// Rounds to the nearest code; ties go up.
double round_half_up(double x) { return std::floor(x + 0.5); }

// Level `level` of a texture of width x height at level 0, from a chain that may be smaller, larger or of another
// shape.
Grid<Vec3> level_of(const MipChain& chain, int width, int height, Wraps wraps) {
  for (const Grid<Vec3>& level : chain) {
    if (level.width == width && level.height == height) return level;
  }
  return resample(chain.front(), width, height, wraps);
}

// Sets the first three components of a member of every texel.
template <std::size_t n>
void put(std::vector<ExactTexel>& level, const Grid<Vec3>& values, std::array<float, n> ExactTexel::*member) {
  for (std::size_t i = 0; i < level.size(); ++i) {
    const Vec3 v = values.samples[i];
    auto& components = level[i].*member;
    components[0] = static_cast<float>(v.x);
    components[1] = static_cast<float>(v.y);
    components[2] = static_cast<float>(v.z);
  }
}

void put_gloss(std::vector<ExactTexel>& level, const Grid<Vec3>& values) {
  for (std::size_t i = 0; i < level.size(); ++i) level[i].gloss = static_cast<float>(values.samples[i].x);
}

// Fills the words of texels with codes, from the low bits upwards.
class CodeWriter {
 public:
  CodeWriter(const Texture& texture, std::vector<std::uint64_t>& words)
      : bits_(texture.component_bits), words_(words) {}

  void next_texel() { used_ = 0; }
  void put(std::uint64_t code) {
    if (used_ == 0) words_.push_back(0);
    words_.back() |= code << used_;
    const int room = 64 - used_;
    if (bits_ > room) words_.push_back(code >> room);
    used_ = (used_ + bits_) % 64;
  }

 private:
  int bits_;
  std::vector<std::uint64_t>& words_;
  int used_ = 0;  // bits of the last word; 0: it is full
};

}  // namespace

ExactTexture assemble(const MipChain& normals, const MipChain& decal, const MipChain& gloss, Wraps wraps) {
  int width = 1, height = 1;
  for (const MipChain* chain : {&normals, &decal, &gloss}) {
    if (chain->empty()) continue;
    width = std::max(width, chain->front().width);
    height = std::max(height, chain->front().height);
  }
  ExactTexture texture;
  texture.log2_width = log2_of(width);
  texture.log2_height = log2_of(height);
  const int levels = 1 + std::max(texture.log2_width, texture.log2_height);
  for (int l = 0; l < levels; ++l) {
    const int w = texture.width(l), h = texture.height(l);
    std::vector<ExactTexel> level(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), kFlat);
    if (!normals.empty()) put(level, level_of(normals, w, h, wraps), &ExactTexel::bump);
    if (!decal.empty()) put(level, level_of(decal, w, h, wraps), &ExactTexel::colour);
    if (!gloss.empty()) put_gloss(level, level_of(gloss, w, h, wraps));
    texture.levels.push_back(std::move(level));
  }
  return texture;
}

std::uint64_t bump_code(double value, const Shape& config) {
  const double code = round_half_up((std::clamp(value, -1.0, 1.0) * config.bump_full_scale + config.bump_offset) / 2);
  return static_cast<std::uint64_t>(std::clamp(code, 0.0, std::ldexp(1, config.texel_bits) - 1));
}

std::uint64_t decal_code(double c, int texel_bits) {
  const double top = std::ldexp(1, texel_bits) - 1;
  return static_cast<std::uint64_t>(round_half_up(std::clamp(c, 0.0, 1.0) * top));
}

Texture quantise(const ExactTexture& exact, const Shape& config) {
  const int bits = config.texel_bits;
  const auto components = static_cast<std::size_t>(config.bump_components);
  Texture texture{exact.log2_width, exact.log2_height, config.texels, bits, {}};
  for (const auto& from : exact.levels) {
    std::vector<std::uint64_t> level;
    level.reserve(from.size() * static_cast<std::size_t>(texture.texel_words()));
    CodeWriter writer(texture, level);
    for (const ExactTexel& texel : from) {
      writer.next_texel();
      for (std::size_t k = 0; k < components; ++k) writer.put(bump_code(texel.bump[k], config));
      if (config.decal != 0)
        for (const float channel : texel.colour) writer.put(decal_code(channel, bits));
      if (config.gloss_map != 0) writer.put(decal_code(texel.gloss, bits));
    }
    texture.levels.push_back(std::move(level));
  }
  return texture;
}

}  // namespace wrinkle

#include "golden/texel/quantise.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace wrinkle {
namespace {

using Texel = std::array<float, 6>;
constexpr Texel kFlat{0, 0, 1, 1, 1, 1};

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

void put(std::vector<Texel>& level, const Grid<Vec3>& values, std::size_t first_component) {
  for (std::size_t i = 0; i < level.size(); ++i) {
    const Vec3 v = values.samples[i];
    level[i][first_component] = static_cast<float>(v.x);
    level[i][first_component + 1] = static_cast<float>(v.y);
    level[i][first_component + 2] = static_cast<float>(v.z);
  }
}

}  // namespace

ExactTexture assemble(const MipChain& normals, const MipChain& decal, Wraps wraps) {
  int width = 1, height = 1;
  for (const MipChain* chain : {&normals, &decal}) {
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
    std::vector<Texel> level(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), kFlat);
    if (!normals.empty()) put(level, level_of(normals, w, h, wraps), 0);
    if (!decal.empty()) put(level, level_of(decal, w, h, wraps), 3);
    texture.levels.push_back(std::move(level));
  }
  return texture;
}

std::uint64_t normal_code(double n, Decode decode, int texel_bits) {
  const double limited = std::clamp(n, -1.0, 1.0);
  const double top = std::ldexp(1, texel_bits) - 1, half = std::ldexp(1, texel_bits - 1);
  const double code =
      decode == Decode::kRange ? round_half_up((limited + 1) / 2 * top) : half + round_half_up(limited * (half - 1));
  return static_cast<std::uint64_t>(code);
}

std::uint64_t gradient_code(double f, int texel_bits) {
  const double half = std::ldexp(1, texel_bits - 1);
  return static_cast<std::uint64_t>(half + std::clamp(round_half_up(f * half), -half, half - 1));
}

std::uint64_t decal_code(double c, int texel_bits) {
  const double top = std::ldexp(1, texel_bits) - 1;
  return static_cast<std::uint64_t>(round_half_up(std::clamp(c, 0.0, 1.0) * top));
}

Texture quantise(const ExactTexture& exact, const Shape& config) {
  const auto decode = static_cast<Decode>(config.decode);
  const int bits = config.texel_bits;
  Texture texture{exact.log2_width, exact.log2_height, config.texels, bits, {}};
  for (const auto& from : exact.levels) {
    std::vector<std::uint64_t> level;
    level.reserve(from.size());
    for (const Texel& texel : from) {
      std::uint64_t word = 0;
      int shift = 0;
      if (config.bump_components == 2) {
        for (std::size_t i = 0; i < 2; ++i, shift += bits) word |= gradient_code(texel[i], bits) << shift;
      }
      if (config.bump_components == 3) {
        for (std::size_t i = 0; i < 3; ++i, shift += bits) word |= normal_code(texel[i], decode, bits) << shift;
      }
      if (config.decal != 0) {
        for (std::size_t i = 3; i < 6; ++i, shift += bits) word |= decal_code(texel[i], bits) << shift;
      }
      level.push_back(word);
    }
    texture.levels.push_back(std::move(level));
  }
  return texture;
}

}  // namespace wrinkle

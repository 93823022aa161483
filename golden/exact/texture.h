// Twin of the stage `texture`: a filtered sample of the unquantised texels, with unquantised weights.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "golden/config.h"
#include "golden/texel/texture.h"
#include "golden/triangle/packet.h"
#include "golden/vector.h"

namespace wrinkle::exact {

// Normal in 0 to 2, decal in 3 to 5, as in ExactTexture.
using Sample = std::array<double, 6>;

inline std::int64_t wrap_texel(int wrap, std::int64_t i, std::int64_t size) {
  switch (static_cast<Wrap>(wrap)) {
    case Wrap::kClamp:
      return std::clamp<std::int64_t>(i, 0, size - 1);
    case Wrap::kMirror:
      return (i & size) != 0 ? ~i & (size - 1) : i & (size - 1);
    case Wrap::kRepeat:
      break;
  }
  return i & (size - 1);
}

inline void accumulate(double weight, const std::array<float, 6>& texel, Sample& sample) {
  for (std::size_t k = 0; k < 6; ++k) sample[k] += weight * static_cast<double>(texel[k]);
}

// Adds `weight` times the sample of one mip level.
inline void sample_level(const Config& config, const DrawWords& draw, const ExactTexture& texture, int level, Vec2 uv,
                         double weight, Sample& sample) {
  const auto width = std::int64_t{texture.width(level)}, height = std::int64_t{texture.height(level)};
  const auto& texels = texture.levels[static_cast<std::size_t>(level)];
  const auto at = [&](std::int64_t x, std::int64_t y) -> const std::array<float, 6>& {
    return texels[static_cast<std::size_t>(wrap_texel(draw.wrap_v, y, height) * width +
                                           wrap_texel(draw.wrap_u, x, width))];
  };
  const bool nearest = config.filter == static_cast<int>(Filter::kNearest);
  const double offset = nearest ? 0 : 0.5;
  const double s = uv.x * static_cast<double>(width) - offset, t = uv.y * static_cast<double>(height) - offset;
  const double s0 = std::floor(s), t0 = std::floor(t);
  const auto x = static_cast<std::int64_t>(s0), y = static_cast<std::int64_t>(t0);
  if (nearest) return accumulate(weight, at(x, y), sample);
  const double fx = s - s0, fy = t - t0;
  accumulate(weight * (1 - fx) * (1 - fy), at(x, y), sample);
  accumulate(weight * fx * (1 - fy), at(x + 1, y), sample);
  accumulate(weight * (1 - fx) * fy, at(x, y + 1), sample);
  accumulate(weight * fx * fy, at(x + 1, y + 1), sample);
}

// Without a trilinear filter the nearest level. `lod` of any size; clamped to the chain.
inline Sample sample(const Config& config, const DrawWords& draw, const ExactTexture& texture, Vec2 uv, double lod) {
  Sample result{};
  const double inside = std::clamp(lod, 0.0, static_cast<double>(texture.max_level()));
  const int a = static_cast<int>(config.trilinear() ? inside : std::floor(inside + 0.5));
  const double fraction = config.trilinear() ? inside - a : 0;
  sample_level(config, draw, texture, a, uv, 1 - fraction, result);
  if (fraction > 0) sample_level(config, draw, texture, a + 1, uv, fraction, result);
  return result;
}

}  // namespace wrinkle::exact

// Twin of the stage `texture`: a filtered sample of the unquantised texels, with unquantised weights.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "golden/config/config.h"
#include "golden/datapath/datapath.h"
#include "golden/texel/texture.h"
#include "golden/triangle/packet.h"
#include "golden/vector.h"

namespace wrinkle::exact {

// What the configuration has of a texel, filtered.
struct Sample {
  BumpComponents bump{};
  std::array<double, 3> colour{};
  double gloss = 0;
};

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

// floor(x), where the library's would be a call.
inline std::int64_t floor_to_integer(double x) {
  const auto truncated = static_cast<std::int64_t>(x);
  return truncated - (static_cast<double>(truncated) > x ? 1 : 0);
}

// The one or two texels along an axis, and the share of the second.
struct Tap {
  std::int64_t first, second;
  double fraction;
};
inline Tap tap(const Shape& config, int wrap, double coordinate, int size) {
  const bool nearest = config.filter == static_cast<int>(Filter::kNearest);
  const double t = coordinate * size - (nearest ? 0 : 0.5);
  const std::int64_t i = floor_to_integer(t);
  const std::int64_t first = wrap_texel(wrap, i, size);
  return nearest ? Tap{first, first, 0} : Tap{first, wrap_texel(wrap, i + 1, size), t - static_cast<double>(i)};
}

// Adds `weight` times the sample of one mip level.
inline void sample_level(const Shape& config, const DrawWords& draw, const ExactTexture& texture, int level, Vec2 uv,
                         double weight, Sample& sample) {
  const Tap x = tap(config, draw.wrap_u, uv.x, texture.width(level));
  const Tap y = tap(config, draw.wrap_v, uv.y, texture.height(level));
  const auto& texels = texture.levels[static_cast<std::size_t>(level)];
  const auto components = static_cast<std::size_t>(config.bump_components);
  const auto add = [&](std::int64_t i, std::int64_t j, double share) {
    const auto& texel = texels[static_cast<std::size_t>(j * texture.width(level) + i)];
    for (std::size_t k = 0; k < components; ++k) sample.bump[k] += share * static_cast<double>(texel.bump[k]);
    if (config.decal != 0)
      for (std::size_t k = 0; k < 3; ++k) sample.colour[k] += share * static_cast<double>(texel.colour[k]);
    if (config.gloss_map != 0) sample.gloss += share * static_cast<double>(texel.gloss);
  };
  add(x.first, y.first, weight * (1 - x.fraction) * (1 - y.fraction));
  add(x.second, y.first, weight * x.fraction * (1 - y.fraction));
  add(x.first, y.second, weight * (1 - x.fraction) * y.fraction);
  add(x.second, y.second, weight * x.fraction * y.fraction);
}

// Without a trilinear filter the nearest level. `lod` of any size; clamped to the chain.
inline Sample sample(const Shape& config, const DrawWords& draw, const ExactTexture& texture, Vec2 uv, double lod) {
  Sample result{};
  const double inside = std::clamp(lod, 0.0, static_cast<double>(texture.max_level()));
  const int a = static_cast<int>(config.trilinear != 0 ? inside : inside + 0.5);
  const double fraction = config.trilinear != 0 ? inside - a : 0;
  sample_level(config, draw, texture, a, uv, 1 - fraction, result);
  if (fraction > 0) sample_level(config, draw, texture, a + 1, uv, fraction, result);
  return result;
}

}  // namespace wrinkle::exact

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

// How a texture is filtered, and what of its texels.
struct Filtering {
  bool nearest = false, trilinear = false;
  int wrap_u = 0, wrap_v = 0;  // Wrap
  std::size_t bump_components = 3;
  bool colour = false, gloss = false;
};

inline Filtering filtering(const Shape& config, const DrawWords& draw) {
  return {config.filter == static_cast<int>(Filter::kNearest), config.trilinear != 0, draw.wrap_u,          draw.wrap_v,
          static_cast<std::size_t>(config.bump_components),    config.decal != 0,     config.gloss_map != 0};
}

// A texel, filtered.
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
inline Tap tap(bool nearest, int wrap, double coordinate, int size) {
  const double t = coordinate * size - (nearest ? 0 : 0.5);
  const std::int64_t i = floor_to_integer(t);
  const std::int64_t first = wrap_texel(wrap, i, size);
  return nearest ? Tap{first, first, 0} : Tap{first, wrap_texel(wrap, i + 1, size), t - static_cast<double>(i)};
}

// Adds `weight` times the sample of one mip level.
inline void sample_level(const Filtering& filter, const ExactTexture& texture, int level, Vec2 uv, double weight,
                         Sample& sample) {
  const Tap x = tap(filter.nearest, filter.wrap_u, uv.x, texture.width(level));
  const Tap y = tap(filter.nearest, filter.wrap_v, uv.y, texture.height(level));
  const auto& texels = texture.levels[static_cast<std::size_t>(level)];
  const auto add = [&](std::int64_t i, std::int64_t j, double share) {
    const auto& texel = texels[static_cast<std::size_t>(j * texture.width(level) + i)];
    for (std::size_t k = 0; k < filter.bump_components; ++k)
      sample.bump[k] += share * static_cast<double>(texel.bump[k]);
    if (filter.colour)
      for (std::size_t k = 0; k < 3; ++k) sample.colour[k] += share * static_cast<double>(texel.colour[k]);
    if (filter.gloss) sample.gloss += share * static_cast<double>(texel.gloss);
  };
  add(x.first, y.first, weight * (1 - x.fraction) * (1 - y.fraction));
  add(x.second, y.first, weight * x.fraction * (1 - y.fraction));
  add(x.first, y.second, weight * (1 - x.fraction) * y.fraction);
  add(x.second, y.second, weight * x.fraction * y.fraction);
}

// Without a trilinear filter the nearest level. `lod` of any size; clamped to the chain.
inline Sample sample(const Filtering& filter, const ExactTexture& texture, Vec2 uv, double lod) {
  Sample result{};
  const double inside = std::clamp(lod, 0.0, static_cast<double>(texture.max_level()));
  const int a = static_cast<int>(filter.trilinear ? inside : inside + 0.5);
  const double fraction = filter.trilinear ? inside - a : 0;
  sample_level(filter, texture, a, uv, 1 - fraction, result);
  if (fraction > 0) sample_level(filter, texture, a + 1, uv, fraction, result);
  return result;
}

}  // namespace wrinkle::exact

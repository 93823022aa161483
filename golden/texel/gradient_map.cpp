#include "golden/texel/gradient_map.h"

#include <algorithm>
#include <cmath>

#include "golden/texel/height.h"
#include "golden/texel/normal_map.h"

namespace wrinkle {
namespace {

double largest_slope(const MipChain& slopes) {
  double largest = 0;
  for (const Grid<Vec3>& level : slopes) {
    for (const Vec3& f : level.samples) largest = std::max({largest, std::abs(f.x), std::abs(f.y)});
  }
  return largest;
}

// (fu, fv) of level 0 in x and y.
ExactTexture from_slopes(const ExactTexture& base, Grid<Vec3> level0, int texel_bits) {
  const MipChain slopes = colour_mips(std::move(level0));
  const double largest = largest_slope(slopes), half = std::ldexp(1, texel_bits - 1);
  ExactTexture result = base;
  result.bump_scale = largest > 0 ? largest * half / (half - 1) : 1;
  for (std::size_t l = 0; l < base.levels.size(); ++l) {
    for (std::size_t i = 0; i < base.levels[l].size(); ++i) {
      const Vec3 f = slopes[l].samples[i];
      result.levels[l][i].bump = {static_cast<float>(f.x / result.bump_scale),
                                  static_cast<float>(f.y / result.bump_scale)};
    }
  }
  return result;
}

}  // namespace

ExactTexture gradient_texture(const ExactTexture& base, const Grid<double>& height, int texel_bits, Wraps wraps) {
  const Grid<Vec2> slopes = gradients(height, wraps);
  Grid<Vec3> level0(slopes.width, slopes.height);
  std::transform(slopes.samples.begin(), slopes.samples.end(), level0.samples.begin(), [](Vec2 f) {
    return Vec3{f.x, f.y, 0};
  });
  return from_slopes(base, resample(level0, base.width(0), base.height(0), wraps), texel_bits);
}

ExactTexture gradient_texture(const ExactTexture& base, int texel_bits) {
  Grid<Vec3> level0(base.width(0), base.height(0));
  std::transform(base.levels[0].begin(), base.levels[0].end(), level0.samples.begin(), [](const ExactTexel& texel) {
    const Vec3 n{texel.bump[0], texel.bump[1], texel.bump[2]};
    const double up = std::max(n.z, length(n) / kSteepestSlope);
    return up > 0 ? Vec3{-n.x / up, -n.y / up, 0} : Vec3{};
  });
  return from_slopes(base, std::move(level0), texel_bits);
}

}  // namespace wrinkle

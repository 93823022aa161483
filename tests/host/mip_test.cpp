// Normal maps, resampling and mip chains.
#include <gtest/gtest.h>

#include <algorithm>

#include "golden/texel/bump.h"
#include "golden/texel/height.h"
#include "golden/texel/normal_map.h"
#include "golden/vertex/bezier.h"
#include "golden/vertex/surfaces.h"

namespace wrinkle {
namespace {

TEST(NormalMap, SurfaceMapIsBlinnsNormalInTheFrameOfTheTexel) {
  const Grid<double> height = pinwheel(64, 0.05);
  const auto patch = stretched_patch();
  const NormalMap map = normal_map(height, *patch);
  const SampledHeightField field(height);
  for (int y = 1; y < 64; y += 7) {
    for (int x = 2; x < 64; x += 5) {
      const double u = (x + 0.5) / 64, v = 1 - (y + 0.5) / 64;
      const SurfacePoint s = patch->at(u, v);
      const Vec2 f = field.gradient(u, v);
      const Vec3 T = normalize(s.Pu), n = map.at(x, y);
      const Vec3 in_space = n.x * T + n.y * cross(s.N, T) + n.z * s.N;
      ASSERT_NEAR(length(in_space - perturbed_normal_blinn(s.Pu, s.Pv, f.x, f.y)), 0, 1e-9);
    }
  }
}

TEST(NormalMap, BothFormulasAgreeOnASquarePatch) {
  const Grid<double> height = pinwheel(32, 0.05);
  const Rectangle square({}, {1.7, 0, 0}, {0, 1.7, 0});
  const NormalMap a = normal_map(height, square), b = normal_map(height, 1.7);
  for (std::size_t i = 0; i < a.samples.size(); ++i) ASSERT_NEAR(length(a.samples[i] - b.samples[i]), 0, 1e-12);
}

// A bump in the middle: the normal leans away from it, right of it to the right, above it (smaller row) upwards.
TEST(NormalMap, NormalsLeanAwayFromABump) {
  Grid<double> height(32, 32);
  for (int y = 14; y < 18; ++y) {
    for (int x = 14; x < 18; ++x) height.at(x, y) = 0.1;
  }
  const NormalMap map = normal_map(height, 1);
  EXPECT_GT(map.at(19, 16).x, 0.1);
  EXPECT_LT(map.at(12, 16).x, -0.1);
  EXPECT_GT(map.at(16, 12).y, 0.1);
  EXPECT_LT(map.at(16, 19).y, -0.1);
  EXPECT_EQ(map.at(0, 0), (Vec3{0, 0, 1}));
}

TEST(NormalMap, ImageCodesAndScale) {
  Grid<Vec3> image(2, 1);
  image.at(0, 0) = {1, 0.5, 0.5};
  image.at(1, 0) = {0.75, 0.25, 1};
  const NormalMap plain = normal_map_from_image(image);
  EXPECT_EQ(plain.at(0, 0), (Vec3{1, 0, 0}));
  EXPECT_EQ(plain.at(1, 0), (Vec3{0.5, -0.5, 1}));  // as it is, longer than 1
  const NormalMap scaled = normal_map_from_image(image, 2);
  EXPECT_NEAR(length(scaled.at(1, 0) - normalize(Vec3{1, -1, 1})), 0, 1e-12);
}

TEST(Mip, ChainGoesDownToOneTexel) {
  for (const auto& [w, h, levels] : {std::tuple{8, 8, 4}, {16, 2, 5}, {1, 1, 1}, {1, 8, 4}}) {
    const MipChain chain = normal_mips(NormalMap(w, h, {0, 0, 1}));
    ASSERT_EQ(chain.size(), static_cast<std::size_t>(levels));
    for (std::size_t l = 0; l < chain.size(); ++l) {
      EXPECT_EQ(chain[l].width, std::max(w >> l, 1));
      EXPECT_EQ(chain[l].height, std::max(h >> l, 1));
    }
  }
}

TEST(Mip, ConstantMapStaysConstant) {
  const Vec3 n = normalize({0.3, -0.2, 0.9});
  for (const Grid<Vec3>& level : normal_mips(NormalMap(16, 4, n))) {
    for (const Vec3& m : level.samples) EXPECT_NEAR(length(m - n), 0, 1e-12);
  }
  for (const Grid<Vec3>& level : colour_mips(Grid<Vec3>(16, 4, {0.25, 0.5, 0.75}))) {
    for (const Vec3& c : level.samples) EXPECT_EQ(c, (Vec3{0.25, 0.5, 0.75}));
  }
  for (const Grid<Vec3>& level : normal_mips(Grid<double>(16, 16, 3.5), 2.0)) {
    for (const Vec3& m : level.samples) EXPECT_NEAR(length(m - Vec3{0, 0, 1}), 0, 1e-12);
  }
}

TEST(Mip, FilteredLevelsAreMeansMadeUnit) {
  NormalMap map(2, 2);
  map.samples = {normalize({1, 0, 1}), normalize({0, 1, 1}), {0, 0, 1}, normalize({1, 1, 1})};
  const MipChain chain = normal_mips(map);
  const Vec3 sum = map.samples[0] + map.samples[1] + map.samples[2] + map.samples[3];
  EXPECT_EQ(chain[0].samples, map.samples);
  EXPECT_NEAR(length(chain[1].at(0, 0) - normalize(sum)), 0, 1e-12);
}

TEST(Mip, OpposedTexelsAverageToZeroNotToNaN) {
  NormalMap map(2, 1);
  map.samples = {{1, 0, 0}, {-1, 0, 0}};
  EXPECT_EQ(normal_mips(map)[1].at(0, 0), (Vec3{}));
}

// A slope stays the same slope at every level when the heights are filtered.
TEST(Mip, HeightChainKeepsASlope) {
  Grid<double> height(64, 64);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) height.at(x, y) = 0.5 * (x + 0.5) / 64;
  }
  const MipChain chain = normal_mips(height, 1.0);
  ASSERT_EQ(chain.size(), 7u);
  const Vec3 want = normalize({-0.5, 0, 1});
  for (std::size_t l = 0; l < 3; ++l) {  // coarser levels feel the seam everywhere
    EXPECT_NEAR(length(chain[l].at(chain[l].width / 2, chain[l].height / 2) - want), 0, 1e-12);
  }
}

TEST(Mip, BothChainsHaveTheSameFinestLevelAndFlattenAlike) {
  const Grid<double> height = pinwheel(64, 0.01);
  const auto patch = stretched_patch();
  const MipChain a = normal_mips(normal_map(height, *patch)), b = normal_mips(height, *patch);
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(a[0].samples, b[0].samples);
  EXPECT_NE(a[2].samples, b[2].samples);
  double worst = 0;
  for (std::size_t i = 0; i < a[2].samples.size(); ++i)
    worst = std::max(worst, length(a[2].samples[i] - b[2].samples[i]));
  EXPECT_LT(worst, 0.5);
}

TEST(Resample, PowersOfTwoAreUntouched) {
  Grid<double> grid(4, 2);
  for (std::size_t i = 0; i < 8; ++i) grid.samples[i] = static_cast<double>(i);
  EXPECT_EQ(resample_to_power_of_two(grid).samples, grid.samples);
}

TEST(Resample, NextPowerOfTwoKeepsConstantsAndMeans) {
  const Grid<double> constant = resample_to_power_of_two(Grid<double>(5, 3, 0.7));
  ASSERT_EQ(constant.width, 8);
  ASSERT_EQ(constant.height, 4);
  for (const double x : constant.samples) EXPECT_NEAR(x, 0.7, 1e-15);

  Grid<double> ramp(6, 1);
  for (int x = 0; x < 6; ++x) ramp.at(x, 0) = x + 0.5;
  const Grid<double> finer = resample(ramp, 8, 1);
  for (int x = 1; x < 7; ++x) EXPECT_NEAR(finer.at(x, 0), (x + 0.5) * 6 / 8, 1e-12);
}

TEST(Resample, ReductionIsTheMeanOfTheArea) {
  Grid<double> grid(6, 1);
  grid.samples = {1, 2, 3, 4, 5, 6};
  const Grid<double> four = resample(grid, 4, 1);
  EXPECT_NEAR(four.at(0, 0), (1 + 0.5 * 2) / 1.5, 1e-12);
  EXPECT_NEAR(four.at(1, 0), (0.5 * 2 + 3) / 1.5, 1e-12);
  const Grid<double> huge = resample_to_power_of_two(Grid<double>(9000, 1, 0.25));
  EXPECT_EQ(huge.width, 4096);
  for (const double x : huge.samples) EXPECT_NEAR(x, 0.25, 1e-12);
}

}  // namespace
}  // namespace wrinkle

// NormalTangentTest: fifteen pairs of real geometry and a normal-mapped quad that must look alike.
#include <algorithm>
#include <cmath>

#include "golden/vertex/camera.h"
#include "golden/vertex/transform.h"
#include "sim/scene/scene_reader.h"
#include "tests/oracle/procedures.h"

namespace wrinkle {
namespace {

constexpr const char* kModel = "gltf/NormalTangentTest/glTF/NormalTangentTest.gltf";
constexpr int kSize = 1024;
constexpr double kPixelsPerUnit = 400;
constexpr int kPairDistance = 128;  // 0.32 units
constexpr int kInner = 112;

// Orthographic along -z, 400 pixels a unit.
Scene pairs_scene(Vec3 light) {
  Scene scene = read_scene(asset(kModel));
  scene.width = scene.height = kSize;
  scene.camera = {};
  scene.camera.half_height = kSize / kPixelsPerUnit / 2;
  scene.camera.world_to_eye = look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0});
  scene.light = {light, true};
  scene.viewer_at_infinity = true;
  return scene;
}

// RMS of the difference of clamped N.L over the inner square of the cell centred at (x, y) and its right neighbour.
double pair_difference(const DotPicture& picture, double x, double y) {
  const int left = static_cast<int>(std::lround(kSize / 2 + x * kPixelsPerUnit)) - kInner / 2;
  const int top = static_cast<int>(std::lround(kSize / 2 - y * kPixelsPerUnit)) - kInner / 2;
  double sum = 0;
  for (int row = top; row < top + kInner; ++row) {
    for (int column = left; column < left + kInner; ++column) {
      const auto at = [&](int c) {
        return std::max(picture.nl[static_cast<std::size_t>(row) * kSize + static_cast<std::size_t>(c)], 0.0);
      };
      const double d = at(column) - at(column + kPairDistance);
      sum += d * d;
    }
  }
  return std::sqrt(sum / (kInner * kInner));
}

double worst_pair(const DotPicture& picture) {
  double worst = 0;
  for (double x : {-.96, -.16, .64})
    for (double y : {.8, .4, 0.0, -.4, -.8}) worst = std::max(worst, pair_difference(picture, x, y));
  return worst;
}

class Pairs : public testing::TestWithParam<Vec3> {};

TEST_P(Pairs, GeometryAndMapLookAlike) {
  WRINKLE_NEEDS_ASSET(kModel);
  const Config config = load_config("standard");
  const Frame frame = build_frame(config, pairs_scene(GetParam()));
  const double exact = worst_pair(draw_exact_dots(config, frame));
  const double golden = worst_pair(draw_golden_dots(config, frame));
  std::printf("worst RMS of a pair: exact %.4f, golden %.4f\n", exact, golden);
  EXPECT_LE(exact, .02);
  EXPECT_LE(golden, .02);
}

INSTANTIATE_TEST_SUITE_P(Lights, Pairs,
                         testing::Values(Vec3{.5, .3, .8}, Vec3{-.4, .6, .7}, Vec3{.1, -.7, .7}, Vec3{-.6, -.2, .77}));

TEST(Pairs, FlippedGreenIsSeen) {
  WRINKLE_NEEDS_ASSET(kModel);
  const Config config = load_config("standard");
  Frame frame = build_frame(config, pairs_scene({.5, .3, .8}));
  for (ExactTexture& texture : frame.exact_textures)
    for (auto& level : texture.levels)
      for (auto& texel : level) texel.bump[1] = -texel.bump[1];
  EXPECT_GE(worst_pair(draw_exact_dots(config, frame)), .1);
}

// The whole model is mirrored in x, and so is the light: the picture is the same, flipped.
TEST(Mirror, E29_MirroredModelGivesMirroredPicture) {
  WRINKLE_NEEDS_ASSET(kModel);
  const Config config = load_config("extreme");
  const Scene scene = pairs_scene({.5, .3, .8});
  Scene mirrored = pairs_scene({-.5, .3, .8});
  for (Object& object : mirrored.objects) object.to_world = scaling({-1, 1, 1}) * object.to_world;
  const DotPicture a = draw_exact_dots(config, build_frame(config, scene));
  const DotPicture b = draw_exact_dots(config, build_frame(config, mirrored));
  double worst = 0;
  std::size_t covered = 0, different = 0;
  for (std::size_t y = 0; y < kSize; ++y) {
    for (std::size_t x = 0; x < kSize; ++x) {
      const std::size_t i = y * kSize + x, j = y * kSize + kSize - 1 - x;
      different += (a.triangle[i] != 0) != (b.triangle[j] != 0);
      if (a.triangle[i] == 0 || b.triangle[j] == 0) continue;
      ++covered;
      worst = std::max(worst, std::abs(a.nl[i] - b.nl[j]));
    }
  }
  std::printf("%zu pixels, coverage differs in %zu, N.L by at most %.2g\n", covered, different, worst);
  EXPECT_GT(covered, 100000u);
  EXPECT_EQ(different, 0u);
  EXPECT_LE(worst, 1e-4);
}

}  // namespace
}  // namespace wrinkle

// The vertex rate prepares bumps so that they are lit on the right side, also in a mirror and from behind, and as the
// ideal picture has them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>

#include "golden/texel/height.h"
#include "golden/vertex/bezier.h"
#include "golden/vertex/camera.h"
#include "golden/vertex/tessellate.h"
#include "golden/vertex/transform.h"
#include "tests/host/frames.h"

namespace wrinkle {
namespace {

using namespace test;

// Bumps pushed out of a rectangle are lit on the side that faces the light, whichever way the image is turned.
TEST(Frame, BumpIsLitOnTheSideOfTheLight) {
  Grid<double> height(64, 64);
  for (int y = 24; y < 40; ++y) {
    for (int x = 24; x < 40; ++x) height.at(x, y) = 0.05;
  }
  struct Case {
    Vec3 light;
    int x, y;  // pixel on the side of the bump that faces it, from the centre
  };
  for (const Case& c : {Case{{1, 0, 1}, 15, 0}, {{-1, 0, 1}, -16, 0}, {{0, 1, 1}, 0, -16}, {{0, -1, 1}, 0, 15}}) {
    for (const bool mirror : {false, true}) {
      Object object = bumped(tessellate(make_rectangle(), 1, 1), normal_map(height, 1.0));
      object.to_world = scaling({mirror ? -1.8 : 1.8, 1.8, 1.8});
      Scene scene = scene_of(object);
      scene.light.position = c.light;
      const std::vector<double> image = draw({}, scene);
      const auto at = [&](int x, int y) {
        return image[static_cast<std::size_t>((kSize / 2 + y) * kSize + kSize / 2 + x)];
      };
      const double flat = std::numbers::sqrt2 / 2;
      // The sides of the bump are 8/64 of 1.8 from the centre: 14.4 pixels.
      EXPECT_GT(at(c.x, c.y), flat + 0.1);
      EXPECT_LT(at(-c.x - (c.x != 0 ? 1 : 0), -c.y - (c.y != 0 ? 1 : 0)), flat - 0.1);
      EXPECT_NEAR(at(0, 0), flat, 0.02);
      EXPECT_NEAR(at(40, 40), flat, 0.02);
    }
  }
}

// The RMS difference of N.L from that of Blinn's normal, with the paper's patch in divisions^2 x 2 triangles.
double method_error(double amplitude, int divisions) {
  const Grid<double> height = pinwheel(256, amplitude);
  const auto patch = stretched_patch();
  Object object = bumped(tessellate({patch}, divisions, divisions), normal_map(height, *patch));
  object.height = std::make_shared<SampledHeightField>(height);
  Scene scene = scene_of(std::move(object));
  scene.width = scene.height = 256;
  const Frame frame = build_frame(Config(), scene);
  std::map<std::pair<int, int>, double> exact;
  draw_exact({}, frame, [&](const ExactFragment& f) { exact[{f.x, f.y}] = f.nl; });
  double sum = 0;
  draw_ideal({}, frame, [&](const ExactFragment& f) {
    const double difference = f.nl - exact.at({f.x, f.y});
    sum += difference * difference;
  });
  return std::sqrt(sum / static_cast<double>(exact.size()));
}

// The vectors interpolated over triangles approach those of the surface as the square of the triangles' size. Under a
// bump map the filtering of the texture, which the ideal picture does not have, remains.
TEST(Frame, TangentSpaceApproachesTheIdeal) {
  const double smooth = method_error(0, 8), finer = method_error(0, 16);
  const double coarse_bumps = method_error(0.02, 2), bumps = method_error(0.02, 8),
               finer_bumps = method_error(0.02, 32);
  std::printf(
      "RMS of N.L against the ideal: smooth %.5f (8 x 8 x 2), %.5f (16 x 16 x 2); bumps %.4f (2 x 2 x 2), "
      "%.4f (8 x 8 x 2), %.4f (32 x 32 x 2)\n",
      smooth, finer, coarse_bumps, bumps, finer_bumps);
  EXPECT_LT(finer, 0.3 * smooth);
  EXPECT_LT(bumps, 0.02);
  EXPECT_LT(bumps, coarse_bumps);
  EXPECT_LT(finer_bumps, bumps);
}

// Scaling x by -1 and reversing the winding, light mirrored too: the mirror image, pixel by pixel [extremes 29].
TEST(Frame, Extreme29MirrorImage) {
  const Grid<double> height = pinwheel(64, 0.03);
  const auto patch = stretched_patch();
  const Mesh mesh = tessellate({patch});
  Mesh mirrored = mesh;
  mirrored.surfaces.clear();
  mirrored.triangle_surface.clear();
  for (Vertex& v : mirrored.vertices) {
    v.P.x = -v.P.x, v.N.x = -v.N.x, v.T.x = -v.T.x;
    v.sign = -v.sign;
  }
  for (auto& t : mirrored.triangles) std::swap(t[1], t[2]);
  Object by_matrix = bumped(mesh, normal_map(height, *patch));
  by_matrix.to_world = scaling({-1, 1, 1});

  Scene scene = scene_of(bumped(mesh, normal_map(height, *patch)));
  // Off the grid, so that no pixel centre lies on an edge: the fill rule is not symmetric.
  const double off = 0.3 / 256 * 2 / kSize;
  scene.camera.world_to_eye = translation({off, 0, -5});
  const std::vector<double> original = draw({}, scene);
  for (const Object& object : {bumped(mirrored, normal_map(height, *patch)), by_matrix}) {
    Scene other = scene_of(object);
    other.light.position.x = -other.light.position.x;
    other.camera.world_to_eye = translation({-off, 0, -5});
    const std::vector<double> image = draw({}, other);
    int covered_differently = 0;
    double worst = 0;
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        const double a = original[static_cast<std::size_t>(y * kSize + x)];
        const double b = image[static_cast<std::size_t>(y * kSize + kSize - 1 - x)];
        covered_differently += (a < 0) != (b < 0) ? 1 : 0;
        if (a >= 0 && b >= 0) worst = std::max(worst, std::abs(a - b));
      }
    }
    EXPECT_EQ(covered_differently, 0);
    EXPECT_LT(worst, 1e-4);
  }
}

// From behind, the perturbed normal is the opposite of that of the front: the frame is turned round as a whole.
TEST(Frame, BackOfABumpIsADent) {
  Grid<double> height(64, 64);
  for (int y = 24; y < 40; ++y) {
    for (int x = 24; x < 40; ++x) height.at(x, y) = 0.05;
  }
  Object object = bumped(tessellate(make_rectangle(), 1, 1), normal_map(height, 1.0));
  object.double_sided = true;
  object.to_world = rotation({0, 1, 0}, std::numbers::pi) * scaling({1.8, 1.8, 1.8});
  Scene scene = scene_of(object);
  scene.light.position = {1, 0, 1};
  const std::vector<double> image = draw({}, scene);
  const auto at = [&](int x) { return image[static_cast<std::size_t>(kSize / 2 * kSize + kSize / 2 + x)]; };
  EXPECT_NEAR(at(0), std::numbers::sqrt2 / 2, 0.02);
  EXPECT_LT(at(15), at(0) - 0.1);
  EXPECT_GT(at(-16), at(0) + 0.1);
}

// The ideal picture shows the same side and the same bumps: plain, in a mirror, from behind, and both.
TEST(Frame, IdealSeesMirroredAndBackSidesAsTheDatapathDoes) {
  const Grid<double> height = pinwheel(256, 0.02);
  const auto patch = stretched_patch();
  for (const bool mirror : {false, true}) {
    for (const bool back : {false, true}) {
      Object object = bumped(tessellate({patch}, 16, 16), normal_map(height, *patch));
      object.height = std::make_shared<SampledHeightField>(height);
      object.double_sided = true;
      object.to_world = rotation({0, 1, 0}, back ? std::numbers::pi : 0) * scaling({mirror ? -1.0 : 1.0, 1, 1});
      Scene scene = scene_of(std::move(object));
      scene.width = scene.height = 256;
      const Frame frame = build_frame(Config(), scene);
      std::map<std::pair<int, int>, double> exact;
      draw_exact({}, frame, [&](const ExactFragment& f) { exact[{f.x, f.y}] = f.nl; });
      double sum = 0;
      draw_ideal({}, frame, [&](const ExactFragment& f) { sum += std::pow(f.nl - exact.at({f.x, f.y}), 2); });
      ASSERT_GT(exact.size(), 10000u);
      EXPECT_LT(std::sqrt(sum / static_cast<double>(exact.size())), 0.02) << mirror << back;
    }
  }
}

}  // namespace
}  // namespace wrinkle

// Which triangles the vertex rate hands on, and where they come to lie.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <numbers>
#include <random>

#include "golden/vertex/surfaces.h"
#include "golden/vertex/tessellate.h"
#include "golden/vertex/transform.h"
#include "tests/host/frames.h"

namespace wrinkle {
namespace {

using namespace test;

TEST(Frame, ProjectsAndSnapsToTheGrid) {
  const Config config;
  Scene scene = scene_of(object_of(tessellate(make_rectangle(), 1, 1)));
  scene.camera.near = 1, scene.camera.far = 9;
  const Frame frame = build_frame(config, scene);
  ASSERT_EQ(frame.draws.size(), 1u);
  ASSERT_EQ(frame.draws[0].triangles.size(), 2u);
  for (const ScreenTriangle& t : frame.draws[0].triangles) {
    for (const ScreenVertex& v : t.v) {
      EXPECT_EQ(v.x, (kSize / 2 + (v.P.x > 0 ? 1 : -1) * kSize / 4) << config.subpixel_bits);
      EXPECT_EQ(v.y, (kSize / 2 - (v.P.y > 0 ? 1 : -1) * kSize / 4) << config.subpixel_bits);  // y down
      EXPECT_EQ(v.z, 0.5);
      EXPECT_EQ(v.q, 1);
    }
  }
  scene.camera.world_to_eye = translation({0.49 / 256 * 2 / kSize, 0.51 / 256 * 2 / kSize, -5});
  const Frame moved = build_frame(config, scene);
  ASSERT_EQ(moved.draws[0].triangles.size(), 2u);
  EXPECT_EQ(moved.draws[0].triangles[0].v[0].x, frame.draws[0].triangles[0].v[0].x);
  EXPECT_EQ(moved.draws[0].triangles[0].v[0].y, frame.draws[0].triangles[0].v[0].y - 1);
}

TEST(Frame, CullsBacksUnlessDoubleSided) {
  Scene scene = scene_of(object_of(tessellate(make_cube(), 1, 1)));
  EXPECT_EQ(build_frame(Config(), scene).draws[0].triangles.size(), 2u);
  scene.objects[0].double_sided = true;
  const Frame both = build_frame(Config(), scene);
  EXPECT_EQ(both.draws[0].triangles.size(), 4u);  // the four sides are seen edge-on
  for (const ScreenTriangle& t : both.draws[0].triangles) {
    EXPECT_GT(t.v[0].N.z, 0.99);  // the back's normals are turned to the viewer
    EXPECT_GT(t.surface->at(0.5, 0.5).N.z, 0.99);
  }
}

// An id is the number of a triangle in the mesh, so triangles that are culled count too.
TEST(Frame, CountsTrianglesOverTheFrame) {
  Scene scene = scene_of(object_of(tessellate(make_cube(), 1, 1)));
  scene.objects[0].to_world = rotation({1, 0, 0}, std::numbers::pi / 2);  // the lid, face 4, to the front
  scene.objects.push_back(scene.objects[0]);
  const Frame frame = build_frame(Config(), scene);
  ASSERT_EQ(frame.draws[0].triangles.size(), 2u);
  ASSERT_EQ(frame.draws[1].triangles.size(), 2u);
  EXPECT_EQ(frame.draws[0].triangles[0].id, 8u);
  EXPECT_EQ(frame.draws[0].triangles[1].id, 9u);
  EXPECT_EQ(frame.draws[1].triangles[0].id, 12u + 8u);
}

// These triangles are as small as the sub-pixel grid. Snapping flattens some and turns some over; all that are left
// have the winding that they had.
TEST(Frame, SnappingTurnsNothingOver) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> position(-2.0 / kSize / 256, 2.0 / kSize / 256);
  Mesh mesh;
  for (std::uint32_t i = 0; i < 3000; ++i) {
    Vertex v;
    v.P = {position(random), position(random), 0};
    v.N = {0, 0, 1}, v.T = {1, 0, 0};
    mesh.vertices.push_back(v);
    if (i % 3 == 2) mesh.triangles.push_back({i - 2, i - 1, i});
  }
  const Frame frame = build_frame(Config(), scene_of(object_of(mesh)));
  EXPECT_GT(frame.draws[0].triangles.size(), 100u);
  EXPECT_LT(frame.draws[0].triangles.size(), 500u);  // half face away
  for (const ScreenTriangle& t : frame.draws[0].triangles) {
    const auto &a = t.v[0], &b = t.v[1], &c = t.v[2];
    ASSERT_LT((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y), 0);
  }
}

TEST(Frame, AMirroringMatrixDrawsTheSameSide) {
  Object object = object_of(tessellate({std::make_shared<Sphere>(0.8)}, 16, 16));
  const Frame plain = build_frame(Config(), scene_of(object));
  object.to_world = scaling({-1, 1, 1});
  const Frame mirrored = build_frame(Config(), scene_of(object));
  EXPECT_EQ(plain.draws[0].triangles.size(), mirrored.draws[0].triangles.size());
  for (const ScreenTriangle& t : mirrored.draws[0].triangles) {
    for (const ScreenVertex& v : t.v) {
      EXPECT_NEAR(length(v.N - normalize(v.P)), 0, 1e-9);
      EXPECT_LT(length(t.surface->at(v.parameter.x, v.parameter.y).P - v.P), 1e-12);
    }
  }
}

// A closed mesh in front of the camera draws no pixel twice and leaves no hole.
TEST(Frame, WatertightWholeAndClipped) {
  for (const double half_height : {1.0, 0.004}) {  // the second: most corners are far outside the guard band
    Scene scene = scene_of(object_of(tessellate({std::make_shared<Sphere>(0.9)}, 24, 24)));
    scene.camera.half_height = half_height;
    Config config;
    config.screen_bits = 7;
    const std::vector<double> image = draw(config, scene);
    EXPECT_EQ(std::count(image.begin(), image.end(), -2), 0);
    for (int y = 0; y < kSize; ++y) {
      int runs = 0;
      for (int x = 0; x < kSize; ++x) {
        const auto at = [&](int column) {
          return column >= 0 && image[static_cast<std::size_t>(y * kSize + column)] > -1;
        };
        runs += at(x) && !at(x - 1) ? 1 : 0;
      }
      ASSERT_LE(runs, 1) << "row " << y;
    }
    EXPECT_GT(std::count_if(image.begin(), image.end(), [](double v) { return v >= 0; }), kSize * kSize / 2);
  }
}

TEST(Frame, GuardBandHoldsWhateverIsThere) {
  Scene scene = scene_of(object_of(tessellate(make_floor(1e6, 1e6), 4, 4)));
  scene.camera.perspective = true;
  scene.camera.world_to_eye = look_at({0, 0.3, 0}, {0, 0, -10}, {0, 1, 0});
  scene.camera.near = 0.01, scene.camera.far = 1e7;
  const Config config;
  const Frame frame = build_frame(config, scene);
  ASSERT_FALSE(frame.draws[0].triangles.empty());
  const int unit = config.screen_size() << config.subpixel_bits;
  for (const ScreenTriangle& t : frame.draws[0].triangles) {
    for (const ScreenVertex& v : t.v) {
      EXPECT_TRUE(v.x >= -unit && v.x < 2 * unit && v.y >= -unit && v.y < 2 * unit);
      EXPECT_TRUE(v.q > 0 && v.q <= 1 / 0.01 * (1 + 1e-6) && v.z >= 0 && v.z <= 1);
      EXPECT_LE(length(v.L), 1 + 1e-12);
    }
  }
  const std::vector<double> image = draw(config, scene);
  EXPECT_EQ(std::count(image.begin(), image.end(), -2), 0);
  for (int x = 0; x < kSize; ++x) EXPECT_GT(image[static_cast<std::size_t>((kSize - 1) * kSize + x)], 0);
}

TEST(Frame, AHundredThousandTrianglesTakeLessThanASecond) {
  const Scene scene = scene_of(object_of(tessellate({std::make_shared<Torus>(0.6, 0.3)}, 256, 200)));
  const auto start = std::chrono::steady_clock::now();
  const Frame frame = build_frame(Config(), scene);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::printf("102400 triangles, %zu in sight: %.3f s\n", frame.draws[0].triangles.size(), seconds);
  EXPECT_GT(frame.draws[0].triangles.size(), 30000u);
#ifdef NDEBUG
  EXPECT_LT(seconds, 1);
#endif
}

}  // namespace
}  // namespace wrinkle

// What the corners of a frame carry: frames, lights, viewers, textures.
#include <gtest/gtest.h>

#include <cmath>

#include "golden/datapath/datapaths.h"
#include "golden/vertex/shading.h"
#include "golden/vertex/teapot.h"
#include "golden/vertex/tessellate.h"
#include "golden/vertex/transform.h"
#include "tests/host/frames.h"

namespace wrinkle {
namespace {

using namespace test;

// A vertex without a usable tangent still has a frame [extremes 30].
TEST(Frame, Extreme30NoTangent) {
  for (const Vec3 T : {Vec3{}, Vec3{0, 0, 1}, Vec3{0, 0, -1}}) {
    const TangentFrame f = tangent_frame({{}, {0, 0, 1}, T, 1, {}, {}}, {});
    EXPECT_NEAR(length(f.T), 1, 1e-12);
    EXPECT_NEAR(dot(f.T, f.N), 0, 1e-12);
    EXPECT_NEAR(dot(cross(f.N, f.T), f.B), 1, 1e-12);
  }
}

// Eq. 7: the rotation keeps lengths and angles; N of the surface becomes (0, 0, 1).
TEST(Frame, TangentSpaceIsARotation) {
  Scene scene = scene_of(bumped(tessellate(teapot(), 4, 4), NormalMap(1, 1, {0, 0, 1})));
  scene.light = {{1, 2, 3}, false};
  scene.viewer_at_infinity = false;
  const Frame tangent = build_frame(Config(), scene);
  scene.objects[0].space = ShadingSpace::kWorld;
  const Frame world = build_frame(Config(), scene);
  ASSERT_TRUE(tangent.draws[0].state.bump);
  ASSERT_FALSE(world.draws[0].state.bump);
  const auto& a = tangent.draws[0].triangles;
  const auto& b = world.draws[0].triangles;
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const ScreenVertex &t = a[i].v[k], &w = b[i].v[k];
      ASSERT_EQ(t.N, (Vec3{0, 0, 1}));
      ASSERT_NEAR(t.L.z, dot(w.L, w.N), 1e-12);
      ASSERT_NEAR(t.H.z, dot(w.H, w.N), 1e-12);
      ASSERT_NEAR(dot(t.L, t.H), dot(w.L, w.H), 1e-12);
      ASSERT_NEAR(length(t.L), 1, 1e-12);
    }
  }
}

TEST(Frame, FramesAreOrthonormalUnderAnyMatrix) {
  for (const double flip : {1.0, -1.0}) {
    const Mat4 m = rotation({1, 2, 3}, 1) * scaling({flip * 3, 0.2, 1});
    for (const Vertex& v : tessellate(teapot(), 3, 3).vertices) {
      const TangentFrame f = tangent_frame(v, m);
      ASSERT_NEAR(length(f.T), 1, 1e-9);
      ASSERT_NEAR(length(f.B), 1, 1e-9);
      ASSERT_NEAR(dot(f.T, f.B), 0, 1e-9);
      ASSERT_NEAR(dot(f.T, f.N), 0, 1e-9);
      ASSERT_NEAR(dot(f.B, f.N), 0, 1e-9);
      ASSERT_NEAR(dot(cross(f.N, f.T), f.B), flip, 1e-9);
      // B points up in the image, along the image of the surface's B.
      ASSERT_GT(dot(f.B, transform_direction(m, cross(v.N, v.T))), 0);
    }
  }
}

TEST(Frame, LightAndViewerNearAndFar) {
  Scene scene = scene_of(object_of(tessellate(make_rectangle(), 1, 1)));
  scene.camera.perspective = true;
  for (const bool light_far : {true, false}) {
    for (const bool viewer_far : {true, false}) {
      scene.light = {{0, 3, 4}, light_far};
      scene.viewer_at_infinity = viewer_far;
      const Frame frame = build_frame(Config(), scene);
      EXPECT_EQ(frame.ideal.eye_at_infinity, viewer_far);
      EXPECT_EQ(frame.ideal.light_at_infinity, light_far);
      ASSERT_FALSE(frame.draws[0].triangles.empty());
      const ScreenVertex& v = frame.draws[0].triangles[0].v[0];
      const Vec3 L = normalize(light_far ? Vec3{0, 3, 4} : Vec3{0, 3, 4} - v.P);
      const Vec3 V = viewer_far ? Vec3{0, 0, 1} : normalize(Vec3{0, 0, 5} - v.P);
      EXPECT_NEAR(length(v.L - L), 0, 1e-12);
      EXPECT_NEAR(length(v.H - normalize(L + V)), 0, 1e-12);
    }
  }
}

TEST(Frame, LightInAVertexGivesZeroNotNaN) {
  Scene scene = scene_of(object_of(tessellate(make_rectangle(), 2, 2)));
  scene.light = {{0, 0, 0}, false};
  const Frame frame = build_frame(Config(), scene);
  int zero = 0;
  for (const ScreenTriangle& t : frame.draws[0].triangles) {
    for (const ScreenVertex& v : t.v) {
      EXPECT_TRUE(std::isfinite(v.L.x + v.L.y + v.L.z + v.H.x + v.H.y + v.H.z));
      zero += v.L == Vec3{} ? 1 : 0;
    }
  }
  EXPECT_EQ(zero, 6);  // triangles around the centre
}

TEST(Frame, TexturesAreSharedAndFollowTheConfiguration) {
  Scene scene = scene_of(bumped(tessellate(make_rectangle(), 1, 1), NormalMap(4, 4, {0, 0, 1})));
  scene.objects.push_back(scene.objects[0]);                               // the same texture
  scene.objects.push_back(object_of(tessellate(make_rectangle(), 1, 1)));  // none
  scene.objects.push_back(bumped(tessellate(make_rectangle(), 1, 1), NormalMap(2, 2, {0, 0, 1})));
  scene.objects[3].space = ShadingSpace::kWorld;  // one that only a decal would need
  Config config;
  const Frame bump = build_frame(config, scene);
  EXPECT_EQ(bump.textures.size(), 1u);
  EXPECT_EQ(bump.exact_textures.size(), 1u);
  EXPECT_TRUE(bump.draws[0].state.bump && bump.draws[0].state.textured && bump.draws[1].state.bump);
  EXPECT_FALSE(bump.draws[2].state.bump || bump.draws[2].state.textured);
  EXPECT_FALSE(bump.draws[3].state.bump || bump.draws[3].state.textured);

  config.decal = 1;
  const Frame decal = build_frame(config, scene);
  EXPECT_EQ(decal.textures.size(), 2u);
  EXPECT_FALSE(decal.draws[2].state.textured);
  EXPECT_TRUE(decal.draws[3].state.textured);
  EXPECT_EQ(decal.draws[3].state.texture, 1);
  EXPECT_FALSE(decal.draws[3].state.bump);

  config = {};
  config.datapath = static_cast<int>(Datapath::kPhong);
  const Frame phong = build_frame(config, scene);  // falls back to world space
  EXPECT_TRUE(phong.textures.empty());
  EXPECT_FALSE(phong.draws[0].state.bump || phong.draws[0].state.textured);
  EXPECT_NEAR(length(phong.draws[0].triangles[0].v[0].L - normalize(Vec3{0.3, 0.4, 1})), 0, 1e-12);
}

}  // namespace
}  // namespace wrinkle

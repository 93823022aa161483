// Cameras and transforms.
#include "golden/vertex/camera.h"

#include <gtest/gtest.h>

#include <numbers>

#include "golden/vertex/transform.h"

namespace wrinkle {
namespace {

void expect_near(Vec3 a, Vec3 b, double tolerance = 1e-12) { EXPECT_LE(length(a - b), tolerance); }

TEST(Camera, LookAtPutsTheTargetOnTheAxisAndUpUpwards) {
  const Vec3 eye{3, 4, 5}, target{-1, 2, 0};
  const Mat4 m = look_at(eye, target, {0, 1, 0});
  expect_near(transform_point(m, eye), {});
  expect_near(transform_point(m, target), {0, 0, -length(eye - target)});
  EXPECT_GT(transform_direction(m, {0, 1, 0}).y, 0);
  EXPECT_NEAR(transform_direction(m, {0, 1, 0}).x, 0, 1e-12);
  EXPECT_NEAR(determinant3(m), 1, 1e-12);
}

TEST(Camera, LookStraightDownIsDefined) {
  const Mat4 m = look_at({0, 5, 0}, {}, {0, 1, 0});
  EXPECT_NEAR(determinant3(m), 1, 1e-12);
  expect_near(transform_point(m, {}), {0, 0, -5});
}

TEST(Camera, EyeAndViewDirection) {
  Camera camera;
  camera.world_to_eye = look_at({3, 4, 5}, {-1, 2, 0}, {0, 1, 0});
  expect_near(eye_position(camera), {3, 4, 5});
  expect_near(viewer_direction(camera), normalize(Vec3{4, 2, 5}));
}

TEST(Camera, Orthographic) {
  Camera camera;
  camera.world_to_eye = look_at({0, 0, 10}, {}, {0, 1, 0});
  camera.half_height = 2;
  camera.near = 1, camera.far = 21;
  const Projection project(camera, 640, 480);
  const ScreenPoint centre = project({0, 0, 0}), corner = project({1, 2, -1});
  EXPECT_DOUBLE_EQ(centre.x, 320);
  EXPECT_DOUBLE_EQ(centre.y, 240);
  EXPECT_DOUBLE_EQ(centre.w, 1);
  EXPECT_DOUBLE_EQ(centre.z, 0.45);  // 10 from the eye, between 1 and 21
  EXPECT_DOUBLE_EQ(corner.x, 320 + 120);
  EXPECT_DOUBLE_EQ(corner.y, 0);  // the top row
  EXPECT_DOUBLE_EQ(corner.z, 0.5);
}

TEST(Camera, Perspective) {
  Camera camera;
  camera.perspective = true;
  camera.world_to_eye = look_at({0, 0, 10}, {}, {0, 1, 0});
  camera.half_height = std::tan(std::numbers::pi / 8);  // 45 degrees
  camera.near = 2, camera.far = 50;
  const Projection project(camera, 512, 512);
  const ScreenPoint p = project({0, 4 * camera.half_height, 6});  // 4 from the eye, at the upper edge
  EXPECT_NEAR(p.w, 4, 1e-12);
  EXPECT_NEAR(p.x / p.w, 256, 1e-9);
  EXPECT_NEAR(p.y / p.w, 0, 1e-9);
  const auto depth = [&](double distance) {
    const ScreenPoint q = project({0, 0, 10 - distance});
    return q.z / q.w;
  };
  EXPECT_NEAR(depth(2), 0, 1e-12);
  EXPECT_NEAR(depth(50), 1, 1e-12);
  EXPECT_LT(depth(3), depth(4));
}

TEST(Transform, InverseUndoes) {
  const Mat4 m = translation({1, 2, 3}) * rotation({1, -2, 0.5}, 1.1) * scaling({2, 0.5, -3});
  const Mat4 one = m * affine_inverse(m);
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) EXPECT_NEAR(one(i, j), i == j ? 1 : 0, 1e-12);
  }
  EXPECT_NEAR(determinant3(m), -3, 1e-12);
}

TEST(Transform, RotationIsCounterClockwise) {
  expect_near(transform_direction(rotation({0, 0, 2}, std::numbers::pi / 2), {1, 0, 0}), {0, 1, 0});
  expect_near(transform_direction(rotation({0, 3, 0}, std::numbers::pi / 2), {0, 0, 1}), {1, 0, 0});
}

// Under any matrix a normal stays at right angles to its surface, and on the same side of it.
TEST(Transform, NormalsStayNormal) {
  for (const double flip : {1.0, -1.0}) {
    const Mat4 m = rotation({1, 2, 3}, 0.4) * scaling({flip * 2, 0.3, 1});
    const Vec3 a{1, 2, 0.5}, b{-0.5, 1, 2}, n = cross(a, b), outside{0.1, 0.2, 0.9};
    const Vec3 image = transform_normal(m, n);
    EXPECT_NEAR(dot(image, transform_direction(m, a)), 0, 1e-12);
    EXPECT_NEAR(dot(image, transform_direction(m, b)), 0, 1e-12);
    EXPECT_GT(dot(image, transform_direction(m, outside)) * dot(n, outside), 0);
  }
}

}  // namespace
}  // namespace wrinkle

// Clipping against known polygons.
#include "golden/vertex/clip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace wrinkle {
namespace {

constexpr GuardBand kBand{-100, 200};

// An attribute that is linear in the clip space, so that every corner of a result can be checked.
ClipVertex vertex(double x, double y, double z = 0.5, double w = 1) {
  ClipVertex v;
  v.screen = {x, y, z, w};
  v.uv = {2 * x + 3 * y + 5 * z + 7 * w, x - y};
  v.N = {x, y, z}, v.L = {y, z, w}, v.H = {z, w, x};
  v.parameter = {w, x};
  v.P = {x + y, y + z, z + w};
  return v;
}

ClipPolygon clip_triangle(const ClipVertex& a, const ClipVertex& b, const ClipVertex& c) {
  return clip({&a, &b, &c}, kBand);
}

double area(const ClipPolygon& polygon) {
  double sum = 0;
  for (int i = 0; i < polygon.count; ++i) {
    const ScreenPoint& a = polygon.corner[static_cast<std::size_t>(i)].screen;
    const ScreenPoint& b = polygon.corner[static_cast<std::size_t>((i + 1) % polygon.count)].screen;
    sum += a.x / a.w * b.y / b.w - b.x / b.w * a.y / a.w;
  }
  return sum / 2;
}

void expect_attributes_linear(const ClipPolygon& polygon) {
  for (int i = 0; i < polygon.count; ++i) {
    const ClipVertex& got = polygon.corner[static_cast<std::size_t>(i)];
    const ScreenPoint& s = got.screen;
    const ClipVertex want = vertex(s.x, s.y, s.z, s.w);
    EXPECT_NEAR(got.uv.x, want.uv.x, 1e-9);
    EXPECT_NEAR(got.uv.y, want.uv.y, 1e-9);
    EXPECT_LT(length(got.N - want.N) + length(got.L - want.L) + length(got.H - want.H), 1e-9);
    EXPECT_LT(length(got.P - want.P), 1e-9);
    EXPECT_NEAR(got.parameter.x, want.parameter.x, 1e-9);
  }
}

TEST(Clip, InsideIsUntouched) {
  const ClipVertex a = vertex(0, 0), b = vertex(10, 0), c = vertex(-100, 200);  // exactly on the band too
  const ClipPolygon polygon = clip_triangle(a, b, c);
  ASSERT_EQ(polygon.count, 3);
  EXPECT_EQ(polygon.corner[0].screen.x, 0);
  EXPECT_EQ(polygon.corner[2].screen.x, -100);
  EXPECT_EQ(polygon.corner[2].uv, c.uv);
}

TEST(Clip, OutsideVanishesOnEverySide) {
  EXPECT_EQ(clip_triangle(vertex(-101, 0), vertex(-150, 10), vertex(-300, 5)).count, 0);
  EXPECT_EQ(clip_triangle(vertex(201, 0), vertex(250, 10), vertex(300, 5)).count, 0);
  EXPECT_EQ(clip_triangle(vertex(0, -101), vertex(5, -110), vertex(0, -300)).count, 0);
  EXPECT_EQ(clip_triangle(vertex(0, 201), vertex(5, 210), vertex(0, 300)).count, 0);
  EXPECT_EQ(clip_triangle(vertex(0, 0, -0.1), vertex(5, 0, -0.1), vertex(0, 5, -0.1)).count, 0);
  EXPECT_EQ(clip_triangle(vertex(0, 0, 1.1), vertex(5, 0, 1.1), vertex(0, 5, 1.1)).count, 0);
  // This triangle lies outside of a corner of the band, but all of it is outside of no single side.
  EXPECT_EQ(clip_triangle(vertex(-150, -90), vertex(-90, -150), vertex(-150, -150)).count, 0);
}

TEST(Clip, OneSideGivesTheKnownQuadrangle) {
  const ClipPolygon polygon = clip_triangle(vertex(100, 0), vertex(300, 0), vertex(100, 100));
  ASSERT_EQ(polygon.count, 4);
  EXPECT_EQ(polygon.corner[1].screen.x, 200);
  EXPECT_EQ(polygon.corner[1].screen.y, 0);
  EXPECT_EQ(polygon.corner[2].screen.x, 200);
  EXPECT_EQ(polygon.corner[2].screen.y, 50);
  EXPECT_DOUBLE_EQ(area(polygon), 100 * 100 - 50 * 50);
  expect_attributes_linear(polygon);
}

TEST(Clip, ATriangleAroundTheBandIsTheBand) {
  const ClipPolygon polygon = clip_triangle(vertex(-1000, -1000), vertex(2000, -1000), vertex(0, 3000));
  EXPECT_NEAR(area(polygon), 300.0 * 300, 1e-6);
  expect_attributes_linear(polygon);
}

// What is behind the eye (w <= 0) is cut off, and the edges in front of it end on the near plane.
TEST(Clip, NearPlaneRemovesWhatIsBehindTheEye) {
  // z = 2 (d - 1), w = d: near plane at d = 1.
  const auto at = [](double x, double y, double d) { return vertex(x, y, 2 * (d - 1) / 3, d); };
  const ClipPolygon polygon = clip_triangle(at(0, 0, 2), at(0, 10, 2), at(30, 0, -2));
  ASSERT_EQ(polygon.count, 4);
  for (int i = 0; i < polygon.count; ++i) EXPECT_GE(polygon.corner[static_cast<std::size_t>(i)].screen.w, 1 - 1e-12);
  expect_attributes_linear(polygon);
  EXPECT_EQ(clip_triangle(at(0, 0, 0), at(0, 10, -1), at(30, 0, -2)).count, 0);
}

TEST(Clip, FarPlane) {
  const ClipPolygon polygon = clip_triangle(vertex(0, 0, 0.5), vertex(10, 0, 1.5), vertex(0, 10, 0.5));
  ASSERT_EQ(polygon.count, 4);
  EXPECT_EQ(polygon.corner[1].screen.x, 5);
  EXPECT_EQ(polygon.corner[1].screen.z, 1);
}

// Both triangles at a shared edge get the same new corner, bit for bit, in whichever direction the edge runs.
TEST(Clip, SharedEdgesAreCutAlike) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> inside(-50, 150), outside(250, 900);
  for (int n = 0; n < 1000; ++n) {
    const ClipVertex a = vertex(inside(random), inside(random)), b = vertex(outside(random), inside(random));
    const ClipVertex c = vertex(inside(random), inside(random)), d = vertex(inside(random), inside(random));
    const ClipPolygon left = clip_triangle(a, b, c), right = clip_triangle(b, a, d);
    const auto holds = [](const ClipPolygon& polygon, const ClipVertex& v) {
      return std::any_of(polygon.corner.begin(), polygon.corner.begin() + polygon.count, [&](const ClipVertex& w) {
        return w.screen.x == v.screen.x && w.screen.y == v.screen.y && w.uv == v.uv && w.L == v.L;
      });
    };
    const ClipVertex& cut = left.corner[1];  // on the edge a-b
    ASSERT_NEAR(cut.screen.x, 200, 1e-9);
    ASSERT_TRUE(holds(right, cut));
  }
}

}  // namespace
}  // namespace wrinkle

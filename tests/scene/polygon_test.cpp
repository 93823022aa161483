// Polygons of OBJ files as triangles.
#include "sim/scene/polygon.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

namespace wrinkle::test {
namespace {

Vec3 area_of(const std::vector<Vec3>& p) {
  Vec3 sum;
  for (std::size_t i = 0; i < p.size(); ++i) sum = sum + 0.5 * cross(p[i] - p[0], p[(i + 1) % p.size()] - p[0]);
  return sum;
}

// Every corner is used, no triangle is turned over, and the areas add up: nothing is covered twice or left out.
void expect_covered(const std::vector<Vec3>& outline) {
  const auto triangles = triangulate(outline);
  ASSERT_EQ(triangles.size(), outline.size() - 2);
  const Vec3 whole = area_of(outline), n = normalize(whole);
  double sum = 0;
  std::set<std::uint32_t> used;
  for (const auto& t : triangles) {
    const double area = dot(n, area_of({outline[t[0]], outline[t[1]], outline[t[2]]}));
    EXPECT_GT(area, -1e-12 * length(whole));
    sum += area;
    used.insert(t.begin(), t.end());
  }
  EXPECT_EQ(used.size(), outline.size());
  EXPECT_NEAR(sum, length(whole), 1e-9 * length(whole));
}

// Turned in space and scaled, from any corner on.
void expect_covered_everywhere(const std::vector<Vec2>& outline) {
  const Vec3 x = normalize({1, 2, 3}), y = normalize(cross({0, 0, 1}, x));
  for (const double scale : {1e-9, 1.0, 1e9}) {
    for (std::size_t first = 0; first < outline.size(); first += 1 + outline.size() / 16) {
      std::vector<Vec3> flat, turned;
      for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 p = scale * outline[(first + i) % outline.size()];
        flat.push_back({p.x, p.y, 0});
        turned.push_back(p.x * x + p.y * y);
      }
      expect_covered(flat);
      expect_covered(turned);
    }
  }
}

TEST(Polygons, Arrows) { expect_covered_everywhere({{0, 0}, {2, -1}, {0, 3}, {-2, -1}}); }

TEST(Polygons, Comb) {
  std::vector<Vec2> comb;
  for (int i = 0; i < 9; ++i) {
    comb.push_back({static_cast<double>(i), 0});
    comb.push_back({i + 0.1, i % 2 == 0 ? 5.0 : 0.2});
  }
  comb.push_back({10, 0});
  comb.push_back({10, -1});
  comb.push_back({0, -1});
  expect_covered_everywhere(comb);
}

TEST(Polygons, CornersInLineAreKept) {
  expect_covered_everywhere({{0, 0}, {0.1, 0}, {0.2, 0}, {0.3, 0}, {1, 0}, {1, 0.7}, {1, 1}, {0, 1}, {0, 0.3}});
  expect_covered_everywhere({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 1}});
}

// A ring as an outline with a bridge, and one with two holes.
TEST(Polygons, HolesBehindBridges) {
  expect_covered_everywhere(
      {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}, {-.5, -.5}, {-.5, .5}, {.5, .5}, {.5, -.5}, {-.5, -.5}});
  expect_covered_everywhere({{0, 0},
                             {1, 0},
                             {1, 1},
                             {1, 2},
                             {2, 2},
                             {2, 1},
                             {1, 1},
                             {1, 0},
                             {3, 0},
                             {4, 0},
                             {4, 1},
                             {5, 2},
                             {5, 1},
                             {4, 1},
                             {4, 0},
                             {7, 0},
                             {7, 3},
                             {0, 3}});
}

// Into the polygon and back on the same line.
TEST(Polygons, Slits) {
  expect_covered_everywhere({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {2, 1}, {2, 2}, {0, 2}});
  expect_covered_everywhere({{0, 0}, {1, 0}, {1, 1}, {1.5, 1.5}, {1, 1}, {1, 0}, {2, 0}, {2, 2}, {0, 2}});
}

TEST(Polygons, TouchingThemselvesAtACorner) {
  expect_covered_everywhere({{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}});
  expect_covered_everywhere({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 2}, {2, 3}, {3, 2}, {2, 1}, {0, 2}});
}

TEST(Polygons, RandomStarsSeed1) {
  std::mt19937 random(1);
  for (int n : {5, 8, 13, 50, 300}) {
    for (int repeat = 0; repeat < 20; ++repeat) {
      std::vector<Vec2> star;
      for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n, radius = 0.05 + static_cast<double>(random() % 1000) / 1000;
        star.push_back({radius * std::cos(angle), radius * std::sin(angle)});
      }
      expect_covered_everywhere(star);
    }
  }
}

TEST(Polygons, AQuadrilateralIsCutByItsShorterDiagonal) {
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;
  EXPECT_EQ(triangulate(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {2, 2, 0}, {0, 1, 0}}),
            (Triangles{{0, 1, 3}, {1, 2, 3}}));
  EXPECT_EQ(triangulate(std::vector<Vec3>{{0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {2, 2, 0}}),
            (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Polygons, WithoutAreaTheyAreStillTriangles) {
  EXPECT_EQ(triangulate(std::vector<Vec3>(6)).size(), 4U);
  EXPECT_EQ(triangulate(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1, 0, 0}}).size(), 3U);
  EXPECT_TRUE(triangulate(std::vector<Vec3>(2)).empty());
}

// The square of the number would take minutes.
TEST(Polygons, ManyCornersTakeLittleTime) {
  std::vector<Vec3> gear;
  for (int i = 0; i < 100000; ++i) {
    const double angle = 2 * std::numbers::pi * i / 100000, radius = i % 2 == 0 ? 1 : 0.9;
    gear.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(triangulate(gear).size(), gear.size() - 2);
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 10);
}

}  // namespace
}  // namespace wrinkle::test

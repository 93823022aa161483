#include <gtest/gtest.h>

#include "golden/texel/bump.h"
#include "tests/host/packet_walker.h"

namespace wrinkle {
namespace {

using namespace test;

double distance(Vec3 a, Vec3 b) { return length(a - b); }

// A frame that is neither orthogonal nor of unit length, and slopes.
struct Patch {
  Vec3 Pu, Pv;
  double fu, fv;
};
Patch random_patch(Random& random) {
  for (;;) {
    const double scale = std::exp2(random.real(-6, 6));
    const Vec3 Pu = scale * random.unit_vector();
    const Vec3 Pv = scale * random.real(0.2, 5) * random.unit_vector();
    if (length(cross(Pu, Pv)) < 0.05 * length(Pu) * length(Pv)) continue;
    const double fu = scale * random.real(-2, 2), fv = scale * random.real(-2, 2);
    return {Pu, Pv, fu, fv};
  }
}

TEST(Bump, Blinn_Peercy_AndMikkelsenAgree) {
  Random random(1);
  double worst = 0;
  for (int i = 0; i < 100000; ++i) {
    const auto [Pu, Pv, fu, fv] = random_patch(random);
    const Vec3 blinn = perturbed_normal_blinn(Pu, Pv, fu, fv);
    const Vec3 N = normalize(cross(Pu, Pv)), T = normalize(Pu), B = cross(N, T);
    const Vec3 ts = tangent_space_normal(Pu, Pv, fu, fv);
    worst = std::max(worst, distance(blinn, ts.x * T + ts.y * B + ts.z * N));
    worst = std::max(worst, distance(blinn, perturbed_normal_mikkelsen(N, Pu, Pv, fu, fv)));
  }
  RecordProperty("worst", std::to_string(worst * 1e15) + "e-15");
  EXPECT_LT(worst, 1e-12);
}

TEST(Bump, SquarePatchesAgreeWithTheGeneralForm) {
  Random random(2);
  for (int i = 0; i < 10000; ++i) {
    const double k = std::exp2(random.real(-6, 6)), fu = k * random.real(-3, 3), fv = k * random.real(-3, 3);
    const Vec3 T = random.unit_vector();
    const Vec3 B = normalize(cross(random.unit_vector(), T));
    EXPECT_LT(distance(square_patch_normal(k, fu, fv), tangent_space_normal(k * T, k * B, fu, fv)), 1e-12);
  }
}

// Eq. 1 for a plane z = h(x, y): the normal of the graph.
TEST(Bump, APlaneTiltsAgainstTheSlope) {
  const Vec3 expected = normalize(Vec3{-0.5, 0.25, 1});
  EXPECT_LT(distance(perturbed_normal_blinn({1, 0, 0}, {0, 1, 0}, 0.5, -0.25), expected), 1e-15);
  EXPECT_LT(distance(square_patch_normal(1, 0.5, -0.25), expected), 1e-15);
}

// Doubling the surface halves the bumps [Peercy97 section 1].
TEST(Bump, HeightDependsOnTheScaleOfTheSurface) {
  const auto tilt = [](double scale) {
    const Vec3 n = perturbed_normal_blinn({scale, 0, 0}, {0, scale, 0}, 0.1, 0);
    return n.x / n.z;
  };
  EXPECT_NEAR(tilt(2), tilt(1) / 2, 1e-15);
}

TEST(Extremes, E57_BumpsThatSwampTheSurfaceOrVanish) {
  EXPECT_LT(distance(perturbed_normal_blinn({1, 0, 0}, {0, 1, 0}, 1e12, 0), {-1, 0, 0}), 1e-11);
  EXPECT_EQ(perturbed_normal_blinn({1, 0, 0}, {0, 1, 0}, 0, 0), (Vec3{0, 0, 1}));
  EXPECT_EQ(tangent_space_normal({0, 0, 0}, {0, 1, 0}, 1, 1), (Vec3{0, -0.0, 0}));
}

TEST(Extremes, E31_StretchedPatch) {
  const Vec3 n = tangent_space_normal({1e6, 0, 0}, {0, 1, 0}, 1, 1);
  EXPECT_LE(std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}), 1);
  EXPECT_NEAR(n.x, -1e-6 / std::sqrt(2), 1e-12);
  EXPECT_NEAR(n.y, -1 / std::sqrt(2), 1e-12);
}

}  // namespace
}  // namespace wrinkle

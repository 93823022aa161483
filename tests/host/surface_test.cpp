// Surfaces: derivatives against finite differences, normals, poles, closed seams.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>

#include "golden/texel/bump.h"
#include "golden/vertex/bezier.h"
#include "golden/vertex/surfaces.h"
#include "golden/vertex/teapot.h"
#include "golden/vertex/transform.h"

namespace wrinkle {
namespace {

struct Named {
  std::string name;
  std::shared_ptr<const Surface> surface;
};

std::vector<Named> all_surfaces() {
  std::vector<Named> list{
      {"rectangle", std::make_shared<Rectangle>(Vec3{1, 2, 3}, Vec3{2, 0, 1}, Vec3{0, 3, 0.5})},
      {"sphere", std::make_shared<Sphere>(1.5)},
      {"torus", std::make_shared<Torus>(2, 0.7)},
      {"revolution", std::make_shared<Revolution>(std::vector<Vec2>{{0.5, -1}, {1, 0}, {0.7, 0.5}, {0.9, 1}})},
      {"stretched", stretched_patch()},
      {"moved", transformed(std::make_shared<Torus>(2, 0.7),
                            translation({1, 2, 3}) * rotation({1, 2, 2}, 0.7) * scaling({1, 2, 0.5}))},
  };
  int number = 0;
  for (const auto& patch : teapot()) list.push_back({"teapot " + std::to_string(number++), patch});
  return list;
}

void expect_near(Vec3 a, Vec3 b, double tolerance) { EXPECT_LE(length(a - b), tolerance); }

TEST(Surface, DerivativesAreThoseOfThePosition) {
  constexpr double kStep = 1e-6;
  for (const auto& [name, surface] : all_surfaces()) {
    SCOPED_TRACE(name);
    for (double v = 0.13; v < 1; v += 0.11) {
      for (double u = 0.07; u < 1; u += 0.09) {
        const SurfacePoint s = surface->at(u, v);
        expect_near(s.Pu, (0.5 / kStep) * (surface->at(u + kStep, v).P - surface->at(u - kStep, v).P), 1e-7);
        expect_near(s.Pv, (0.5 / kStep) * (surface->at(u, v + kStep).P - surface->at(u, v - kStep).P), 1e-7);
      }
    }
  }
}

TEST(Surface, NormalIsUnitAndAlongPuCrossPv) {
  for (const auto& [name, surface] : all_surfaces()) {
    SCOPED_TRACE(name);
    for (double v = 0; v <= 1; v += 0.0625) {
      for (double u = 0; u <= 1; u += 0.0625) {
        const SurfacePoint s = surface->at(u, v);
        ASSERT_NEAR(length(s.N), 1, 1e-12);
        const Vec3 area = cross(s.Pu, s.Pv);
        if (length(area) > 1e-4) expect_near(s.N, normalize(area), 1e-9);
      }
    }
  }
}

TEST(Surface, SphereAndTorusFaceOutwards) {
  const Sphere sphere(2);
  const Torus torus(3, 1);
  for (double v = 0; v <= 1; v += 0.125) {
    for (double u = 0; u <= 1; u += 0.125) {
      const SurfacePoint s = sphere.at(u, v);
      expect_near(s.N, 0.5 * s.P, 1e-12);
      const SurfacePoint t = torus.at(u, v);
      const Vec3 axis = 3 * normalize(Vec3{t.P.x, 0, t.P.z});
      expect_near(t.N, t.P - axis, 1e-12);
    }
  }
}

TEST(Surface, ClosedSurfacesCloseBitForBit) {
  const Sphere sphere(1.3);
  const Torus torus(2, 0.3);
  for (double t = 0; t <= 1; t += 1.0 / 32) {
    EXPECT_EQ(sphere.at(0, t).P, sphere.at(1, t).P);
    EXPECT_EQ(torus.at(0, t).P, torus.at(1, t).P);
    EXPECT_EQ(torus.at(t, 0).P, torus.at(t, 1).P);
    EXPECT_EQ(sphere.at(t, 1).P, sphere.at(0, 1).P);  // the pole is one point
  }
}

// The tip of the teapot's lid: Pu vanishes there; the normal points up whichever way one comes from.
TEST(Surface, NormalAtThePoleOfTheLidIsItsLimit) {
  const auto patches = teapot();
  for (std::size_t i = 20; i < 24; ++i) {
    for (double u = 0; u <= 1; u += 0.125) {
      const SurfacePoint tip = patches[i]->at(u, 1);
      EXPECT_LT(length(tip.Pu), 1e-12);
      expect_near(tip.N, {0, 1, 0}, 1e-5);
    }
  }
}

// A quarter of a paraboloid's cap with a collapsed edge, whose limit normal is not along an axis.
TEST(Surface, NormalAtACollapsedEdgeIsTheLimit) {
  ControlPoints points;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const double r = static_cast<double>(i) / 3, a = static_cast<double>(j) / 3;
      points[4 * i + j] = {r * (1 - a), r * a, 0.3 * r * (1 - a) + 0.1 * r * a - 0.2 * r * r * a};
    }
  }
  const BezierPatch patch(points);
  for (double u = 0; u <= 1; u += 0.125) {
    const Vec3 limit = patch.at(u, 1e-5).N;
    expect_near(patch.at(u, 0).N, limit, 1e-4);
    EXPECT_LT(limit.z, 0.99);
  }
}

// (u, v) -> (u + v, u v, 0) folds along u = v, where Pu and Pv are parallel; a net drawn to one line has no side at
// all.
TEST(Surface, ParallelDerivativesStillHaveANormal) {
  ControlPoints fold, line;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const double u = static_cast<double>(j) / 3, v = static_cast<double>(i) / 3;
      fold[4 * i + j] = {u + v, u * v, 0};
      line[4 * i + j] = {u + v, 2 * (u + v), 0};
    }
  }
  for (const double t : {0.0, 0.25, 0.5, 1.0}) {
    EXPECT_NEAR(std::abs(BezierPatch(fold).at(t, t).N.z), 1, 1e-12);
    EXPECT_NEAR(length(BezierPatch(line).at(t, 0.3).N), 1, 1e-12);
  }
}

TEST(Surface, PatchesThatShareABorderMeetBitForBit) {
  const auto patches = teapot();
  // Body: four patches around, each ends (u = 1) where the next begins (u = 0); the ring below continues it.
  for (std::size_t i = 0; i < 4; ++i) {
    for (double t = 0; t <= 1; t += 1.0 / 16) {
      EXPECT_EQ(patches[4 + i]->at(1, t).P, patches[4 + (i + 1) % 4]->at(0, t).P);
      EXPECT_EQ(patches[4 + i]->at(t, 0).P, patches[8 + i]->at(t, 1).P);
    }
  }
}

TEST(Surface, ACurveReadBackwardsHasTheSamePoints) {
  const ControlPoints forward = [] {
    ControlPoints p;
    for (std::size_t i = 0; i < 16; ++i) {
      const auto x = static_cast<double>(i);
      p[i] = {std::sin(x), std::cos(3 * x), 0.1 * x};
    }
    return p;
  }();
  ControlPoints backward = forward;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) backward[4 * i + j] = forward[4 * i + 3 - j];
  }
  const BezierPatch a(forward), b(backward);
  for (double t = 0; t <= 1; t += 1.0 / 64) EXPECT_EQ(a.at(t, 0).P, b.at(1 - t, 0).P);
}

// The description of the paper: clearly not orthogonal, of different lengths, no fold, most of the frame.
TEST(Surface, StretchedPatchIsStretchedAndDoesNotFold) {
  const auto patch = stretched_patch();
  double least_angle = 180, most_angle = 0, least_ratio = 1e9, most_ratio = 0, area = 0;
  constexpr int kSteps = 64;
  for (int j = 0; j < kSteps; ++j) {
    for (int i = 0; i < kSteps; ++i) {
      const SurfacePoint s = patch->at((i + 0.5) / kSteps, (j + 0.5) / kSteps);
      const double angle = std::acos(dot(normalize(s.Pu), normalize(s.Pv))) * 180 / std::numbers::pi;
      const double ratio = length(s.Pu) / length(s.Pv);
      least_angle = std::min(least_angle, angle), most_angle = std::max(most_angle, angle);
      least_ratio = std::min(least_ratio, ratio), most_ratio = std::max(most_ratio, ratio);
      ASSERT_GT(cross(s.Pu, s.Pv).z, 0.25);
      ASSERT_LT(std::max(std::abs(s.P.x), std::abs(s.P.y)), 1);
      area += cross(s.Pu, s.Pv).z / (kSteps * kSteps);
    }
  }
  EXPECT_LT(least_angle, 55);
  EXPECT_GT(most_angle, 95);
  EXPECT_LT(least_ratio, 0.5);
  EXPECT_GT(most_ratio, 2.5);
  EXPECT_GT(area / 4, 0.65);
}

TEST(Surface, MirroringTransformKeepsTheNormalOutside) {
  const auto mirrored = transformed(std::make_shared<Sphere>(1), scaling({-1, 1, 1}));
  const SurfacePoint s = mirrored->at(0.2, 0.6);
  expect_near(s.N, s.P, 1e-12);
  EXPECT_LT(dot(s.N, cross(s.Pu, s.Pv)), 0);
  EXPECT_EQ(reversed(mirrored)->at(0.2, 0.6).N, -s.N);
}

TEST(Surface, MeanScaleOfASquareIsItsSide) {
  EXPECT_NEAR(mean_scale(Rectangle({}, {3, 0, 0}, {0, 3, 0})), 3, 1e-12);
  EXPECT_NEAR(mean_scale(Sphere(1)), std::sqrt(4 * std::numbers::pi), 1e-3);
}

// The extreme of |Pu| to |Pv| [extremes 31]: the coefficients stay within -1..1 and agree with Blinn's.
TEST(Surface, Extreme31StretchOfAMillion) {
  for (const double ratio : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    const Vec3 Pu{ratio, 0, 0}, Pv{0.3, 1, 0};
    for (const Vec2 f : {Vec2{1, 1}, Vec2{1e6, -1e6}, Vec2{1e-6, 0}, Vec2{0, 0}}) {
      const Vec3 n = tangent_space_normal(Pu, Pv, f.x, f.y);
      EXPECT_NEAR(length(n), 1, 1e-12);
      expect_near(n, perturbed_normal_blinn(Pu, Pv, f.x, f.y), 1e-9);  // T, B, N are x, y, z here
    }
  }
}

}  // namespace
}  // namespace wrinkle

// Height fields and their derivatives.
#include "golden/texel/height.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace wrinkle {
namespace {

// f at the samples of a grid; f takes (u, v), v up.
Grid<double> sample(int width, int height, const std::function<double(double, double)>& f) {
  Grid<double> grid(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) grid.at(x, y) = f((x + 0.5) / width, 1 - (y + 0.5) / height);
  }
  return grid;
}

// Away from the seam, where the grid repeats and a polynomial does not.
void expect_gradients(const Grid<double>& grid, const std::function<Vec2(double, double)>& gradient, double tolerance) {
  const Grid<Vec2> got = gradients(grid);
  for (int y = 3; y < grid.height - 3; ++y) {
    for (int x = 3; x < grid.width - 3; ++x) {
      const Vec2 want = gradient((x + 0.5) / grid.width, 1 - (y + 0.5) / grid.height);
      ASSERT_NEAR(got.at(x, y).x, want.x, tolerance);
      ASSERT_NEAR(got.at(x, y).y, want.y, tolerance);
    }
  }
}

TEST(Height, LinearFieldsAreExact) {
  expect_gradients(
      sample(16, 32, [](double u, double v) { return 3 * u - 5 * v + 1; }),
      [](double, double) {
        return Vec2{3, -5};
      },
      1e-11);
}

TEST(Height, QuadraticFieldsAreExact) {
  expect_gradients(
      sample(32, 16, [](double u, double v) { return 2 * u * u - 3 * v * v + 4 * u * v + u; }),
      [](double u, double v) {
        return Vec2{4 * u + 4 * v + 1, -6 * v + 4 * u};
      },
      1e-11);
}

TEST(Height, SevenBySevenSamplesAndNoMore) {
  Grid<double> grid(32, 32);
  grid.at(16, 16) = 1;
  const Grid<Vec2> g = gradients(grid);
  int touched = 0;
  for (const Vec2& d : g.samples) touched += d.x != 0 || d.y != 0 ? 1 : 0;
  EXPECT_EQ(touched, 7 * 7 - 1);  // the centre has a weight of zero in both
  EXPECT_GT(g.at(15, 16).x, 0);
  EXPECT_LT(g.at(17, 16).x, 0);
  EXPECT_LT(g.at(16, 15).y, 0);  // the row above has the peak below it: f falls as v grows
}

TEST(Height, FieldRepeats) {
  const Grid<double> grid = sample(64, 64, [](double u, double v) {
    return std::sin(2 * 3.14159265358979 * u) * std::cos(2 * 3.14159265358979 * v);
  });
  const SampledHeightField field(grid);
  for (const double t : {0.0, 0.1, 0.77}) {
    const Vec2 a = field.gradient(t, 0.3), b = field.gradient(t + 2, 0.3 - 1);
    EXPECT_NEAR(a.x, b.x, 1e-9);
    EXPECT_NEAR(a.y, b.y, 1e-9);
  }
  EXPECT_NEAR(field.gradient(0, 0).x, 2 * 3.14159265, 0.1);  // across the seam
}

// A ramp from 0 to 1: clamped, its slope is the same at the border; repeated, it has a cliff; mirrored, it turns round.
TEST(Height, BordersAreAsTheTextureWraps) {
  Grid<double> ramp(32, 32);
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x) ramp.at(x, y) = (x + 0.5) / 32;
  }
  const auto slope = [&](Wraps wraps, int x) { return gradients(ramp, wraps).at(x, 16).x; };
  const Wraps clamp{Wrap::kClamp, Wrap::kClamp}, mirror{Wrap::kMirror, Wrap::kMirror};
  for (const int x : {0, 1, 16, 30, 31}) EXPECT_NEAR(slope(clamp, x), 1, 1e-12) << x;
  EXPECT_LT(slope({}, 0), -1);
  EXPECT_GT(slope(mirror, 0), 0);
  EXPECT_LT(slope(mirror, 0), 1);
  EXPECT_NEAR(slope(Wraps{Wrap::kRepeat, Wrap::kClamp}, 0), slope({}, 0), 1e-12);
  const SampledHeightField field(ramp, clamp);
  EXPECT_NEAR(field.gradient(-0.5, 0.5).x, 1, 1e-12);
}

TEST(Height, SampledFieldMeetsItsSamplesAndIsContinuous) {
  const Grid<double> grid = pinwheel(64, 0.1);
  const Grid<Vec2> g = gradients(grid);
  const SampledHeightField field(grid);
  for (int i = 0; i < 64; i += 5) {
    const Vec2 at = field.gradient((i + 0.5) / 64, 1 - (20 + 0.5) / 64);
    EXPECT_NEAR(at.x, g.at(i, 20).x, 1e-9);
    EXPECT_NEAR(at.y, g.at(i, 20).y, 1e-9);
  }
  for (double u = 0; u < 1; u += 0.0371) {
    const Vec2 a = field.gradient(u, 0.4), b = field.gradient(u + 1e-9, 0.4 + 1e-9);
    EXPECT_NEAR(a.x, b.x, 1e-5);
    EXPECT_NEAR(a.y, b.y, 1e-5);
  }
}

TEST(Height, PinwheelIsAPinwheel) {
  const Grid<double> grid = pinwheel();
  ASSERT_EQ(grid.width, 512);
  ASSERT_EQ(grid.height, 512);
  double sum = 0;
  int between = 0;
  for (const double h : grid.samples) {
    ASSERT_GE(h, 0);
    ASSERT_LE(h, 0.02);
    sum += h;
    between += h > 0 && h < 0.02 ? 1 : 0;
  }
  // Half of the disc between hub and rim is raised; only samples on a side are in between.
  const double disc = 3.14159265 * (0.45 * 0.45 - 0.06 * 0.06);
  EXPECT_NEAR(sum / (512 * 512) / 0.02, disc / 2, 0.002);
  EXPECT_LT(between, 0.05 * static_cast<double>(grid.samples.size()));
  EXPECT_GT(between, 1000);
  // The field is flat along its border, so there is no seam.
  for (int i = 0; i < 512; ++i) EXPECT_EQ(grid.at(i, 0) + grid.at(0, i) + grid.at(511, i) + grid.at(i, 511), 0);
  // Six raised vanes around any circle.
  int rises = 0;
  for (int i = 0; i < 360; ++i) {
    const auto at = [&](int n) {
      const double a = n * 2 * 3.14159265358979 / 360;
      return grid.at(static_cast<int>(256 + 128 * std::cos(a)), static_cast<int>(256 - 128 * std::sin(a))) > 0.01;
    };
    rises += at(i + 1) && !at(i) ? 1 : 0;
  }
  EXPECT_EQ(rises, 6);
}

}  // namespace
}  // namespace wrinkle

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "golden/triangle/level_of_detail.h"
#include "tests/host/planes.h"

namespace wrinkle {
namespace {

using namespace test;

TEST(SetUp, WholeRepeatsAreTakenOff) {
  Random random(40);
  const Config config = fixed_widths();
  ScreenTriangle near = triangle({100, 100}, {9000, 300}, {500, 12000});
  randomize_attributes(random, near);
  for (ScreenVertex& v : near.v) v.uv.x = std::round(v.uv.x * 1024) / 1024, v.uv.y = std::round(v.uv.y * 1024) / 1024;
  ScreenTriangle far = near;
  DrawWords draw = bumped();
  const auto same = [&](double u, double v) {
    for (std::size_t i = 0; i < 3; ++i) far.v[i].uv = {near.v[i].uv.x + u, near.v[i].uv.y + v};
    return set_up(config, far, draw, 64, 64) == set_up(config, near, draw, 64, 64);
  };
  EXPECT_TRUE(same(32768, -32768));
  EXPECT_TRUE(same(-1, 1));
  EXPECT_FALSE(same(0.5, 0));
  draw.wrap_u = static_cast<int>(Wrap::kMirror);
  EXPECT_TRUE(same(32768, 3));
  EXPECT_FALSE(same(1, 0));
  draw.wrap_u = static_cast<int>(Wrap::kClamp);
  EXPECT_FALSE(same(1, 0));
}

TEST(SetUp, WhatDoesNotFitIsRefused) {
  Config config = fixed_widths();
  config.uv_integer_bits = 3;
  ScreenTriangle t = triangle({100, 100}, {9000, 300}, {500, 12000});
  DrawWords draw = bumped();
  const auto with_u = [&](double low, double high) {
    t.v[0].uv.x = low, t.v[1].uv.x = t.v[2].uv.x = high;
    return set_up(config, t, draw, 64, 64);
  };
  EXPECT_NO_THROW(with_u(100.5, 107));
  EXPECT_THROW(with_u(-4, 4), std::range_error);
  EXPECT_THROW(with_u(0, 1e30), std::range_error);
  EXPECT_THROW(with_u(0, std::nan("")), std::range_error);
  draw.wrap_u = static_cast<int>(Wrap::kClamp);
  EXPECT_NO_THROW(with_u(0, 3.9));
  try {
    with_u(0, 4.5);
    FAIL();
  } catch (const std::range_error& error) {
    EXPECT_NE(std::string(error.what()).find("uv_integer_bits = 3"), std::string::npos) << error.what();
  }
  draw.textured = draw.bump = false;
  EXPECT_NO_THROW(with_u(0, 4.5)) << "no texel is fetched";
  t.v[1].N = {0, 5, 0};
  EXPECT_THROW(with_u(0, 1), std::invalid_argument);
  t.v[1].N = {0, std::nan(""), 0};
  EXPECT_THROW(with_u(0, 1), std::invalid_argument);
}

// u over 32 pixels of a 64 x 64 texture.
int level_over_32_pixels(const Config& config, double repeats) {
  ScreenTriangle t = triangle({0, 0}, {32 * 256, 0}, {0, 32 * 256});
  t.v[1].uv.x = repeats;
  return set_up(config, t, bumped(), 64, 64).at(0).lod;
}

TEST(Extremes, E43_LevelOfDetailAtPowersOfTwo) {
  Config config = fixed_widths();
  const int one = 1 << config.lod_bits;
  for (int level = 0; level <= 3; ++level) {
    const double repeats = std::ldexp(0.5, level);
    EXPECT_EQ(level_over_32_pixels(config, repeats), level * one);
    // One LSB is a factor 2^(1/32); half of it rounds away.
    EXPECT_EQ(level_over_32_pixels(config, repeats * 1.005), level * one);
    EXPECT_EQ(level_over_32_pixels(config, repeats * std::exp2(1.0 / 32)), level * one + 1);
    EXPECT_EQ(level_over_32_pixels(config, repeats / std::exp2(1.0 / 32)), std::max(level * one - 1, 0));
  }
  EXPECT_EQ(level_over_32_pixels(config, 0), 0);
  config.filter = 1;
  EXPECT_EQ(level_over_32_pixels(config, 0.5 * 1.41), 0);
  EXPECT_EQ(level_over_32_pixels(config, 0.5 * 1.42), 1);
}

TEST(Extremes, E47_LevelOfDetailSaturates) {
  const Config config = fixed_widths();
  ScreenTriangle t = triangle({128, 128}, {129, 128}, {128, 129});
  t.v[1].uv = {7, -7};
  EXPECT_EQ(set_up(config, t, bumped(12, 12), 64, 64).at(0).lod, 12 << config.lod_bits);
  EXPECT_EQ(level_of_detail(1e308 * 10, 5, 0, 6), 6 << 5);
  EXPECT_EQ(level_of_detail(5e-324, 5, 0, 6), 0);
  EXPECT_EQ(level_of_detail(5e-324, 5, -16, 16), -(16 << 5));
}

TEST(SetUp, LogarithmIsTheFloorOfTheTrueOne) {
  Random random(8);
  double worst = 0;
  for (int i = 0; i < 100000; ++i) {
    const double x = std::exp2(random.real(-60, 60));
    const int bits = static_cast<int>(random.integer(0, 22));
    const double difference = std::ldexp(std::log2(x), bits) - static_cast<double>(log2_fixed(x, bits));
    worst = std::max({worst, -difference, difference - 1});
  }
  EXPECT_LT(worst, 1e-5);
  for (int e = -60; e <= 60; ++e) EXPECT_EQ(log2_fixed(std::ldexp(1.0, e), 7), e * 128);
}

// u*q / q at every pixel, and the level of detail at the corners.
TEST(SetUp, PerspectivePlanesDivideToTheTexture) {
  Random random(9);
  Config config = fixed_widths();
  config.perspective = 1;
  const auto formats = plane_formats(config);
  const std::size_t u = place_of(config, "u"), q_place = place_of(config, "q");
  double worst = 0;
  for (int i = 0; i < 200; ++i) {
    ScreenTriangle t = triangle({static_cast<int>(random.integer(0, 60000)), 100},
                                {100, static_cast<int>(random.integer(100, 60000))}, {64000, 64000});
    randomize_attributes(random, t);
    for (const TriangleWords& packet : set_up(config, t, bumped(), 256, 256)) {
      walk(packet, [&](const Visit& visit) {
        const auto value = [&](std::size_t p) {
          return std::ldexp(static_cast<double>(code(config, formats[p], visit.accumulator[p])),
                            -formats[p].fraction_bits);
        };
        double sum_q = 0, sum_uq = 0;
        const std::array<std::int64_t, 3> unit[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        for (std::size_t k = 0; k < 3; ++k) {
          const Rational r = plane_at(config, t, unit[k], visit.x, visit.y);
          const double b = static_cast<double>(r.numerator) / static_cast<double>(r.denominator);
          sum_q += b * t.v[k].q, sum_uq += b * t.v[k].q * t.v[k].uv.x;
        }
        const double q = value(q_place);
        // u*q and q each within one LSB of 2^-18.
        const double bound = std::ldexp(1 + std::abs(sum_uq / sum_q), -18) / q;
        worst = std::max(worst, std::abs(value(u) / q - sum_uq / sum_q) / bound);
      });
    }
  }
  EXPECT_LE(worst, 1);
  EXPECT_GT(worst, 0.3);
}

TEST(Extremes, E46_RangeOfW) {
  Config config = fixed_widths();
  config.perspective = 1;
  ScreenTriangle t = triangle({100, 100}, {60000, 300}, {500, 62000});
  for (ScreenVertex& v : t.v) v.q = 3, v.uv = {0.25, 0.5};
  // Equal w: q is constant, just below 1.
  const std::size_t place = place_of(config, "q");
  const PlaneFormat format = plane_formats(config)[place];
  const auto equal = set_up(config, t, bumped(), 256, 256).at(0).planes[place];
  EXPECT_EQ(equal.dw, 0);
  EXPECT_EQ(equal.row, 0);
  EXPECT_EQ(code(config, format, equal.value), (1 << 18) - 1);
  // A ratio of 2^15: q stays positive everywhere.
  t.v[0].q = std::ldexp(1.0, 15), t.v[1].q = t.v[2].q = 1;
  for (const TriangleWords& packet : set_up(config, t, bumped(), 256, 256)) {
    walk(packet, [&](const Visit& visit) {
      const auto q = code(config, format, visit.accumulator[place]);
      ASSERT_GE(q, 1);
      ASSERT_LE(visit.x + visit.y > 220 ? q : 0, 1 << 16) << "q was carried round";
    });
  }
  for (double q : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    t.v[1].q = q;
    EXPECT_THROW(set_up(config, t, bumped(), 256, 256), std::invalid_argument);
  }
}

TEST(SetUp, LevelOfDetailIsAPlaneThroughItsCornersWithPerspective) {
  Config config = fixed_widths();
  config.perspective = 1;
  // A floor: u, v and 1/w of a plane seen in perspective; rho at (x, y) by central differences.
  const auto q_at = [](double x, double y) { return 0.2 + 0.003 * x + 0.006 * y; };
  const auto u_at = [&](double x, double y) { return (0.002 * x + 0.001 * y) / q_at(x, y); };
  const auto v_at = [&](double x, double y) { return (0.1 - 0.001 * y) / q_at(x, y); };
  ScreenTriangle t =
      triangle({10 * 256 + 128, 10 * 256 + 128}, {100 * 256 + 128, 20 * 256 + 128}, {40 * 256 + 128, 110 * 256 + 128});
  for (ScreenVertex& v : t.v) {
    const double x = v.x / 256.0, y = v.y / 256.0;
    v.q = q_at(x, y), v.uv = {u_at(x, y), v_at(x, y)};
  }
  const TriangleWords packet = set_up(config, t, bumped(8, 7), 128, 128).at(0);
  const std::size_t place = place_of(config, "lod");
  const PlaneFormat format = plane_formats(config)[place];
  const PlaneWords& plane = packet.planes[place];
  for (const ScreenVertex& v : t.v) {
    const double x = v.x / 256.0, y = v.y / 256.0, h = 1e-4;
    const auto rate = [&](double dx, double dy) {
      return std::hypot(256 * (u_at(x + dx, y + dy) - u_at(x - dx, y - dy)),
                        128 * (v_at(x + dx, y + dy) - v_at(x - dx, y - dy))) /
             (2 * h);
    };
    const double level = std::log2(std::max(rate(h, 0), rate(0, h)));
    const std::int64_t w = packet.mirror ? -1 - (v.x >> 8) : v.x >> 8;
    const std::int64_t dy = plane.row - packet.start.step * plane.dw;
    const std::int64_t value = plane.value + (w - packet.start.w) * plane.dw + ((v.y >> 8) - packet.y) * dy;
    EXPECT_NEAR(std::ldexp(static_cast<double>(code(config, format, value)), -5), level, 0.55 / 32);
  }
}

}  // namespace
}  // namespace wrinkle

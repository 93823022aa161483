#include <gtest/gtest.h>

#include "golden/triangle/corners.h"
#include "tests/host/planes.h"

namespace wrinkle {
namespace {

using namespace test;

double component(const Vec3& v, std::size_t k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; }

// A plane below 3 * frame_vectors at corner i of `t`.
double frame_value(const Shape& config, const ScreenTriangle& t, std::size_t plane, std::size_t i) {
  const Corners corners = sort_corners(config, t);
  const std::vector<std::array<Vec3, 3>> frame = frame_corners(config, corners, bumped());
  for (std::size_t k = 0; k < 3; ++k)
    if (corners.v[k] == &t.v[i]) return component(frame[plane / 3][k], plane % 3);
  return 0;
}

// Without perspective.
std::array<double, 3> corner_values(const Shape& config, const ScreenTriangle& t, const PlaneFormat& format,
                                    std::size_t plane) {
  std::array<double, 3> values{};
  const double margin =
      std::ldexp(1.0, std::min(std::max(config.screen_bits - config.guard_bits, 0), config.depth_bits - 3));
  for (std::size_t i = 0; i < 3; ++i) {
    const ScreenVertex& v = t.v[i];
    if (plane < 3 * static_cast<std::size_t>(config.frame_vectors)) values[i] = frame_value(config, t, plane, i);
    if (format.name == "l") values[i] = component(v.L, format.element);
    if (format.name == "h") values[i] = component(v.H, format.element);
    if (format.name == "u") values[i] = v.uv.x;
    if (format.name == "v") values[i] = v.uv.y;
    if (format.name == "z")
      values[i] =
          (margin + v.z * (std::ldexp(1.0, config.depth_bits) - 1 - 2 * margin)) * std::ldexp(1.0, -config.depth_bits);
  }
  return values;
}

struct Worst {
  double over_bound = 0;  // error over its bound; at most 1
  double lsb = 0;         // of the output, against the unrounded corners
  std::int64_t pixels = 0;
};

// Compares every component, without perspective and at every pixel of a triangle, with the exact rational number.
void measure(const Config& config, const ScreenTriangle& t, Worst& worst) {
  const double guard = std::ldexp(1.0, config.guard_bits);
  for (const TriangleWords& packet : set_up(config, t, bumped(), config.screen_size(), config.screen_size())) {
    const std::vector<PlaneFormat> formats = plane_formats(config);
    for (std::size_t p = 0; p < formats.size(); ++p) {
      const PlaneFormat& format = formats[p];
      if (format.is_held) continue;
      const std::array<double, 3> values = corner_values(config, t, format, p);
      std::array<std::int64_t, 3> corner{};
      for (std::size_t i = 0; i < 3; ++i) {
        corner[i] = std::llround(std::ldexp(values[i], format.fraction_bits + config.guard_bits));
      }
      walk(packet, [&](const Visit& visit) {
        const std::int64_t output = code(config, format, visit.accumulator[p]);
        const double error =
            static_cast<double>(output) - plane_at(config, t, corner, visit.x, visit.y).value() / guard;
        const double bound = 0.5 + (visit.steps + 1) / (2 * guard);
        worst.over_bound = std::max(worst.over_bound, std::abs(error) / bound);
        worst.lsb = std::max(worst.lsb, std::abs(error));
        ++worst.pixels;
      });
    }
  }
}

Config affine(Random& random, int screen_bits) {
  Config config = random.config();
  config.perspective = 0;
  config.screen_bits = screen_bits;
  config.uv_integer_bits = std::max(config.uv_integer_bits, 2);
  config.uv_bits = std::max(config.uv_bits, 14);  // so that the margin of the coarsest guard bits still fits
  return config;
}

TEST(SetUp, PlanesKeepTheirBoundOnRandomTriangles) {
  Random random(1);
  Worst worst;
  for (int i = 0; i < 3000; ++i) {
    const Config config = affine(random, 4 + i % 3);
    const int size = config.screen_size() << config.subpixel_bits;
    const auto point = [&] {
      return Point{static_cast<int>(random.integer(-size, 2 * size - 1)),
                   static_cast<int>(random.integer(-size, 2 * size - 1))};
    };
    const Point a = point(), b = point(), c = point();
    ScreenTriangle t = triangle(a, b, c);
    if (i % 3 == 0) t.v[2].x = t.v[0].x + static_cast<int>(random.integer(-3, 3)), t.v[2].y = t.v[0].y;
    if (t.v[2].x < -size || t.v[2].x >= 2 * size) continue;
    randomize_attributes(random, t);
    measure(config, t, worst);
  }
  RecordProperty("worst_over_bound", std::to_string(worst.over_bound));
  EXPECT_LE(worst.over_bound, 1);
  EXPECT_GT(worst.over_bound, 0.9);
  EXPECT_GT(worst.pixels, 1'000'000);
}

// Vectors scaled by 1/w: the interpolated direction is that of the perspective-correct vector.
TEST(SetUp, VectorsFollowThePerspective) {
  Config config = fixed_widths();
  config.perspective = 1;
  ScreenTriangle t = triangle({100, 100}, {60000, 300}, {500, 62000});
  t.v[0].q = 2, t.v[1].q = 0.5, t.v[2].q = 1;
  t.v[0].L = {0.6, 0, 0.8}, t.v[1].L = {0, 0.6, 0.8}, t.v[2].L = {-0.8, 0, 0.6};
  const std::size_t l = place_of(config, "l");
  const PlaneFormat format = plane_formats(config)[l];
  double worst = 0;
  for (const TriangleWords& packet : set_up(config, t, bumped(), 256, 256)) {
    walk(packet, [&](const Visit& visit) {
      Vec3 expected;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::array<std::int64_t, 3> unit{k == 0, k == 1, k == 2};
        const Rational r = plane_at(config, t, unit, visit.x, visit.y);
        expected =
            expected + static_cast<double>(r.numerator) / static_cast<double>(r.denominator) * t.v[k].q * t.v[k].L;
      }
      const auto value = [&](std::size_t i) {
        return static_cast<double>(code(config, format, visit.accumulator[l + i]));
      };
      worst = std::max(worst, length(normalize(Vec3{value(0), value(1), value(2)}) - normalize(expected)));
    });
  }
  EXPECT_LT(worst, 0.01);  // half an LSB of 2^-10 on each component of a vector of length 1/4 and more
  EXPECT_GT(worst, 0);
}

// A vector for `near`, or for no normalizer, keeps its length: at the corner of the least q it is still of length one.
TEST(SetUp, OnlyVectorsForAnyLengthAreScaled) {
  Config config = fixed_widths();
  config.perspective = 1;
  ScreenTriangle t = triangle({100, 100}, {60000, 300}, {500, 62000});
  t.v[0].q = 2, t.v[1].q = 0.5, t.v[2].q = 1;
  for (ScreenVertex& v : t.v) v.L = {0.6, 0, 0.8};
  const Corners corners = sort_corners(config, t);
  const auto shortest = [&](Normalizer kind) {
    double least = 2;
    for (const Vec3& v : vector_corners(config, corners, &ScreenVertex::L, static_cast<int>(kind)))
      least = std::min(least, length(v));
    return least;
  };
  for (Normalizer kind : {Normalizer::kNone, Normalizer::kNear}) EXPECT_NEAR(shortest(kind), 1, 1e-15);
  for (Normalizer kind : {Normalizer::kFaithful, Normalizer::kCompact, Normalizer::kLite})
    EXPECT_NEAR(shortest(kind), 0.25, 1e-15);
}

TEST(SetUp, OneRowHasNoStep) {
  const Config config = fixed_widths();
  const auto packets = set_up(config, triangle({0, 0}, {200000, 100}, {3, 300}), bumped(), 1024, 1024);
  ASSERT_EQ(packets.size(), 1u);
  EXPECT_EQ(packets[0].rows, 1);
  for (const EdgeWords& edge : {packets[0].start, packets[0].end0, packets[0].end1}) {
    EXPECT_EQ(edge.step, 0);
    EXPECT_EQ(edge.remainder_step, 0);
  }
}

TEST(Extremes, E13_NoGradient) {
  Config config = fixed_widths();
  config.depth = 1;
  ScreenTriangle t = triangle({100, 100}, {200000, 5000}, {3000, 150000});
  for (ScreenVertex& vertex : t.v) vertex.z = 0.3, vertex.uv = {0.7, 0.1}, vertex.N = {0.6, 0, 0.8};
  const auto packets = set_up(config, t, bumped(), 1024, 1024);
  ASSERT_FALSE(packets.empty());
  for (const TriangleWords& packet : packets) {
    for (std::size_t p :
         {place_of(config, "n", 0), place_of(config, "n", 2), place_of(config, "u"), place_of(config, "z")}) {
      EXPECT_EQ(packet.planes[p].dw, 0);
      EXPECT_EQ(packet.planes[p].row, 0);
      EXPECT_EQ(packet.planes[p].value, packets[0].planes[p].value);
    }
  }
}

TEST(Extremes, E14_GreatestGradient) {
  Random random(14);
  Worst worst;
  for (int i = 0; i < 400; ++i) {
    const Config config = affine(random, 6);
    const int one = 1 << config.subpixel_bits;
    const Point a{static_cast<int>(random.integer(8, 55)) * one + one / 2,
                  static_cast<int>(random.integer(8, 55)) * one + one / 2};
    // One sub-pixel across, the corner values at opposite ends.
    ScreenTriangle t =
        i % 2 == 0 ? triangle(a, {a.x + 1, a.y}, {a.x, a.y + 1}) : triangle(a, {a.x + 1, a.y}, {a.x, 64 * one - 1});
    for (std::size_t k = 0; k < 3; ++k) {
      const double s = k == 1 ? -1 : 1;
      t.v[k].N = {s, 0, 0}, t.v[k].L = {0, -s, 0}, t.v[k].H = {0, 0, s};
      t.v[k].uv = {s * 0.9, -s * 0.9}, t.v[k].z = k == 1 ? 1 : 0;
    }
    measure(config, t, worst);
  }
  EXPECT_LE(worst.over_bound, 1);
  EXPECT_GT(worst.pixels, 1000);
}

// The accumulators may wrap. Set-up keeps values clear of the ends of their formats, so that none inside a triangle
// does.
TEST(Extremes, E15_TheEndsOfTheFormatAreNotCrossed) {
  Random random(15);
  for (int guard_bits : {4, 8, 12}) {
    Config config = fixed_widths();
    config.screen_bits = 12;
    config.guard_bits = guard_bits;
    config.perspective = 1;
    for (double z : {0.0, 1.0}) {
      ScreenTriangle t = triangle({0, 0}, {2 * 4096 * 256 - 1, 7}, {11, 2 * 4096 * 256 - 1});
      // Gradients of a fraction of the last guard bit accumulate the most.
      for (ScreenVertex& v : t.v)
        v.z = std::abs(z - random.real(0, 1e-7)), v.q = 1 - random.real(0, 1e-7), v.uv = {0.5, 0.5};
      for (const TriangleWords& packet : set_up(config, t, bumped(), 4096, 4096)) {
        const auto formats = plane_formats(config);
        walk(packet, [&](const Visit& visit) {
          if ((visit.x & 63) != 63 && visit.x != 0) return;
          for (std::size_t p = 0; p < formats.size(); ++p) {
            const double value = static_cast<double>(code(config, formats[p], visit.accumulator[p])) *
                                 std::ldexp(1.0, -formats[p].fraction_bits);
            if (formats[p].name == "z") {
              ASSERT_NEAR(value, z, 0.01);
            }
            if (formats[p].name == "q") {
              ASSERT_GT(value, 0.99);
            }
          }
        });
      }
    }
  }
}

TEST(Extremes, E16_AccumulatedError) {
  Random random(16);
  Config config = fixed_widths();
  config.screen_bits = 12;
  config.guard_bits = 12;
  Worst worst;
  for (int i = 0; i < 30; ++i) {
    const auto far = [&] { return static_cast<int>(4096 * 256 - random.integer(0, 999)); };
    const auto near = [&] { return static_cast<int>(random.integer(0, 999)); };
    ScreenTriangle t = i % 2 == 0 ? triangle({near(), near()}, {far(), far()}, {near() + 700, near()})
                                  : triangle({near(), far()}, {far(), near()}, {far(), near() + 700});
    randomize_attributes(random, t);
    measure(config, t, worst);
  }
  RecordProperty("worst_lsb", std::to_string(worst.lsb));
  EXPECT_LE(worst.over_bound, 1);
  EXPECT_LT(worst.lsb, 1.5);  // half an LSB of rounding and less than one accumulated over 4096 + 4096 steps
  EXPECT_GT(worst.pixels, 100'000);
}

TEST(Extremes, E17_MismatchAcrossASharedEdge) {
  Random random(17);
  const Config config = fixed_widths();
  const auto value_on_edge = [&](const ScreenTriangle& t, int x, int y, std::size_t p) {
    const TriangleWords packet = set_up(config, t, bumped(), 64, 64).at(0);
    const PlaneWords& plane = packet.planes[p];
    const std::int64_t w = packet.mirror ? -1 - x : x;
    const std::int64_t dy = plane.row - packet.start.step * plane.dw;
    const std::int64_t value = plane.value + (w - packet.start.w) * plane.dw + (y - packet.y) * dy;
    return code(config, plane_formats(config)[p], value);
  };
  for (int i = 0; i < 300; ++i) {
    // The shared edge runs through pixel centres.
    const int edge = 32 * 256 + 128;
    ScreenTriangle left = triangle({edge, 500}, {edge, 15000}, {static_cast<int>(random.integer(0, 8000)), 7000});
    randomize_attributes(random, left);
    ScreenTriangle right = left;
    right.v[2].x = 17000 - right.v[2].x;
    right.v[2].N = random.unit_vector();
    for (int y = 3; y < 58; ++y) {
      for (std::size_t p = place_of(config, "n"); p < place_of(config, "l"); ++p) {
        ASSERT_LE(std::abs(value_on_edge(left, 32, y, p) - value_on_edge(right, 32, y, p)), 1);
      }
    }
  }
}

}  // namespace
}  // namespace wrinkle

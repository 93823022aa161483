// light against its exact twin, stage by stage: the twin gets the very unit vectors that the hardware got.
#include "golden/exact/light.h"

#include <cmath>

#include "tests/stage/support.h"

namespace wrinkle {
namespace {

using Batch64 = Batch<std::int64_t>;

Vec3 real(Columns<std::int64_t> columns, std::size_t i, int fraction_bits) {
  const auto scaled = [&](std::size_t k) { return std::ldexp(static_cast<double>(columns[k][i]), -fraction_bits); };
  return {scaled(0), scaled(1), scaled(2)};
}

TEST(Light, LanesAgree) { expect_lanes_agree(kLight, 8); }

// The vector times its scale, where it has one.
Vec3 real(const Shape& config, const Batch64& batch, Columns<std::int64_t> columns, std::size_t k, std::size_t i) {
  const Vec3 v = real(columns, i, config.unit_bits);
  return config.normalizes_after != 0
             ? std::ldexp(static_cast<double>(batch.normalize_scale[k][i]), -config.scale_bits) * v
             : v;
}

// Of N.L and N.H in ulp of u1.DF: half for the result, and where it is scaled, half of the dot product by the scales
// and the other way round.
double dot_bound(const Shape& config, const Batch64& batch, Columns<std::int64_t> other, std::size_t k, std::size_t i) {
  if (config.normalizes_after == 0) return 0.5;
  const auto scale = [&](std::size_t e) {
    return std::ldexp(static_cast<double>(batch.normalize_scale[e][i]), -config.scale_bits);
  };
  const double cosine = dot(real(batch.normalize_n, i, config.unit_bits), real(other, i, config.unit_bits));
  return 0.5 + (scale(0) * scale(k) + std::abs(cosine)) / 2 + std::ldexp(1.0, -config.dot_bits - 2);
}

// Error of p in ulp of u1.PF for an exact N.H: that of N.H in ulp of u1.DF at first, at most doubled and rounded by
// each squaring.
double power_bound(const Config& config, int squarings, double of_dot = 0.5) {
  const double ulp = std::ldexp(1.0, -config.power_bits);
  double error = std::ldexp(of_dot, config.power_bits - config.dot_bits);
  for (int k = 0; k < squarings; ++k) error = 2 * error + error * error * ulp + 0.5;
  return std::min(error, std::ldexp(1.0, config.power_bits));
}

TEST(Light, DotsPowersAndShadowsStayWithinTheirBounds) {
  Worst nl("light nl, ulp of u1.DF", 0.5), nh("light nh, ulp of u1.DF", 0.5);
  Worst scaled("light nl and nh scaled after, share of their bound", 1);
  Worst reflection("light R.E, share of its bound", 1);
  Worst power("light (N.H)^n without shadow, share of its bound", 1);
  Worst diffuse("light diffuse, no or hard shadow, ulp of u1.DF", 0.5),
      smooth("light diffuse, smooth, ulp of u1.DF", 5);
  std::uint64_t seed = base_seed();
  for (const auto& [name, config] : configurations(40)) {
    SCOPED_TRACE(name);
    Random random(++seed);
    Context context = random_context(config, random);
    auto batch = std::make_unique<Batch64>(context.config);
    fill(config, seed, *batch);
    batch->count = kBatch;
    batch = run_one(context, kLight, std::move(batch));
    const DrawWords& draw = context.draw;
    const bool shadowed = draw.shadow && config.self_shadow != 0;
    const double one = std::ldexp(1.0, config.dot_bits);
    for (std::size_t i = 0; i < kBatch; ++i) {
      const Vec3 n = real(context.config, *batch, batch->normalize_n, 0, i),
                 l = real(context.config, *batch, batch->normalize_l, 1, i),
                 h = context.config.glossy != 0 ? real(context.config, *batch, batch->normalize_h, 2, i) : Vec3{};
      const bool after = context.config.normalizes_after != 0;
      const double nl_bound = dot_bound(context.config, *batch, batch->normalize_l, 1, i);
      const double nh_bound =
          context.config.glossy != 0 ? dot_bound(context.config, *batch, batch->normalize_h, 2, i) : 0;
      DrawWords words = draw;
      words.shadow = shadowed;
      exact::Lit lit;
      exact::dots(context.config, n, l, h, lit);
      exact::power(context.config, words, l.z, lit);
      const auto got = [&](const auto& columns) { return static_cast<double>(columns[0][i]); };
      const double nl_error = got(batch->light_nl) - one * lit.nl;
      if (after)
        scaled.see(nl_error / nl_bound);
      else
        nl.see(nl_error);
      const double error = got(batch->light_diffuse) - one * lit.diffuse;
      const bool at_edge = l.z > 0 && l.z * one < 0.5;  // hard: L.z rounds to 0 and cuts off
      if (shadowed && config.self_shadow == 2)
        smooth.see(error);
      else if (!after && (!shadowed || !draw.bump || !at_edge))
        diffuse.see(error);
      if (context.config.glossy == 0) continue;
      const double nh_error = got(batch->light_nh) - one * lit.nh;
      if (config.is(Lighting::kReflection)) {
        // N.L and N.E are rounded to s1.F before they are multiplied, which moves R.E by at most 2^(1-F).
        reflection.see(nh_error / (0.5 + std::ldexp(1.01, config.dot_bits + 1 - config.unit_bits)));
        continue;
      }
      if (after)
        scaled.see(nh_error / nh_bound);
      else
        nh.see(nh_error);
      if (!shadowed)
        power.see((got(batch->light_specular) - std::ldexp(lit.specular, config.power_bits)) /
                  std::max(0.5, draw.exponent_zero ? 0 : power_bound(config, draw.squarings, nh_bound)));
    }
  }
}

// Sets N, L, H of fragment 0 and shades it.
struct Lighting1 {
  Context context;
  std::unique_ptr<Batch64> batch = std::make_unique<Batch64>(context.config);
  explicit Lighting1(const Config& config, DrawWords draw = {}) : context(make_context(config)) {
    set_draw(context, draw, nullptr);
    batch->count = 1;
  }
  void shade(std::array<std::int64_t, 3> n, std::array<std::int64_t, 3> l, std::array<std::int64_t, 3> h) {
    for (std::size_t k = 0; k < 3; ++k) {
      batch->normalize_n[k][0] = n[k];
      batch->normalize_l[k][0] = l[k];
      if (!batch->normalize_h.empty()) batch->normalize_h[k][0] = h[k];
    }
    batch = run_one(context, kLight, std::move(batch));
  }
  std::int64_t nl() const { return batch->light_nl[0][0]; }
  std::int64_t nh() const { return batch->light_nh[0][0]; }
  std::int64_t diffuse() const { return batch->light_diffuse[0][0]; }
  std::int64_t specular() const { return batch->light_specular[0][0]; }
};

// 32-34: N.L exactly 0 and one LSB beside, negative, above 1.
TEST(Light, ExtremesOfDots) {
  const Config config = with({{&Config::unit_bits, 8}, {&Config::dot_bits, 16}, {&Config::power_bits, 16}});
  Lighting1 one(config);
  one.shade({0, 0, 256}, {256, 0, 0}, {0, 0, 256});
  EXPECT_EQ(one.nl(), 0) << "32";
  one.shade({0, 1, 255}, {0, 1, 0}, {0, 0, 256});
  EXPECT_EQ(one.nl(), 1) << "32: +1 LSB";
  one.shade({0, 1, 255}, {0, -1, 0}, {0, 0, 256});
  EXPECT_EQ(one.nl(), 0) << "32: -1 LSB";
  one.shade({0, 0, -256}, {0, 0, 256}, {0, 0, -256});
  EXPECT_EQ(one.nl(), 0) << "33";
  EXPECT_EQ(one.nh(), 65536);
  one.shade({148, 148, 148}, {148, 148, 148}, {148, 149, 148});
  EXPECT_EQ(one.nl(), 65536) << "34: 148^2 * 3 is above 1";
  EXPECT_EQ(one.nh(), 65536) << "34";
}

// Scaled after: a cosine of 1 is at most 1, a right angle is 0, whatever the lengths; zero vectors have no light.
TEST(Light, ExtremesOfScaledDots) {
  const Config config = deferred({{&Config::unit_bits, 8}, {&Config::dot_bits, 8}, {&Config::power_bits, 8}});
  Lighting1 one(config);
  const auto scales = [&](std::array<std::int64_t, 3> s) {
    for (std::size_t k = 0; k < 3; ++k) one.batch->normalize_scale[k][0] = s[k];
  };
  scales({512, 512, 512});
  one.shade({0, 0, 255}, {0, 0, 255}, {0, 255, 0});
  EXPECT_EQ(one.nl(), 254) << "255/256 squared is .99220";
  EXPECT_EQ(one.nh(), 0) << "32";
  scales({1023, 512, 1023});
  one.shade({128, 0, 0}, {128, 0, 0}, {-128, 0, 0});
  EXPECT_EQ(one.nl(), 128) << "halves of a length that is halved once";
  EXPECT_EQ(one.nh(), 0) << "33";
  scales({1023, 1023, 1023});
  one.shade({255, 255, 255}, {255, 255, 255}, {0, 0, 0});
  EXPECT_EQ(one.nl(), 256) << "34: 12 saturates";
  EXPECT_EQ(one.nh(), 0) << "a zero vector";
}

// R = 2 (N.L) N - L: the mirror direction is 1, and below the horizon there is nothing.
TEST(Light, ReflectionOfTheLight) {
  const Config config = with({{&Config::lighting, 2}, {&Config::unit_bits, 8}, {&Config::dot_bits, 10}});
  Lighting1 one(config);
  one.shade({0, 0, 256}, {154, 0, 205}, {-154, 0, 205});  // 3-4-5
  EXPECT_NEAR(static_cast<double>(one.nh()), 1024, 3);
  one.shade({0, 0, 256}, {154, 0, 205}, {205, 0, -154});
  EXPECT_EQ(one.nh(), 0) << "at right angles to R and below";
  one.shade({0, 0, 256}, {0, 0, 256}, {0, 154, 205});
  EXPECT_NEAR(static_cast<double>(one.nh()), 1024 * 205 / 256.0, 1) << "R is N";
  one.shade({0, 0, -256}, {0, 0, 256}, {0, 0, 256});
  EXPECT_EQ(one.nh(), 0) << "N.L is negative, though R.E is 1";
  one.shade({0, 0, 256}, {256, 0, 0}, {-256, 0, 0});
  EXPECT_EQ(one.nh(), 0) << "N.L is exactly 0";
}

// 35, 36: exponents 0, 1 and the greatest, at N.H = 1 and one LSB below.
TEST(Light, ExtremesOfPowers) {
  const Config config = with({{&Config::unit_bits, 8}, {&Config::dot_bits, 10}, {&Config::specular_squarings, 8}});
  for (int squarings = 0; squarings <= 8; ++squarings) {
    DrawWords draw;
    draw.squarings = squarings;
    Lighting1 one(config, draw);
    one.shade({0, 0, 256}, {0, 0, 256}, {0, 0, 256});
    EXPECT_EQ(one.specular(), 4096) << "1^n is 1 for n = 2^" << squarings;
    one.shade({0, 0, 256}, {0, 0, 256}, {0, 0, 0});
    EXPECT_EQ(one.specular(), 0);
    one.shade({0, 0, 256}, {0, 0, 256}, {0, 0, 255});
    EXPECT_NEAR(static_cast<double>(one.specular()), 4096 * std::pow(1020 / 1024.0, 1 << squarings),
                power_bound(config, squarings));
    EXPECT_LT(one.specular(), 4096) << "35: below 1 stays below 1";
  }
  DrawWords draw;
  draw.exponent_zero = true;
  Lighting1 zero(config, draw);
  zero.shade({0, 0, 256}, {0, 0, 256}, {0, 0, 0});
  EXPECT_EQ(zero.specular(), 4096) << "36: n = 0";
}

// [Peercy97 section 4]: light below the unperturbed surface is cut off, or faded over 8 N.L; the highlight with it.
TEST(Light, SelfShadow) {
  DrawWords draw;
  draw.bump = draw.shadow = true;
  for (int mode : {1, 2}) {
    Lighting1 one(with({{&Config::self_shadow, mode}, {&Config::unit_bits, 8}}), draw);
    one.shade({0, 181, 181}, {0, 256, 0}, {0, 181, 181});
    EXPECT_GT(one.nl(), 0);
    EXPECT_EQ(one.diffuse(), 0) << "light in the tangent plane";
    EXPECT_EQ(one.specular(), 0);
    one.shade({0, 181, 181}, {0, 256, 8}, {0, 181, 181});
    const double factor = mode == 1 ? 1 : 8 * 8 / 256.0;
    EXPECT_NEAR(static_cast<double>(one.diffuse()), static_cast<double>(one.nl()) * factor, 0.5);
    one.shade({0, 0, 256}, {0, 0, 256}, {0, 0, 256});
    EXPECT_EQ(one.diffuse(), 1024);
    EXPECT_EQ(one.specular(), 4096);
    one.shade({0, -256, 0}, {0, 181, 181}, {0, -256, 0});
    EXPECT_EQ(one.specular(), 0) << "no highlight where N.L is 0";
  }
}

}  // namespace
}  // namespace wrinkle

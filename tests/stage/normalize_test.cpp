// normalize: faithful for every F, exact on the axes, odd-symmetric; the extremes of vectors, 19-28.
#include "golden/exact/normalize.h"

#include <cmath>
#include <fstream>
#include <sstream>

#include "golden/pixel/probe.h"
#include "tests/stage/support.h"

namespace wrinkle {
namespace {

using Vector = std::array<std::int64_t, 3>;

// normalize of many vectors, by a context made once.
class Unit {
 public:
  Unit(int unit_bits, int vector_bits, Normalizer kind = Normalizer::kFaithful)
      : context_(make_context(with({{&Config::unit_bits, unit_bits},
                                    {&Config::vector_bits, vector_bits},
                                    {&Config::dot_bits, 6},
                                    {&Config::normalizer_n, static_cast<int>(kind)}}))) {}

  const Config& config() const { return context_.config; }
  Vector operator()(const Vector& v) {
    for (std::size_t k = 0; k < 3; ++k) batch_->perturb_n[k][0] = v[k];
    batch_->count = 1;
    run_checked(context_, kNormalize, *spans_, *batch_);
    return {batch_->normalize_n[0][0], batch_->normalize_n[1][0], batch_->normalize_n[2][0]};
  }

 private:
  Context context_;
  std::unique_ptr<Batch<std::int64_t>> batch_ = std::make_unique<Batch<std::int64_t>>(context_.config);
  std::unique_ptr<Spans<std::int64_t>> spans_ = std::make_unique<Spans<std::int64_t>>();
};

// Error against real arithmetic, in ulp of s1.F.
double error_ulp(const Config& config, const Vector& v, const Vector& n) {
  const Vec3 exact =
      exact::normalize(1, {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])});
  const double one = std::ldexp(1.0, config.unit_bits);
  return std::max({std::abs(static_cast<double>(n[0]) - one * exact.x),
                   std::abs(static_cast<double>(n[1]) - one * exact.y),
                   std::abs(static_cast<double>(n[2]) - one * exact.z)});
}

std::string print(const Vector& v) {
  return std::to_string(v[0]) + ' ' + std::to_string(v[1]) + ' ' + std::to_string(v[2]);
}

Vector random_vector(Random& random, int vector_bits) {
  const std::int64_t limit = std::int64_t{2} << vector_bits;
  Vector v;
  if (uniform(random, 0, 3) == 0) {
    const std::int64_t small = std::int64_t{1} << uniform(random, 0, vector_bits);
    for (auto& c : v) c = uniform(random, -small, small);
  } else {
    for (auto& c : v) c = pattern(random, {-limit, limit - 1});
  }
  return v;
}

TEST(Normalize, LanesAgree) { expect_lanes_agree(kNormalize, 8); }

class NormalizeF : public testing::TestWithParam<int> {
 protected:
  int f() const { return GetParam(); }
  void expect_faithful(Normalizer kind, const std::string& name);
  void expect_extremes(Normalizer kind);
};

// -2^(V+1) saturates to -(2^(V+1) - 1), which costs at most the share of one input LSB: it is left out here and has its
// own test (22, 23).
void NormalizeF::expect_faithful(Normalizer kind, const std::string& name) {
  Worst worst("normalize " + name + ", F = " + std::to_string(f()) + ", ulp", 1.0);
  Random random(base_seed());
  for (int v_bits = 5; v_bits <= 18; ++v_bits) {
    Unit unit(f(), v_bits, kind);
    for (int i = 0; i < 3000; ++i) {
      Vector v = random_vector(random, v_bits);
      for (auto& c : v) c = std::max(c, 1 - (std::int64_t{2} << v_bits));
      if (v == Vector{}) continue;
      const Vector n = unit(v);
      worst.see(error_ulp(unit.config(), v, n), print(v));
      ASSERT_EQ(unit({-v[0], -v[1], -v[2]}), (Vector{-n[0], -n[1], -n[2]})) << print(v);
    }
  }
  EXPECT_LT(worst.worst(), 1.0);
}

TEST_P(NormalizeF, IsFaithful) { expect_faithful(Normalizer::kFaithful, "faithful"); }
TEST_P(NormalizeF, CompactIsFaithful) { expect_faithful(Normalizer::kCompact, "compact"); }

void NormalizeF::expect_extremes(Normalizer kind) {
  for (int v_bits : {5, 6, 7, 10, 15, 18}) {
    Unit unit(f(), v_bits, kind);
    const std::int64_t one = std::int64_t{1} << f(), low = -(std::int64_t{2} << v_bits), high = -low - 1;
    SCOPED_TRACE("V = " + std::to_string(v_bits));
    EXPECT_EQ(unit({0, 0, 0}), Vector{}) << "19, 21: the zero vector stays zero";
    for (std::int64_t c = 1; c <= high; c = 2 * c + 1) {
      EXPECT_EQ(unit({c, 0, 0}), (Vector{one, 0, 0})) << "27: exactly +1, length " << c;
      EXPECT_EQ(unit({0, -c, 0}), (Vector{0, -one, 0})) << "27: exactly -1, length " << c;
    }
    EXPECT_EQ(unit({0, 0, 1}), (Vector{0, 0, one})) << "24: a single LSB";
    EXPECT_EQ(unit({0, low, 0}), (Vector{0, -one, 0})) << "22";
    const Vector all_low = unit({low, low, low}), all_high = unit({high, high, high});
    EXPECT_EQ(all_low, (Vector{-all_high[0], -all_high[1], -all_high[2]})) << "22: -2^(V+1) is -(2^(V+1) - 1)";
    const Vector mixed = unit({low, high, low});
    EXPECT_EQ(mixed, (Vector{-all_high[0], all_high[1], -all_high[2]})) << "23";
    for (const Vector& v : {Vector{1, 1, 0}, Vector{0, -1, 1}, Vector{1, -1, 1}, Vector{-1, 0, 1}}) {
      const Vector n = unit(v);  // 20: direction and length right, however short the vector
      EXPECT_LT(error_ulp(unit.config(), v, n), 1.0) << "20: " << print(v);
    }
  }
}

TEST_P(NormalizeF, ExtremesOfVectors) { expect_extremes(Normalizer::kFaithful); }
TEST_P(NormalizeF, ExtremesOfVectorsCompact) { expect_extremes(Normalizer::kCompact); }

// 25: sums of squares about powers of four; 26: T at each segment boundary and its neighbours, for every length.
TEST_P(NormalizeF, SumsAboutPowersOfFourAndSegmentBoundaries) {
  const int v_bits = 10;
  Unit unit(f(), v_bits);
  const RsqrtGeometry& g = rsqrt_geometry(f());
  const std::int64_t limit = (std::int64_t{2} << v_bits) - 1;
  double worst = 0;
  const auto see = [&](std::int64_t sum) {
    // A vector whose sum of squares is close to `sum`.
    const auto x = static_cast<std::int64_t>(isqrt(static_cast<std::uint64_t>(sum) * 2 / 3));
    const auto y = static_cast<std::int64_t>(isqrt(static_cast<std::uint64_t>(std::max<std::int64_t>(sum - x * x, 0))));
    for (std::int64_t z : {0, 1, 2}) {
      if (x > limit || y > limit || x + y + z == 0) continue;
      worst = std::max(worst, error_ulp(unit.config(), {x, -y, z}, unit({x, -y, z})));
    }
  };
  for (int k = 1; k <= v_bits + 1; ++k)
    for (std::int64_t d = -1; d <= 1; ++d) see((std::int64_t{1} << (2 * k)) + d);
  const int up = 2 * v_bits + 4 - g.input_bits;
  for (int j = 1 << g.segment_bits; j <= 4 << g.segment_bits; ++j) {
    for (std::int64_t d = -1; d <= 1; ++d) {
      const std::int64_t t = (std::int64_t{j} << (g.input_bits - 2 - g.segment_bits)) + d;
      const std::int64_t sum = up >= 0 ? t << up : t >> -up;
      see(sum >> 2);
      see(sum);
    }
  }
  EXPECT_LT(worst, 1.0);
}

// The largest sum, and 28: halves round away from zero, the same on both sides.
TEST_P(NormalizeF, LargestSumAndTies) {
  Unit unit(f(), 18);
  const std::int64_t high = (std::int64_t{2} << 18) - 1;
  const Vector n = unit({high, high, high});
  EXPECT_LT(error_ulp(unit.config(), {high, high, high}, n), 1.0) << "26: the largest sum";
  for (std::int64_t c = 1; c < 40; ++c) {
    const Vector up = unit({c, 40 - c, 7}), down = unit({-c, c - 40, -7});
    EXPECT_EQ(up, (Vector{-down[0], -down[1], -down[2]})) << "28: c = " << c;
  }
}

// Mantissa and scale of one N, normalized after the dot products.
class DeferredUnit {
 public:
  struct Result {
    Vector m;
    std::int64_t scale;
    bool zero;
  };

  DeferredUnit(int unit_bits, int vector_bits)
      : context_(make_context(
            deferred({{&Config::unit_bits, unit_bits}, {&Config::vector_bits, vector_bits}, {&Config::dot_bits, 6}}))) {
  }

  Result operator()(const Vector& v) {
    for (std::size_t k = 0; k < 3; ++k) batch_->perturb_n[k][0] = v[k];
    batch_->interpolate_l[0][0] = batch_->interpolate_h[0][0] = 1;
    batch_->count = 1;
    run_checked(context_, kNormalize, *spans_, *batch_);
    const auto& n = batch_->normalize_n;
    return {{n[0][0], n[1][0], n[2][0]}, batch_->normalize_scale[0][0], batch_->normalize_zero[0][0] != 0};
  }

 private:
  Context context_;
  std::unique_ptr<Batch<std::int64_t>> batch_ = std::make_unique<Batch<std::int64_t>>(context_.config);
  std::unique_ptr<Spans<std::int64_t>> spans_ = std::make_unique<Spans<std::int64_t>>();
};

// The mantissa is the leading F bits, cut, of what is shifted until the greatest component is in [1/2, 1); by its
// scale it has a length of 1, within rho of the table and what halving a root cuts off.
TEST_P(NormalizeF, MantissaAndScale) {
  const RsqrtGeometry& g = rsqrt_geometry(f());
  const double halved = std::sqrt(.75) * std::ldexp(1.0, f() - g.output_bits);
  Worst length("mantissa by scale, F = " + std::to_string(f()) + ", length, 2^-F", 0.5 + halved);
  Worst angle("mantissa, F = " + std::to_string(f()) + ", direction, 2^-F", 2 * std::sqrt(3.0));
  Random random(base_seed());
  for (int v_bits = 5; v_bits <= 18; ++v_bits) {
    DeferredUnit unit(f(), v_bits);
    const std::int64_t high = (std::int64_t{2} << v_bits) - 1;
    for (int i = 0; i < 3000; ++i) {
      const Vector v = random_vector(random, v_bits);
      const auto [m, scale, zero] = unit(v);
      ASSERT_EQ(zero, v == Vector{});
      if (zero) continue;
      Vec3 real, mantissa;
      std::int64_t greatest = 0;
      for (auto c : v) greatest = std::max(greatest, std::min(std::abs(c), high));
      const int exponent = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(greatest)));
      for (std::size_t k = 0; k < 3; ++k) {
        const double component = static_cast<double>(std::clamp(v[k], -high, high));
        const double shifted = std::trunc(std::ldexp(component, f() - exponent));
        ASSERT_EQ(static_cast<double>(m[k]), shifted) << print(v);
        const auto axis = std::array{&Vec3::x, &Vec3::y, &Vec3::z}[k];
        real.*axis = component;
        mantissa.*axis = static_cast<double>(m[k]);
      }
      const double one = std::ldexp(wrinkle::length(mantissa) * static_cast<double>(scale), -f() - g.output_bits);
      length.see(std::ldexp(one - 1, f()), print(v));
      const double turned = std::atan2(wrinkle::length(cross(real, mantissa)), dot(real, mantissa));
      angle.see(std::ldexp(turned, f()), print(v));
      const auto opposite = unit({-v[0], -v[1], -v[2]});
      ASSERT_EQ(opposite.m, (Vector{-m[0], -m[1], -m[2]})) << print(v);
      ASSERT_EQ(opposite.scale, scale) << print(v);
    }
  }
}

TEST_P(NormalizeF, ExtremesOfMantissas) {
  const RsqrtGeometry& g = rsqrt_geometry(f());
  const std::int64_t nearly_two = rsqrt(g, rsqrt_table(g), std::int64_t{1} << (g.input_bits - 2));  // t = 1/4
  for (int v_bits : {5, 7, 10, 15, 18}) {
    DeferredUnit unit(f(), v_bits);
    const std::int64_t half = std::int64_t{1} << (f() - 1), high = (std::int64_t{2} << v_bits) - 1;
    SCOPED_TRACE("V = " + std::to_string(v_bits));
    const auto none = unit({0, 0, 0});
    EXPECT_EQ(none.m, Vector{}) << "19, 21";
    EXPECT_EQ(none.scale, nearly_two) << "19: that of t = 1/4";
    const auto least = unit({0, -1, 0});
    EXPECT_EQ(least.m, (Vector{0, -half, 0})) << "24: a single LSB";
    EXPECT_EQ(least.scale, nearly_two);
    EXPECT_EQ(unit({-high - 1, high, 0}).m, unit({-high, high, 0}).m) << "22: -2^(V+1) is -(2^(V+1) - 1)";
    EXPECT_EQ(unit({high, high, high}).scale, unit({-high - 1, high, -high}).scale) << "23";
  }
}

TEST_P(NormalizeF, ZeroIsFlagged) {
  Unit unit(f(), 10);
  Context context = make_context(unit.config());
  auto batch = std::make_unique<Batch<std::int64_t>>(context.config);
  batch->count = 4;  // none zero; N, L, H zero in turn
  for (std::size_t i = 0; i < 4; ++i) {
    batch->perturb_n[0][i] = i == 1 ? 0 : 3;
    batch->interpolate_l[1][i] = i == 2 ? 0 : -1;
    batch->interpolate_h[2][i] = i == 3 ? 0 : 9;
  }
  batch = run_one(context, kNormalize, std::move(batch));
  EXPECT_EQ(batch->normalize_zero[0][0], 0);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(batch->normalize_zero[0][i], 1) << i;
}

INSTANTIATE_TEST_SUITE_P(EveryF, NormalizeF, testing::Range(6, 17),
                         [](const auto& f) { return "F" + std::to_string(f.param); });

// Interpolated between unit vectors less than 120 degrees apart, a vector is 1/2 to 1 long: there `near` is faithful. A
// vector of any other length keeps its signs and stays in s1.F.
TEST_P(NormalizeF, NearIsFaithfulFromHalfToOne) {
  Worst worst("normalize near, F = " + std::to_string(f()) + ", ulp", 1.0);
  Random random(base_seed());
  for (int v_bits : {5, 8, 9, 12, 16, 18}) {
    Unit unit(f(), v_bits, Normalizer::kNear);
    const std::int64_t one = std::int64_t{1} << v_bits, most = std::int64_t{2} << f();
    EXPECT_EQ(unit({0, 0, 0}), Vector{});
    EXPECT_EQ(unit({one, 0, 0}), (Vector{most / 2, 0, 0}));
    EXPECT_EQ(unit({0, -one / 2, 0}), (Vector{0, -most / 2, 0}));
    for (int i = 0; i < 5000; ++i) {
      const Vector v{uniform(random, -one, one), uniform(random, -one, one), uniform(random, -one, one)};
      const Vector n = unit(v);
      const std::int64_t squared = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
      if (4 * squared >= one * one && squared <= one * one) worst.see(error_ulp(unit.config(), v, n), print(v));
      for (std::size_t k = 0; k < 3; ++k) {
        ASSERT_TRUE(n[k] == 0 || (n[k] < 0) == (v[k] < 0)) << print(v);
        ASSERT_LT(std::abs(n[k]), most) << print(v);
      }
      ASSERT_EQ(unit({-v[0], -v[1], -v[2]}), (Vector{-n[0], -n[1], -n[2]})) << print(v);
    }
  }
  EXPECT_LT(worst.worst(), 1.0);
}

// `lite`: sqrt(3) / 2 ulp of rounding at the least length turn a vector by no more than this; its length is within 3 %.
TEST_P(NormalizeF, LiteKeepsTheDirection) {
  constexpr double kDegrees = 57.29577951308232;
  const double bound = std::asin(std::ldexp(std::sqrt(0.75), -f()) / 0.97) * kDegrees;
  Worst worst("normalize lite, F = " + std::to_string(f()) + ", degrees", bound);
  Random random(base_seed());
  for (int v_bits : {5, 8, 9, 12, 18}) {
    Unit unit(f(), v_bits, Normalizer::kLite);
    EXPECT_EQ(unit({0, 0, 0}), Vector{});
    for (int i = 0; i < 5000; ++i) {
      Vector v = random_vector(random, v_bits);
      for (auto& c : v) c = std::max(c, 1 - (std::int64_t{2} << v_bits));
      if (v == Vector{}) continue;
      const Vector n = unit(v);
      const Vec3 a{static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
      const Vec3 b{static_cast<double>(n[0]), static_cast<double>(n[1]), static_cast<double>(n[2])};
      const double sine = length(cross(a, b)) / (length(a) * length(b));
      worst.see(std::asin(sine) * kDegrees, print(v));
      const double rounding = std::ldexp(1.0, -f());
      ASSERT_NEAR(std::ldexp(length(b), -f()), 1.0, 0.03 + rounding) << print(v);
      ASSERT_EQ(unit({-v[0], -v[1], -v[2]}), (Vector{-n[0], -n[1], -n[2]})) << print(v);
    }
  }
  EXPECT_LE(worst.worst(), bound);
}

// `none`: saturate(round_half_up(v, V - F)), half an ulp unless it saturates.
TEST(Normalize, NoneRounds) {
  Worst worst("normalize none, ulp", 0.5);
  for (int f : {6, 8, 12, 16}) {
    for (int v_bits : {5, 8, 10, 18}) {
      const Config config = with({{&Config::unit_bits, f},
                                  {&Config::vector_bits, v_bits},
                                  {&Config::dot_bits, 6},
                                  {&Config::normalizer_n, 0}});
      const std::int64_t limit = std::int64_t{2} << v_bits, most = (std::int64_t{2} << f) - 1;
      for (std::int64_t x :
           {-limit, 1 - limit, std::int64_t{-1}, std::int64_t{0}, std::int64_t{1}, limit / 3, limit - 1}) {
        const std::int64_t n = normalize_vector(config, {x, 1, 1})[0];
        const double exact = std::ldexp(static_cast<double>(x), f - v_bits);
        ASSERT_LE(n, most);
        worst.see(exact > static_cast<double>(most) ? std::max(0.0, exact - 0.5 - static_cast<double>(n))
                                                    : static_cast<double>(n) - exact);
      }
    }
  }
}

std::ifstream shared_vectors(const std::string& name) {
  return std::ifstream(std::string(WRINKLE_SHARED_DIR) + "/assets/vectors/" + name);
}

// Vectors of 16-bit integers with their correctly rounded unit vectors, made elsewhere: Q1.30 is exact enough for all
// F.
TEST_P(NormalizeF, VectorsMadeElsewhere) {
  std::ifstream in = shared_vectors("normalize_exact.txt");
  if (!in) GTEST_SKIP() << "../shared/assets/vectors/normalize_exact.txt is not there";
  Worst worst("normalize_exact.txt, F = " + std::to_string(f()) + ", ulp", 1.0);
  Unit unit(f(), 14);
  int count = 0;
  for (std::string line; std::getline(in, line);) {
    std::istringstream fields(line);
    Vector v, want{};
    if (line.starts_with('#') || !(fields >> v[0] >> v[1] >> v[2])) continue;
    fields >> want[0] >> want[1] >> want[2];
    const Vector n = unit(v);
    for (std::size_t k = 0; k < 3; ++k)
      worst.see(static_cast<double>(n[k]) - std::ldexp(static_cast<double>(want[k]), f() - 30), line);
    ++count;
  }
  EXPECT_GT(count, 1000);
}

// 2^40 / sqrt(x), correctly rounded: normalized to t in [1/4, 1) it checks r itself, within the error that T and rho
// allow: rho ulp of s1.F for r sqrt(t).
TEST_P(NormalizeF, RootsMadeElsewhere) {
  std::ifstream in = shared_vectors("rsqrt_exact.txt");
  if (!in) GTEST_SKIP() << "../shared/assets/vectors/rsqrt_exact.txt is not there";
  Worst worst("rsqrt_exact.txt, F = " + std::to_string(f()) + ", ulp", 0.5);
  const RsqrtGeometry& g = rsqrt_geometry(f());
  const auto table = rsqrt_table(g);
  int count = 0;
  for (std::string line; std::getline(in, line);) {
    std::istringstream fields(line);
    std::uint64_t x;
    double y;
    if (line.starts_with('#') || !(fields >> x >> y)) continue;
    const int width = (64 - std::countl_zero(x) + 1) / 2 * 2;  // x / 2^width is in [1/4, 1)
    const int down = width - g.input_bits;
    const auto t = static_cast<std::int64_t>(down >= 0 ? x >> down : x << -down);
    const double root = std::ldexp(y, width / 2 - 40);
    const double relative = std::ldexp(static_cast<double>(rsqrt(g, table, t)), -g.output_bits) / root - 1;
    worst.see(std::ldexp(relative, f()), line);
    ++count;
  }
  EXPECT_GT(count, 1000);
}

}  // namespace
}  // namespace wrinkle

// The tables of the normalizer and of the perspective division, proven by enumeration in exact integers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "golden/pixel/compact_geometry.h"
#include "golden/pixel/context.h"
#include "golden/pixel/reciprocal.h"
#include "golden/pixel/rsqrt.h"

namespace wrinkle {
namespace {

__extension__ using Int128 = __int128;

class Rsqrt : public testing::TestWithParam<RsqrtGeometry> {};

// rho < 1/2: for every T, (1 - 2^-(F+1)) < r sqrt(t) for the least t of T, r sqrt(t) <= (1 + 2^-(F+1)) for their
// supremum, which no t reaches. Squared, both sides are integers.
TEST_P(Rsqrt, IsFaithfulForEveryVector) {
  const RsqrtGeometry g = GetParam();
  const auto table = rsqrt_table(g);
  const Int128 one = Int128{1} << (g.unit_bits + 1);
  const Int128 scale = Int128{1} << (2 * g.output_bits + g.input_bits);
  double rho = 0;
  for (std::int64_t t = std::int64_t{1} << (g.input_bits - 2); t < std::int64_t{1} << g.input_bits; ++t) {
    const Int128 r = rsqrt(g, table, t);
    ASSERT_GE(r, Int128{1} << g.output_bits) << "r must not be below 1, T = " << t;
    ASSERT_LT(r, Int128{2} << g.output_bits) << "T = " << t;
    ASSERT_LE(r * r * (t + 1) * one * one, (one + 1) * (one + 1) * scale) << "T = " << t;
    ASSERT_GT(r * r * t * one * one, (one - 1) * (one - 1) * scale) << "T = " << t;
    const double real = std::ldexp(static_cast<double>(r), -g.output_bits);
    rho = std::max({rho, real * std::sqrt(std::ldexp(static_cast<double>(t + 1), -g.input_bits)) - 1,
                    1 - real * std::sqrt(std::ldexp(static_cast<double>(t), -g.input_bits))});
  }
  RecordProperty("rho_ulp", std::to_string(std::ldexp(rho, g.unit_bits)));
  std::printf("F %2d: rho %.4f ulp, %d segments\n", g.unit_bits, std::ldexp(rho, g.unit_bits), 2 << g.segment_bits);
}

TEST_P(Rsqrt, SegmentsAreSmall) {
  const RsqrtGeometry g = GetParam();
  const int leading = 1 << (g.output_bits + g.guard_bits);
  for (const Segment& s : rsqrt_table(g)) {
    EXPECT_GT(s.slope, 0);
    EXPECT_LT(s.slope, 1 << kSlopeBits);
    EXPECT_GE(s.base, leading) << "the leading bit is always set";
    EXPECT_LT(s.base, 2 * leading);
  }
}

INSTANTIATE_TEST_SUITE_P(EveryF, Rsqrt, testing::ValuesIn(kRsqrtGeometry),
                         [](const auto& g) { return "F" + std::to_string(g.param.unit_bits); });

// The least and greatest error of a component before it is rounded, in units of 2^-kFine of the lowest bit of m r:
// with S the true sum of squares of the shifted magnitudes, m <= sqrt(S),
//
//   m r - dropped + constant - 2^(F+Q) m / sqrt(S)
//
// is extreme at an end of the interval of S that a T stands for. Every bound is rounded outwards.
class CompactBound {
 public:
  explicit CompactBound(const CompactGeometry& g) : g_(g), table_(compact_rsqrt_table(g.rsqrt)) {
    const std::int64_t low = (std::int64_t{1} << g.square_cut) - 1;
    most_dropped_ = 3 * low * low;
    for (int octave = 0; octave < (g.kind == Normalizer::kNear ? 2 : 4); ++octave)
      for (std::int64_t x = least_x(); x < 2 * least_x(); ++x) see(octave, x);
    const Int128 mean = (g.product_constant - half()) * kOne;
    high_ += mean;
    low_ += mean;
  }
  // No tie and no more than half an ulp: the result is then less than 1 ulp off, and exact where n is 0 or +-1.
  bool is_faithful() const { return high_ < half() * kOne && low_ > -half() * kOne; }
  double ulp() const { return std::ldexp(static_cast<double>(std::max(high_, -low_)), -g_.product_shift() - kFine); }

 private:
  static constexpr int kFine = 12;
  static constexpr Int128 kOne = 1 << kFine;

  std::int64_t least_x() const { return std::int64_t{1} << (g_.rsqrt.input_bits - 2); }
  std::int64_t half() const { return std::int64_t{1} << (g_.product_shift() - 1); }

  // 2^(F + Q + kFine) / sqrt(s), at least or at most.
  Int128 inverse(std::int64_t s, bool above) const {
    const int exponent = g_.unit_bits + g_.product_shift() + kFine;
    const long double real = std::ldexp(1.0L, exponent) / std::sqrt(static_cast<long double>(s));
    return static_cast<Int128>(real) + (above ? 2 : -1);
  }

  // The most that the rows of m r leave out, for any m.
  std::int64_t dropped(std::int64_t r) const {
    std::int64_t sum = 0;
    for (int i = 0; i < g_.product_cut; i += 2) {
      const std::int64_t mask = (std::int64_t{1} << (g_.product_cut - i)) - 1;
      const bool single = i + 1 >= g_.magnitude_bits;
      sum += (single ? r & mask : std::max({r & mask, 2 * r & mask, 3 * r & mask})) << i;
    }
    return sum;
  }

  // S that is computed lies in [x, x + 1) 2^place, its low bits are 0; the true one is up to most_dropped_ more. With
  // `near` the ends take in what saturates there though its true length is between 1/2 and 1.
  void see(int octave, std::int64_t x) {
    const int place = 2 * g_.magnitude_bits - g_.rsqrt.input_bits + octave;
    const std::int64_t unit = std::int64_t{2} << g_.square_cut, largest = (std::int64_t{1} << g_.magnitude_bits) - 1;
    std::int64_t first = ((x << place) + unit - 1) / unit * unit, last = (((x + 1) << place) - 1) / unit * unit;
    if (g_.kind == Normalizer::kNear && octave == 0 && x == least_x()) first -= most_dropped_ / unit * unit;
    if (g_.kind == Normalizer::kNear && octave == 1 && x == 2 * least_x() - 1) last += unit + g_.square_constant;
    if (first > last) return;
    const std::int64_t least = std::max(first - g_.square_constant, std::int64_t{1} << (2 * g_.magnitude_bits - 2));
    const std::int64_t longest =
        g_.kind == Normalizer::kNear ? std::int64_t{1} << (2 * g_.magnitude_bits) : 3 * largest * largest;
    const std::int64_t most = std::min(last + most_dropped_ - g_.square_constant, longest);
    if (least > most) return;
    const int half_range = octave & 1;
    const std::int64_t t = half_range != 0 ? 2 * x : x;
    const std::int64_t r = compact_rsqrt(g_.rsqrt, table_, t) >> (octave >> 1);
    const auto m_least = std::min(static_cast<std::int64_t>(isqrt(static_cast<std::uint64_t>(least))) + 1, largest);
    const auto m_most = std::min(static_cast<std::int64_t>(isqrt(static_cast<std::uint64_t>(most))), largest);
    high_ = std::max(high_, m_most * (r * kOne - inverse(most, false)));
    const Int128 below = m_least * (r * kOne - inverse(least, true));
    low_ = std::min(low_, std::min(below, Int128{0}) - dropped(r) * kOne);
  }

  CompactGeometry g_;
  std::vector<Segment> table_;
  std::int64_t most_dropped_ = 0;
  Int128 high_ = 0, low_ = 0;
};

class CompactTables : public testing::TestWithParam<int> {};

// V up to that of the widest vector, Pu x Pv and its companions. V < F is V = F with zeros below.
TEST_P(CompactTables, FaithfulForEveryVectorOfEveryWidth) {
  const int f = GetParam();
  for (Normalizer kind : {Normalizer::kCompact, Normalizer::kNear}) {
    const char* name = kind == Normalizer::kNear ? "near" : "compact";
    double worst = 0;
    for (int v = f; v <= 23; ++v) {
      const CompactBound bound(compact_geometry(kind, f, v));
      EXPECT_TRUE(bound.is_faithful()) << "V = " << v << ": " << bound.ulp() << " ulp before rounding";
      worst = std::max(worst, bound.ulp());
      if (v == f) std::printf("%s F %2d, V = F: below %.4f ulp\n", name, f, 0.5 + bound.ulp());
    }
    std::printf("%s F %2d, any V: below %.4f ulp\n", name, f, 0.5 + worst);
  }
}

TEST_P(CompactTables, SegmentsAreSmall) {
  for (const CompactRsqrtGeometry& g : {compact_rsqrt_geometry(GetParam()), kLiteRsqrt}) {
    const int leading = 1 << (g.output_bits + g.guard_bits);
    const auto table = compact_rsqrt_table(g);
    for (const Segment& s : table) {
      EXPECT_GE(s.slope, 0);
      EXPECT_LT(s.slope, 1 << std::min(kSlopeBits, g.output_bits + g.guard_bits - g.segment_bits));
      EXPECT_GE(s.base, leading) << "the leading bit is always set";
      EXPECT_LT(s.base, 2 * leading);
    }
    for (std::int64_t t = std::int64_t{1} << (g.input_bits - 2); t < std::int64_t{1} << g.input_bits; ++t) {
      const std::int64_t r = compact_rsqrt(g, table, t);
      ASSERT_GE(r, std::int64_t{1} << g.output_bits) << "T = " << t;
      ASSERT_LT(r, std::int64_t{2} << g.output_bits) << "T = " << t;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(EveryF, CompactTables, testing::Range(6, 17),
                         [](const auto& f) { return "F" + std::to_string(f.param); });

// The squares see 7 bits of each magnitude: every triple of those, largest first, and the interval of true lengths.
TEST(CompactTables, LiteLengthIsWithinThreePercent) {
  const auto table = compact_rsqrt_table(kLiteRsqrt);
  double shortest = 1, longest = 1;
  for (int x = 64; x < 128; ++x)
    for (int y = 0; y <= x; ++y)
      for (int z = 0; z <= y; ++z) {
        const std::int64_t sum = x * x + y * y + z * z + kLiteSquareConstant;
        const int e = sum >> 14 != 0 ? 1 : 0;
        const std::int64_t r = compact_rsqrt(kLiteRsqrt, table, sum >> (14 - kLiteRsqrt.input_bits + 2 * e)) >> e;
        const double scale = std::ldexp(static_cast<double>(r), -kLiteRsqrt.output_bits - 7);
        shortest = std::min(shortest, scale * std::hypot(x, y, z));
        longest = std::max(longest, scale * std::hypot(x + 1, y + 1, z + 1));
      }
  std::printf("lite: length %.4f to %.4f\n", shortest, longest);
  EXPECT_GT(shortest, 0.97);
  EXPECT_LT(longest, 1.03);
}

TEST(Isqrt, IsTheFloor) {
  for (std::uint64_t root : {0ull, 1ull, 2ull, 3ull, 255ull, 65535ull, 65536ull, 4294967295ull}) {
    EXPECT_EQ(isqrt(root * root), root);
    EXPECT_EQ(isqrt(root * root + 2 * root), root);
    if (root > 0) {
      EXPECT_EQ(isqrt(root * root - 1), root - 1);
    }
  }
}

class Reciprocal : public testing::TestWithParam<int> {};

// |r m - 2^(R+Q)| <= m, for every m of every legal Q, that is up to R + 1.
TEST_P(Reciprocal, IsWithinOneUlp) {
  const int output_bits = GetParam();
  double worst = 0;
  for (int input_bits = 8; input_bits <= output_bits + 1; ++input_bits) {
    const ReciprocalGeometry g{input_bits, output_bits};
    const auto table = reciprocal_table(g);
    for (std::int64_t m = std::int64_t{1} << (input_bits - 1); m < std::int64_t{1} << input_bits; ++m) {
      const std::int64_t r = reciprocal(g, table, m);
      const std::int64_t error = std::abs(r * m - (std::int64_t{1} << (output_bits + input_bits)));
      ASSERT_LE(error, m) << "Q = " << input_bits << ", m = " << m;
      ASSERT_GE(r, std::int64_t{1} << output_bits);
      worst = std::max(
          worst, m == std::int64_t{1} << (input_bits - 1) ? 0.0 : static_cast<double>(error) / static_cast<double>(m));
    }
  }
  std::printf("R %2d: worst %.4f ulp without the clamp at 2\n", output_bits, worst);
}

INSTANTIATE_TEST_SUITE_P(EveryR, Reciprocal, testing::Range(8, 21),
                         [](const auto& r) { return "R" + std::to_string(r.param); });

}  // namespace
}  // namespace wrinkle

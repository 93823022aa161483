// The tables of the normalizer and of the perspective division, proven by enumeration in exact integers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

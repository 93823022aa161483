// perspective against the division in real arithmetic.
#include <cmath>

#include "tests/stage/support.h"

namespace wrinkle {
namespace {

TEST(Perspective, LanesAgree) { expect_lanes_agree(kPerspective, 8); }

// u of one fragment.
std::int64_t divide(const Context& context, std::int64_t uq, std::int64_t q) {
  auto batch = std::make_unique<Batch<std::int64_t>>(context.config);
  batch->count = 1;
  batch->interpolate_u[0][0] = uq;
  batch->interpolate_q[0][0] = q;
  return run_one(context, kPerspective, std::move(batch))->perspective_u[0][0];
}

// |error| <= |u| 2^-R + 1/2 ulp: the table is right to 2^-R of 2^lz / q, which is at least 1. What leaves the format
// wraps.
TEST(Perspective, QuotientStaysWithinItsBound) {
  Worst worst("perspective u, share of |u| 2^-R + 1/2", 1);
  Random random(base_seed());
  for (int round = 0; round < 400; ++round) {
    Config config = random_config(random);
    config.perspective = 1;
    config.datapath = 1;
    config.q_bits = std::min(config.q_bits, config.reciprocal_bits + 1);
    ASSERT_EQ(check(config).key, "");
    const Context context = make_context(config);
    const std::int64_t limit = std::int64_t{1} << (Shape(config).uv_width - 1);
    for (int i = 0; i < 40; ++i) {
      const std::int64_t q = pattern(random, {1, (std::int64_t{1} << config.q_bits) - 1});
      const std::int64_t uq = pattern(random, {-limit, limit - 1});
      const double exact = std::ldexp(static_cast<double>(uq) / static_cast<double>(q), config.q_bits);
      const double bound = std::abs(exact) * std::ldexp(1.0, -config.reciprocal_bits) + 0.5;
      if (std::abs(exact) + bound >= static_cast<double>(limit)) continue;
      worst.see((static_cast<double>(divide(context, uq, q)) - exact) / bound,
                "u q = " + std::to_string(uq) + ", q = " + std::to_string(q));
    }
  }
}

// 46: q near 0 and at its ends; q = 0 counts as 1 LSB.
TEST(Perspective, ExtremesOfQ) {
  const Config config = with({{&Config::perspective, 1}});
  const Context context = make_context(config);
  EXPECT_EQ(divide(context, 5, 0), divide(context, 5, 1));
  EXPECT_EQ(divide(context, 0, 0), 0);
  EXPECT_EQ(divide(context, 1, 1 << 17), 2) << "q = 1/2: u doubles";
  EXPECT_EQ(divide(context, -1000, 1 << 16), -4000) << "q = 1/4";
  EXPECT_EQ(divide(context, 262143, (1 << 18) - 1), 262144) << "q just below 1";
}

}  // namespace
}  // namespace wrinkle

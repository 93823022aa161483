// blinn [Peercy97 fig. 2]: N' = A - fu B - fv C against its exact twin, and at the ends of its formats.
#include <array>
#include <cmath>

#include "golden/datapath/datapaths.h"
#include "tests/stage/support.h"

namespace wrinkle {
namespace {

// A - fu B - fv C is exact but for one rounding, and does not saturate where A, B, C are below 2 / 3 [set-up: below 1].
TEST(Blinn, IsRoundedOnce) {
  Worst worst("perturb, A - fu B - fv C, ulp of s2.VW", 0.5);
  Random random(base_seed());
  for (int vw : {8, 16, 22}) {
    for (int gb : {6, 9, 12}) {
      const Config config =
          with({{&Config::datapath, int(Datapath::kBlinn)}, {&Config::wide_bits, vw}, {&Config::gradient_bits, gb}});
      ASSERT_EQ(check(config).key, "");
      for (bool bump : {true, false}) {
        Context context = make_context(config);
        DrawWords draw;
        draw.bump = bump;
        set_draw(context, draw, nullptr);
        auto batch = std::make_unique<Batch<std::int64_t>>(context.config);
        batch->count = kBatch;
        const std::int64_t one = std::int64_t{1} << vw, slope = std::int64_t{1} << gb;
        for (std::size_t i = 0; i < kBatch; ++i) {
          for (std::size_t k = 0; k < 3; ++k) {
            batch->interpolate_frame[k][i] = pattern(random, {-one, one});
            batch->interpolate_frame[3 + k][i] = pattern(random, {-one, one});
            batch->interpolate_frame[6 + k][i] = pattern(random, {-one, one});
          }
          for (std::size_t k = 0; k < 2; ++k) batch->texture_bump[k][i] = pattern(random, {-slope, slope - 1});
        }
        batch = run_one(context, kPerturb, std::move(batch));
        for (std::size_t i = 0; i < kBatch; ++i) {
          const auto vector = [&](const auto& columns) {
            return Vec3{double(columns[0][i]), double(columns[1][i]), double(columns[2][i])};
          };
          const std::array frame{vector(batch->interpolate_frame.subspan(0, 3)),
                                 vector(batch->interpolate_frame.subspan(3, 3)),
                                 vector(batch->interpolate_frame.subspan(6, 3))};
          const std::array slopes{std::ldexp(double(batch->texture_bump[0][i]), -gb),
                                  std::ldexp(double(batch->texture_bump[1][i]), -gb)};
          const Vec3 want = Blinn::exact(bump, frame, slopes);
          const Vec3 error = vector(batch->perturb_n) - want;
          for (double e : {error.x, error.y, error.z}) worst.see(e);
        }
      }
    }
  }
}

// All terms at the ends of their formats: 2 + 2 + 2 saturates at 4 - 2^-VW.
TEST(Blinn, Saturates) {
  const Config config = with({{&Config::datapath, int(Datapath::kBlinn)}});
  Context context = make_context(config);
  DrawWords draw;
  draw.bump = true;
  set_draw(context, draw, nullptr);
  auto batch = std::make_unique<Batch<std::int64_t>>(context.config);
  batch->count = 1;
  const std::int64_t two = std::int64_t{2} << config.wide_bits, one = std::int64_t{1} << config.gradient_bits;
  for (std::size_t k = 0; k < 3; ++k) {
    batch->interpolate_frame[k][0] = k == 2 ? -two : two - 1;
    batch->interpolate_frame[3 + k][0] = k == 2 ? -two : two - 1;
    batch->interpolate_frame[6 + k][0] = k == 2 ? -two : k == 1 ? -two : two - 1;
  }
  batch->texture_bump[0][0] = batch->texture_bump[1][0] = -one;
  batch = run_one(context, kPerturb, std::move(batch));
  EXPECT_EQ(batch->perturb_n[0][0], 2 * two - 1);
  EXPECT_EQ(batch->perturb_n[1][0], two - 2);
  EXPECT_EQ(batch->perturb_n[2][0], -2 * two);
}

}  // namespace
}  // namespace wrinkle

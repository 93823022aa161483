#include "golden/exact/perturb.h"

#include <algorithm>
#include <cmath>

#include "tests/stage/support.h"

namespace wrinkle {
namespace {

TEST(Perturb, LanesAgree) { expect_lanes_agree(kPerturb); }

// A - fu B - fv C is exact but for one rounding, and does not saturate where A, B, C are below 2 / 3 [set-up: below 1].
TEST(Perturb, DisplacementIsRoundedOnce) {
  Worst worst("perturb, A - fu B - fv C, ulp of s2.VW", 0.5);
  Random random(base_seed());
  for (int vw : {8, 16, 22}) {
    for (int gb : {6, 9, 12}) {
      const Config config = with({{&Config::datapath, 2}, {&Config::wide_bits, vw}, {&Config::gradient_bits, gb}});
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
          const Vec2 gradient{std::ldexp(double(batch->texture_bump[0][i]), -gb),
                              std::ldexp(double(batch->texture_bump[1][i]), -gb)};
          const Vec3 want = exact::displace(draw, vector(batch->interpolate_frame.subspan(0, 3)),
                                            vector(batch->interpolate_frame.subspan(3, 3)),
                                            vector(batch->interpolate_frame.subspan(6, 3)), gradient);
          const Vec3 error = vector(batch->perturb_n) - want;
          for (double e : {error.x, error.y, error.z}) worst.see(e);
        }
      }
    }
  }
}

// All terms at the ends of their formats: 2 + 2 + 2 saturates at 4 - 2^-VW.
TEST(Perturb, DisplacementSaturates) {
  const Config config = with({{&Config::datapath, 2}});
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

// The multiplexer is a wire: exactly one of its inputs comes out, by the draw and the datapath.
TEST(Perturb, SelectsByDraw) {
  for (const auto& [name, config] : configurations()) {
    const Shape shape(config);
    if (shape.normal_like_light == 0) continue;
    for (bool bump : {false, true}) {
      SCOPED_TRACE(name);
      Context context = make_context(config);
      DrawWords draw;
      draw.bump = bump;
      set_draw(context, draw, nullptr);
      auto batch = std::make_unique<Batch<std::int64_t>>(context.config);
      fill(config, base_seed(), *batch);
      batch->count = kBatch;
      batch = run_one(context, kPerturb, std::move(batch));
      const bool from_texture = shape.bump_components != 0 && bump;
      EXPECT_TRUE(std::ranges::equal(batch->perturb_n, from_texture ? batch->texture_bump : batch->interpolate_frame));
    }
  }
}

}  // namespace
}  // namespace wrinkle

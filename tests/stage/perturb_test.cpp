#include "tests/stage/support.h"

namespace wrinkle {
namespace {

TEST(Perturb, LanesAgree) { expect_lanes_agree(kPerturb); }

// The multiplexer is a wire: exactly one of its inputs comes out, by the draw and the datapath.
TEST(Perturb, SelectsByDraw) {
  for (const auto& [name, config] : configurations()) {
    for (bool bump : {false, true}) {
      SCOPED_TRACE(name);
      Context context = make_context(config);
      DrawWords draw;
      draw.bump = bump;
      set_draw(context, draw, nullptr);
      auto batch = std::make_unique<Batch<std::int64_t>>();
      fill(config, base_seed(), *batch);
      batch->count = kBatch;
      batch = run_one(context, kPerturb, std::move(batch));
      EXPECT_EQ(batch->perturb_n, config.has_bump() && bump ? batch->texture_n : batch->interpolate_n);
    }
  }
}

}  // namespace
}  // namespace wrinkle

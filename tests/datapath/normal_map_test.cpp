// normal_map [Peercy97 fig. 3]: a multiplexer between the interpolated normal and that of the texture.
#include "tests/datapath/support.h"

namespace wrinkle {
namespace {

TEST(NormalMap, TheDrawSelects) {
  ASSERT_FALSE(configurations_with(Datapath::kNormalMapped).empty());
  for (const auto& [name, config] : configurations_with(Datapath::kNormalMapped)) {
    SCOPED_TRACE(name);
    const auto bumped = run_filled(config, true, kPerturb), smooth = run_filled(config, false, kPerturb);
    EXPECT_TRUE(are_equal(bumped->perturb_n, bumped->texture_bump));
    EXPECT_TRUE(are_equal(smooth->perturb_n, smooth->interpolate_frame));
    EXPECT_FALSE(are_equal(bumped->perturb_n, smooth->perturb_n));
  }
}

}  // namespace
}  // namespace wrinkle

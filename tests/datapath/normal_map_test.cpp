// normal_map [Peercy97 fig. 3]: a multiplexer between the interpolated normal and that of the texture.
#include "tests/datapath/support.h"

namespace wrinkle {
namespace {

TEST(NormalMap, TheDrawSelects) {
  ASSERT_FALSE(configurations_with(Datapath::kNormalMapped).empty());
  for (const auto& [name, config] : configurations_with(Datapath::kNormalMapped)) {
    SCOPED_TRACE(name);
    const auto bumped = run_filled(config, true, kPerturb), smooth = run_filled(config, false, kPerturb);
    EXPECT_EQ(bumped->perturb_n, bumped->texture_n);
    EXPECT_EQ(smooth->perturb_n, smooth->interpolate_n);
    EXPECT_NE(bumped->perturb_n, smooth->perturb_n);
  }
}

}  // namespace
}  // namespace wrinkle

// phong [Peercy97 fig. 1]: the interpolated normal, whatever the draw says.
#include "tests/datapath/support.h"

namespace wrinkle {
namespace {

TEST(Phong, NothingPerturbsTheNormal) {
  ASSERT_FALSE(configurations_with(Datapath::kPhong).empty());
  for (const auto& [name, config] : configurations_with(Datapath::kPhong)) {
    for (const bool bump : {true, false}) {
      SCOPED_TRACE(name);
      const auto batch = run_filled(config, bump, kPerturb);
      EXPECT_TRUE(are_equal(batch->perturb_n, batch->interpolate_frame));
    }
  }
}

}  // namespace
}  // namespace wrinkle

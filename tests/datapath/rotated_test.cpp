// rotated [Kuijk and Blake 1989]: N is (0, 0, 1) in a frame that turns with the surface.
#include "tests/datapath/support.h"

namespace wrinkle {
namespace {

TEST(Rotated, TheNormalIsTheZAxis) {
  ASSERT_FALSE(configurations_with(Datapath::kRotated).empty());
  for (const auto& [name, config] : configurations_with(Datapath::kRotated)) {
    SCOPED_TRACE(name);
    const auto batch = run_filled(config, true, kPerturb | kNormalize);
    for (std::size_t i = 0; i < kBatch; ++i) {
      EXPECT_EQ(batch->normalize_n[0][i], 0);
      EXPECT_EQ(batch->normalize_n[1][i], 0);
      EXPECT_EQ(batch->normalize_n[2][i], std::int64_t{1} << config.unit_bits);
    }
  }
}

}  // namespace
}  // namespace wrinkle

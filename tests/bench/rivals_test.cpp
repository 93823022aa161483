// The datapaths and illuminations beside the paper's own: RTL and golden agree on every fragment and on every value
// that a stage hands on.
#include <gtest/gtest.h>

#include "tb/bench.h"
#include "tb/random_frame.h"
#include "tb/random_packets.h"
#include "tests/bench/configurations.h"
#include "tests/bench/taps.h"

namespace wrinkle {
namespace {

class Rivals : public testing::TestWithParam<Rival> {};

TEST_P(Rivals, FragmentsAreBitExactUnderStalls) {
  const Config& config = GetParam().config;
  ASSERT_EQ(check(config).message, "");
  const StallProfile profiles[] = {StallProfile::kNone, StallProfile::kRandom, StallProfile::kBursty};
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    RandomFrame wish;
    wish.seed = seed;
    wish.fragments = 20000;
    BenchOptions options;
    options.seed = seed;
    options.stalls = profiles[seed % 3];
    options.latency = 1 << seed;
    const BenchResult result = run_bench(config, random_frame(config, wish), options);
    ASSERT_TRUE(result.equal()) << "seed " << seed << ": " << (result.first ? describe(*result.first) : "");
    ASSERT_GT(result.fragments, 5000U);
  }
}

TEST_P(Rivals, TapsOfEveryStageAreTheGoldenValues) { expect_taps_are_golden(GetParam().config); }

TEST_P(Rivals, PacketsThatSetUpNeverSendsAreBitExactInEveryStage) {
  const Config& config = GetParam().config;
  const std::vector<Texture> textures = random_textures(config, 1);
  const StallProfile profiles[] = {StallProfile::kNone, StallProfile::kRandom, StallProfile::kBursty};
  RandomPackets wish;
  for (wish.seed = 1; wish.seed <= 6; ++wish.seed) {
    BenchOptions options;
    options.seed = wish.seed;
    options.stalls = profiles[wish.seed % 3];
    expect_taps_are_golden(config, random_packets(config, textures, wish), textures, options);
  }
}

// Packets of one fragment follow each other and change the draw state each time; then few triangles under stalls and
// latencies of ten thousand clocks.
TEST_P(Rivals, PacketsBackToBackAndLongStalls) {
  const Config& config = GetParam().config;
  RandomFrame wish;
  wish.seed = 55;
  wish.fragments = 4000;
  const Frame frame = random_frame(config, wish);
  Frame alternating = frame;
  alternating.draws.clear();
  for (std::size_t i = 0; i < 200; ++i) {
    const Draw& from = frame.draws[i % frame.draws.size()];
    alternating.draws.push_back({from.state, {from.triangles[i % from.triangles.size()]}});
  }
  for (const StallProfile stalls : {StallProfile::kNone, StallProfile::kRandom, StallProfile::kBursty}) {
    BenchOptions options;
    options.stalls = stalls;
    const BenchResult result = run_bench(config, alternating, options);
    EXPECT_TRUE(result.equal()) << (result.first ? describe(*result.first) : "stopped");
  }
  BenchOptions options;
  options.stalls = StallProfile::kExtreme;
  const BenchResult result = run_bench(config, frame, options);
  EXPECT_TRUE(result.equal()) << (result.first ? describe(*result.first) : "stopped");
}

// One fragment a clock where no triangle starts: the same clocks as the paper's own datapath but for the longer pipe.
// With sharing three clocks each: 0.33 fragments a clock, start and end of the frame included.
TEST_P(Rivals, IsAsFastAsFig3) {
  const auto clocks = [](const Config& config) {
    RandomFrame wish;
    wish.seed = 5;
    wish.fragments = 20000;
    wish.draws = 1;
    Frame frame = random_frame(config, wish);
    // A screen of one colour: a triangle that covers it all.
    ScreenTriangle& triangle = frame.draws[0].triangles[0];
    const int last = config.screen_size() << config.subpixel_bits;
    triangle.v[0].x = triangle.v[0].y = triangle.v[1].y = triangle.v[2].x = 0;
    triangle.v[1].x = triangle.v[2].y = 2 * last - 1;
    frame.draws[0].triangles.resize(1);
    const BenchResult result = run_bench(config, frame);
    EXPECT_TRUE(result.equal());
    return std::pair(result.fragments, result.cycles);
  };
  const auto [fragments, cycles] = clocks(GetParam().config);
  EXPECT_GT(fragments, 4000U);
  if (GetParam().config.sharing == 0) {
    EXPECT_LT(cycles, fragments + 150);
  } else {
    EXPECT_GE(static_cast<double>(fragments) / static_cast<double>(cycles), 0.33);
  }
}

std::string rival_name(const testing::TestParamInfo<Rival>& test) { return test.param.name; }

INSTANTIATE_TEST_SUITE_P(Bench, Rivals, testing::ValuesIn(rivals()), rival_name);

}  // namespace
}  // namespace wrinkle

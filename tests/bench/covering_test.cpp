// Every value of every parameter is simulated, and every field of a packet at both ends: RTL and golden agree on every
// value that a stage hands on. Models are built without optimisation, which for short frames is sooner done.
#include "tests/bench/covering.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tb/random_packets.h"
#include "tests/bench/configurations.h"
#include "tests/bench/taps.h"

namespace wrinkle {
namespace {

std::vector<Config> configs() {
  std::vector<Config> all = covering_configs();
  all.push_back(longest_packet());
  all.push_back(shortest_packet());
  return all;
}

BenchOptions quickly_built(std::uint64_t seed) {
  const StallProfile profiles[] = {StallProfile::kNone, StallProfile::kRandom, StallProfile::kBursty};
  BenchOptions options;
  options.seed = seed;
  options.stalls = profiles[seed % 3];
  options.model.optimize = false;
  return options;
}

TEST(CoveringConfigurations, UseEveryValueOfEveryParameter) {
  std::set<Setting> left = all_settings();
  for (const Config& config : covering_configs()) {
    EXPECT_EQ(check(config).message, "");
    for (const Setting& setting : settings_in_use(config)) left.erase(setting);
  }
  for (const auto& [name, value] : left) ADD_FAILURE() << name << " = " << value << " is not simulated";
  EXPECT_LE(covering_configs().size(), 32U) << "each takes seconds to build";
}

TEST(CoveringConfigurations, LongestPacketIsTheLongest) {
  ASSERT_EQ(check(longest_packet()).message, "");
  ASSERT_EQ(check(shortest_packet()).message, "");
  const int longest = triangle_word_count(longest_packet()), shortest = triangle_word_count(shortest_packet());
  EXPECT_EQ(longest, 41);
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    EXPECT_LE(triangle_word_count(random_config(seed)), longest);
    EXPECT_GE(triangle_word_count(random_config(seed)), shortest);
  }
}

class Covering : public testing::TestWithParam<int> {
 protected:
  const Config config_ = configs()[static_cast<std::size_t>(GetParam())];
  const std::uint64_t seed_ = static_cast<std::uint64_t>(GetParam()) + 1;
};

TEST_P(Covering, FramesAreBitExactInEveryStage) {
  RandomFrame wish;
  wish.seed = seed_;
  wish.fragments = 4000;
  const Frame frame = random_frame(config_, wish);
  expect_taps_are_golden(config_, build_packets(config_, frame), frame.textures, quickly_built(seed_));
}

TEST_P(Covering, PacketsThatSetUpNeverSendsAreBitExactInEveryStage) {
  const std::vector<Texture> textures = random_textures(config_, seed_);
  RandomPackets wish;
  for (wish.seed = seed_; wish.seed < seed_ + 3; ++wish.seed)
    expect_taps_are_golden(config_, random_packets(config_, textures, wish), textures, quickly_built(wish.seed));
}

INSTANTIATE_TEST_SUITE_P(Bench, Covering, testing::Range(0, static_cast<int>(configs().size())));

}  // namespace
}  // namespace wrinkle

// A million random fragments over configurations that share no width: RTL and golden agree on every bit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <set>
#include <string_view>

#include "tb/bench.h"
#include "tb/random_frame.h"
#include "tests/bench/configurations.h"

namespace wrinkle {
namespace {

constexpr std::uint64_t kFragments = 1200000;

// Another seed than the usual by WRINKLE_SEED.
std::uint64_t base_seed() {
  const char* text = std::getenv("WRINKLE_SEED");
  return text != nullptr ? std::strtoull(text, nullptr, 0) : 1;
}

TEST(Soak, SpreadConfigurationsAreLegalAndDifferInEveryWidth) {
  for (int i = 0; i < kSpread; ++i) EXPECT_EQ(check(spread_config(i)).message, "") << "configuration " << i;
  for (const Parameter& parameter : parameters()) {
    // These demand too much of the others, or of the time to build; rivals() and tests/rtl/normalizer.sh have them all.
    const std::set<std::string_view> apart{"sharing", "normalize_order", "normalizer_n", "normalizer_l",
                                           "normalizer_h"};
    if (apart.contains(parameter.name)) continue;
    std::set<int> seen;
    for (int i = 0; i < kSpread; ++i) seen.insert(spread_config(i).*parameter.member);
    const std::size_t wanted = parameter.values.empty() ? kSpread : parameter.values.size();
    EXPECT_EQ(seen.size(), wanted) << parameter.name;
  }
}

class Soak : public testing::TestWithParam<int> {};

TEST_P(Soak, RandomTrianglesAreBitExact) {
  const Config config = spread_config(GetParam());
  const StallProfile profiles[] = {StallProfile::kNone, StallProfile::kRandom, StallProfile::kBursty};
  std::uint64_t seed = base_seed() * 1000 + static_cast<std::uint64_t>(GetParam()) * 100;
  std::uint64_t fragments = 0, cycles = 0;
  double seconds = 0;
  for (int round = 0; fragments < kFragments / kSpread; ++round, ++seed) {
    RandomFrame wish;
    wish.seed = seed;
    wish.fragments = 60000;
    BenchOptions options;
    options.seed = seed;
    options.stalls = profiles[round % 3];
    options.latency = 1 << (round % 6);
    const BenchResult result = run_bench(config, random_frame(config, wish), options);
    ASSERT_TRUE(result.equal()) << "seed " << seed << ": " << result.mismatches << " mismatches; "
                                << (result.first ? describe(*result.first) : "");
    ASSERT_GT(result.fragments, 0U);
    fragments += result.fragments;
    cycles += result.cycles;
    seconds += result.cpu_seconds;
  }
  std::cout << "configuration " << GetParam() << ": " << fragments << " fragments, " << cycles << " clocks, last seed "
            << seed - 1 << ", " << static_cast<double>(fragments) / seconds * 1e-6 << " million fragments/s\n";
}

INSTANTIATE_TEST_SUITE_P(Configuration, Soak, testing::Range(0, kSpread));

}  // namespace
}  // namespace wrinkle

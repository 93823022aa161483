// The bench does what it says: models are built once, stalls and resets change nothing, taps and waveforms are there.
#include "tb/bench.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tb/process.h"
#include "tb/random_frame.h"
#include "tests/bench/configurations.h"
#include "tests/bench/drawn.h"
#include "tests/bench/taps.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

Frame short_frame(std::uint64_t seed, double fragments) {
  RandomFrame wish;
  wish.seed = seed;
  wish.fragments = fragments;
  wish.draws = 3;
  return random_frame(small_config(), wish);
}

fs::path scratch(const char* name) {
  const fs::path folder = fs::path(testing::TempDir()) / ("wrinkle_bench_" + std::to_string(getpid())) / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

TEST(Bench, QuantumAndDirectMemoryChangeNothing) {
  const Frame frame = short_frame(21, 20000);
  BenchOptions options;
  options.stalls = StallProfile::kRandom;
  BenchResult soak, cycle, transactions;
  const auto fragments = drawn(small_config(), frame, options, &soak);
  options.quantum = 1;
  EXPECT_EQ(drawn(small_config(), frame, options, &cycle), fragments);
  options.quantum = 64;
  options.dmi = false;
  EXPECT_EQ(drawn(small_config(), frame, options, &transactions), fragments);
  EXPECT_EQ(soak.cycles, cycle.cycles);
  EXPECT_EQ(soak.cycles, transactions.cycles);
}

TEST(Bench, SameSeedSameClocksOtherSeedOtherClocks) {
  const Frame frame = short_frame(22, 20000);
  BenchOptions options;
  options.stalls = StallProfile::kRandom;
  BenchResult first, again, other;
  drawn(small_config(), frame, options, &first);
  drawn(small_config(), frame, options, &again);
  options.seed = 2;
  drawn(small_config(), frame, options, &other);
  EXPECT_EQ(first.cycles, again.cycles);
  EXPECT_NE(first.cycles, other.cycles);
}

// What registers hold before reset is random: no picture depends on it.
TEST(Bench, UninitialisedRegistersDoNotShow) {
  const Frame frame = short_frame(23, 500);
  std::vector<Fragment> picture;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    BenchOptions options;
    options.seed = seed;
    const auto fragments = drawn(small_config(), frame, options);
    if (seed == 1) picture = fragments;
    ASSERT_EQ(fragments, picture) << "seed " << seed;
  }
}

TEST(Bench, Extreme52StallsAndLatenciesOfTenThousandClocks) {
  const Frame frame = short_frame(52, 20000);
  BenchOptions options;
  options.stalls = StallProfile::kExtreme;
  BenchResult result;
  drawn(small_config(), frame, options, &result);
  EXPECT_GT(result.cycles, 10 * static_cast<std::uint64_t>(kExtremeStall));
}

TEST(Bench, Extreme52EveryLatencyUpToTenThousand) {
  const Frame frame = short_frame(53, 300);
  for (const int latency : {0, kExtremeStall}) {
    BenchOptions options;
    options.latency = latency;
    drawn(small_config(), frame, options);
  }
}

TEST(Bench, Extreme53ResetInEveryClockOfAFrame) {
  const Frame frame = short_frame(54, 120);
  BenchOptions options;
  options.latency = 3;
  BenchResult whole;
  drawn(small_config(), frame, options, &whole);
  EXPECT_GE(whole.cycles, 200U);
  std::cout << "reset in each of " << whole.cycles << " clocks\n";
  for (std::uint64_t clock = 1; clock <= whole.cycles; ++clock) {
    options.keep_registers = true;
    options.stop_after = clock;
    EXPECT_TRUE(run_bench(small_config(), frame, options).stopped);
    options.stop_after = 0;
    const BenchResult result = run_bench(small_config(), frame, options);
    ASSERT_TRUE(result.equal()) << "after a reset in clock " << clock << ": "
                                << (result.first ? describe(*result.first) : "");
  }
}

// Packets of one fragment follow each other and change the draw state each time: no clock between them is lost, none
// runs into the next.
TEST(Bench, Extreme54PacketsBackToBack) {
  Frame frame = short_frame(55, 4000);
  Frame alternating = frame;
  alternating.draws.clear();
  for (std::size_t i = 0; i < 200; ++i) {
    const Draw& from = frame.draws[i % frame.draws.size()];
    alternating.draws.push_back({from.state, {from.triangles[i % from.triangles.size()]}});
  }
  for (const StallProfile stalls : {StallProfile::kNone, StallProfile::kRandom, StallProfile::kBursty}) {
    BenchOptions options;
    options.stalls = stalls;
    drawn(small_config(), alternating, options);
  }
}

// Every stage's values, tapped in the RTL, are those of the golden model.
TEST(Bench, TapsOfEveryStageAreTheGoldenValues) {
  for (int index = 0; index <= kSpread; ++index) {
    SCOPED_TRACE(index);
    expect_taps_are_golden(index == kSpread ? small_config() : spread_config(index));
  }
}

TEST(Bench, WithoutCompareTheFragmentsAreTheSame) {
  const Frame frame = short_frame(24, 5000);
  BenchOptions options;
  const auto compared = drawn(small_config(), frame, options);
  options.compare = false;
  EXPECT_EQ(drawn(small_config(), frame, options), compared);
}

TEST(Model, IsBuiltOnceAndAgainWhenTheSourceChanges) {
  const fs::path root = scratch("root"), cache = scratch("cache");
  fs::copy(fs::path(WRINKLE_SOURCE_DIR) / "rtl", root / "rtl", fs::copy_options::recursive);
  ModelOptions options;
  options.source_root = root;
  options.cache = cache;
  options.optimize = false;
  int messages = 0;
  const auto progress = [&](const std::string&) { ++messages; };
  const fs::path first = build_model(small_config(), options, progress);
  EXPECT_GT(messages, 0);
  messages = 0;
  EXPECT_EQ(build_model(small_config(), options, progress), first);
  EXPECT_EQ(messages, 0);

  std::ofstream(root / "rtl" / "wrinkle_core.v", std::ios::app) << "// changed\n";
  EXPECT_NE(build_model(small_config(), options, progress), first);
  EXPECT_GT(messages, 0);
}

TEST(Model, FailureToBuildShowsWhatTheToolSays) {
  const fs::path root = scratch("broken");
  fs::copy(fs::path(WRINKLE_SOURCE_DIR) / "rtl", root / "rtl", fs::copy_options::recursive);
  std::ofstream(root / "rtl" / "wrinkle_core.v", std::ios::app) << "module broken(\n";
  ModelOptions options;
  options.source_root = root;
  options.cache = root / "cache";
  try {
    build_model(small_config(), options);
    FAIL() << "it was built";
  } catch (const ModelBuildError& error) {
    EXPECT_NE(std::string(error.what()).find("wrinkle_core.v"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("syntax error"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace wrinkle

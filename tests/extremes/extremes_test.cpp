// The catalogue of numerical extremes, one test an entry, under its number: golden inside the stated bound, RTL equal.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "sim/stress/catalogue.h"
#include "tb/bench.h"

namespace wrinkle {
namespace {

class Extremes : public testing::TestWithParam<int> {};

TEST_P(Extremes, GoldenInsideTheBoundAndRtlEqual) {
  const ExtremeEntry& entry = extremes()[std::size_t(GetParam())];
  if (!entry.run) GTEST_SKIP() << entry.title << ": not reachable, " << entry.unreachable;
  const Extreme extreme = entry.run();
  EXPECT_GT(extreme.cases, 0U);
  EXPECT_LE(extreme.worst, extreme.bound) << extreme.unit << " at " << extreme.where;
  for (std::size_t i = 0; i < extreme.stimuli.size(); ++i) {
    const Stimulus& stimulus = extreme.stimuli[i];
    BenchOptions options;
    options.seed = i + 1;
    options.stalls = i % 2 == 0 ? StallProfile::kNone : StallProfile::kBursty;
    const BenchResult result =
        run_bench(stimulus.config(), stimulus.stream(), stimulus.textures(), entry.title, options);
    EXPECT_TRUE(result.equal()) << (result.first ? describe(*result.first) : "");
  }
}

INSTANTIATE_TEST_SUITE_P(Entry, Extremes, testing::Range(0, int(extremes().size())), [](const auto& instance) {
  return fmt::format("Extreme{:02}", extremes()[std::size_t(instance.param)].number);
});

TEST(Catalogue, HasEveryNumberOnce) {
  std::set<int> numbers;
  for (const ExtremeEntry& entry : extremes()) {
    EXPECT_TRUE(numbers.insert(entry.number).second) << entry.number;
    EXPECT_NE(bool(entry.run), !entry.unreachable.empty()) << entry.number;
  }
  for (int number = 1; number <= 48; ++number) EXPECT_TRUE(numbers.count(number)) << number;
  for (int number : {56, 57}) EXPECT_TRUE(numbers.count(number)) << number;
}

}  // namespace
}  // namespace wrinkle

// The catalogue of numerical extremes, with a test for each entry and configuration under the number of the entry.
// Golden must stay inside the stated bound for every named configuration. The RTL must be equal for `standard` and for
// the widest, whose models are built here.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "sim/config_file.h"
#include "sim/stress/catalogue.h"
#include "tb/bench.h"

namespace wrinkle {
namespace {

class Extremes : public testing::TestWithParam<std::tuple<std::string, std::size_t>> {};

void expect_rtl_equal(const ExtremeEntry& entry, const Extreme& extreme) {
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

TEST_P(Extremes, GoldenInsideTheBoundAndRtlEqual) {
  const auto& [name, index] = GetParam();
  const ExtremeEntry& entry = extremes()[index];
  if (entry.long_run) GTEST_SKIP() << entry.title << ": ./wrinkle stress --long";
  if (!entry.run) GTEST_SKIP() << entry.title << ": not reachable, " << entry.unreachable;
  const Extreme extreme = entry.run(load_config(name));
  if (!extreme.unreachable.empty()) GTEST_SKIP() << entry.title << ": not reachable, " << extreme.unreachable;
  EXPECT_GT(extreme.cases, 0U);
  EXPECT_LE(extreme.worst, extreme.bound) << extreme.unit << " at " << extreme.where;
  if (name == "standard" || name == "extreme") expect_rtl_equal(entry, extreme);
}

std::string test_name(const testing::TestParamInfo<Extremes::ParamType>& test) {
  const auto& [name, index] = test.param;
  char nth = 'a';
  for (std::size_t i = index; i > 0 && extremes()[i - 1].number == extremes()[index].number; --i) ++nth;
  return fmt::format("Extreme{:02}{}_{}", extremes()[index].number, nth, name);
}

INSTANTIATE_TEST_SUITE_P(Entry, Extremes,
                         testing::Combine(testing::ValuesIn(stress_configs()),
                                          testing::Range(std::size_t{0}, extremes().size())),
                         test_name);

TEST(Catalogue, HasEveryNumber) {
  std::set<int> numbers;
  for (const ExtremeEntry& entry : extremes()) {
    numbers.insert(entry.number);
    EXPECT_NE(bool(entry.run), !entry.unreachable.empty()) << entry.number;
  }
  for (int number = 1; number <= 48; ++number) EXPECT_TRUE(numbers.count(number)) << number;
  for (int number : {56, 57}) EXPECT_TRUE(numbers.count(number)) << number;
}

}  // namespace
}  // namespace wrinkle

// The law of the streams: nobody looks at a payload that is not valid, neither before the transfer nor after it.
#include <gtest/gtest.h>

#include <string>

#include "tb/bench.h"
#include "tb/random_frame.h"
#include "tests/bench/configurations.h"
#include "tests/bench/verilog_copy.h"

namespace wrinkle {
namespace {

class Law : public testing::TestWithParam<Rival> {};

TEST_P(Law, OnlyAValidPayloadIsLookedAt) {
  const std::filesystem::path root = copy_verilog(GetParam().name);
  EXPECT_GT(invert_payloads_that_are_not_valid(root), 40) << "ports of the stages";
  for (const StallProfile stalls : {StallProfile::kNone, StallProfile::kRandom, StallProfile::kBursty}) {
    RandomFrame wish;
    wish.seed = 4;
    wish.fragments = 8000;
    BenchOptions options;
    options.stalls = stalls;
    options.model.source_root = root;
    options.model.cache = root / "cache";
    options.model.optimize = false;
    const BenchResult result = run_bench(GetParam().config, random_frame(GetParam().config, wish), options);
    EXPECT_TRUE(result.equal()) << (result.first ? describe(*result.first) : "stopped");
    EXPECT_GT(result.fragments, 1000U);
  }
  std::filesystem::remove_all(root);
}

// Every kind of unit that a stage consists of.
std::vector<Rival> configs() {
  std::vector<Rival> all{{"small", small_config()}};
  for (const Rival& rival : rivals())
    for (const char* name : {"blinn_held", "deferred", "pixel_halfangle", "shared", "shared_single"})
      if (std::string_view(name) == rival.name) all.push_back(rival);
  return all;
}

INSTANTIATE_TEST_SUITE_P(Bench, Law, testing::ValuesIn(configs()),
                         [](const testing::TestParamInfo<Rival>& test) { return test.param.name; });

}  // namespace
}  // namespace wrinkle

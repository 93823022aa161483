// The law of the streams: what is offered is offered until it is taken, and nobody looks at a payload that is not
// valid, neither before the transfer nor after it.
#include <gtest/gtest.h>

#include <string>

#include "tb/bench.h"
#include "tb/random_packets.h"
#include "tests/bench/configurations.h"
#include "tests/bench/verilog_copy.h"

namespace wrinkle {
namespace {

class Law : public testing::TestWithParam<Rival> {};

TEST_P(Law, OffersStayAndOnlyAValidPayloadIsLookedAt) {
  const Config& config = GetParam().config;
  const std::filesystem::path root = copy_verilog(GetParam().name);
  stop_at_an_offer_taken_back(root);
  EXPECT_GT(invert_payloads_that_are_not_valid(root), 40) << "ports of the stages";
  for (const StallProfile stalls : {StallProfile::kNone, StallProfile::kRandom, StallProfile::kBursty}) {
    BenchOptions options;
    options.watchdog = 5000;
    options.stalls = stalls;
    options.model.source_root = root;
    options.model.cache = root / "cache";
    options.model.optimize = false;
    const std::vector<Texture> textures = random_textures(config, 4);
    const BenchResult result =
        run_bench(config, random_packets(config, textures, {.seed = 4}), textures, "law", options);
    EXPECT_TRUE(result.equal()) << (result.first ? describe(*result.first) : "stopped");
    EXPECT_GT(result.fragments, 1000U);
  }
  std::filesystem::remove_all(root);
}

// Every kind of unit that a stage consists of.
std::vector<Rival> configs() {
  std::vector<Rival> all{{"small", small_config()}};
  for (const Rival& rival : rivals())
    for (const char* name :
         {"blinn_held", "deferred", "pixel_halfangle", "shared", "shared_single", "shared_single_phong"})
      if (std::string_view(name) == rival.name) all.push_back(rival);
  return all;
}

INSTANTIATE_TEST_SUITE_P(Bench, Law, testing::ValuesIn(configs()),
                         [](const testing::TestParamInfo<Rival>& test) { return test.param.name; });

}  // namespace
}  // namespace wrinkle

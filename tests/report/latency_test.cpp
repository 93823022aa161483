// The latencies that docs/architecture.md states are those of the Verilog.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <charconv>

#include "golden/triangle/packet.h"
#include "golden/vertex/scene.h"
#include "sim/command.h"
#include "sim/config_file.h"
#include "sim/datapaths.h"
#include "tests/structure/tree.h"

namespace wrinkle {
namespace {

// The scene of `verify --all` that a configuration is for; the paper's patch for those that have none.
std::string scene_of(const std::string& config) {
  for (const DatapathFrame& frame : datapath_frames())
    if (frame.comparison.config == config && frame.comparison.set.empty()) return frame.comparison.scene;
  return "patch_fig6";
}

// The last word of a packet is taken in one clock; its fragment, the only one, stands at the port so many clocks later.
// The memory answers in the clock after a request, and nothing stalls.
std::uint64_t measured_latency(const std::string& name) {
  const Config config = load_config(name);
  Scene scene = scene_named(scene_of(name));
  scene.width = scene.height = 1;
  const Frame frame = build_frame(config, scene);
  BenchOptions options = quiet_bench_options();
  options.stalls = StallProfile::kNone;
  options.latency = 0;
  const BenchResult result = run_bench(config, frame, options);
  EXPECT_TRUE(result.equal());
  EXPECT_EQ(result.fragments, 1u);
  // A word is taken in each clock from the first on, and the core is idle in the clock after the fragment has left.
  return result.cycles - build_packets(config, frame).words.size();
}

// The row of the table of docs/architecture.md, "The whole pipeline"; 0 where there is none.
std::uint64_t stated_latency(const std::string& name) {
  const std::string page = text_of(fs::path(WRINKLE_SOURCE_DIR) / "docs/architecture.md");
  const std::vector<std::string> found = matches(page, "\n\\| `" + name + "` \\| (\\d+) \\|");
  std::uint64_t clocks = 0;
  if (found.size() == 1) std::from_chars(found[0].data(), found[0].data() + found[0].size(), clocks);
  return clocks;
}

class Latency : public testing::TestWithParam<std::string> {};

TEST_P(Latency, IsWhatTheDocumentStates) { EXPECT_EQ(stated_latency(GetParam()), measured_latency(GetParam())); }

INSTANTIATE_TEST_SUITE_P(, Latency, testing::ValuesIn(named_configs()), testing::PrintToStringParamName());

}  // namespace
}  // namespace wrinkle

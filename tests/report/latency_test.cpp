// The latencies of golden/stages.def, which docs/architecture.md states, are those of the Verilog.
#include <gtest/gtest.h>

#include <numeric>

#include "golden/stages.h"
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

int listed_latency(const Config& config) {
  const PerStage<int> clocks = stage_latencies(config);
  return std::accumulate(clocks.begin(), clocks.end(), 0);
}

// A row of the table of docs/architecture.md, "The whole pipeline": the sum, and a column for each stage from
// `perspective` on, empty where a stage takes no clock.
std::string row_of_table(const std::string& name, const Config& config) {
  std::string row = "| `" + name + "` | " + std::to_string(listed_latency(config)) + " |";
  const PerStage<int> clocks = stage_latencies(config);
  for (auto s = static_cast<std::size_t>(Stage::perspective); s < clocks.size(); ++s)
    row += clocks[s] == 0 ? "  |" : " " + std::to_string(clocks[s]) + " |";
  return row;
}

class Latency : public testing::TestWithParam<std::string> {};

TEST_P(Latency, IsThatOfTheListOfStages) {
  const Config config = load_config(GetParam());
  EXPECT_EQ(static_cast<std::uint64_t>(listed_latency(config)), measured_latency(GetParam()));
}

TEST_P(Latency, IsWhatTheDocumentStates) {
  const std::string row = row_of_table(GetParam(), load_config(GetParam()));
  const std::string page = text_of(fs::path(WRINKLE_SOURCE_DIR) / "docs/architecture.md");
  EXPECT_NE(page.find("\n" + row + "\n"), page.npos) << "docs/architecture.md has no row " << row;
}

INSTANTIATE_TEST_SUITE_P(, Latency, testing::ValuesIn(named_configs()), [](const auto& suite) { return suite.param; });

}  // namespace
}  // namespace wrinkle

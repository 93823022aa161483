// Rules of the house that a reader can check by searching the sources, and that nothing else checks. Each rule is also
// shown a small tree that breaks it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/structure/tree.h"

namespace wrinkle {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::vector<std::string> kVerilog{".v", ".vh"};

std::string name_in(const fs::path& root, const fs::path& file) { return fs::relative(file, root).generic_string(); }

// A file of the Verilog is read at one sitting. Longer are the core, which is the list of stages with their wires, and
// its include file, which is generated and has a line for each value.
Faults long_files(const fs::path& root) {
  constexpr std::ptrdiff_t kMost = 250;
  Faults faults;
  for (const fs::path& file : files_below(root / "rtl", kVerilog)) {
    const std::string text = text_of(file);
    const auto lines = std::count(text.begin(), text.end(), '\n');
    if (lines > kMost && file.stem() != "wrinkle_core" && file.stem() != "wrinkle_config")
      faults.push_back(name_in(root, file) + " has " + std::to_string(lines) + " lines, more than " +
                       std::to_string(kMost));
  }
  return faults;
}

// Every tool of every user takes a constant function; some take no memory that is filled at the start.
Faults initial_blocks(const fs::path& root) {
  Faults faults;
  for (const fs::path& file : files_below(root / "rtl", kVerilog))
    if (!matches(without_comments(text_of(file)), "\\b(initial)\\b").empty())
      faults.push_back(name_in(root, file) + " has an initial block");
  return faults;
}

// A stage is told widths. Which datapath there is, only the core and its include file know, and golden/datapath.
Faults stages_that_know_datapaths(const fs::path& root) {
  Faults faults;
  for (const char* folder : {"rtl", "golden/pixel", "golden/exact", "golden/triangle", "tb"})
    for (const fs::path& file : files_below(root / folder, {".v", ".vh", ".h", ".cpp"}))
      if (file.stem() != "wrinkle_core" && file.stem() != "wrinkle_config" &&
          !matches(without_comments(text_of(file)), "(DATAPATH|\\bDatapath\\b|\\.datapath\\b)").empty())
        faults.push_back(name_in(root, file) + " asks which datapath there is");
  return faults;
}

class Rule : public testing::Test {
 protected:
  Rule() : root_(fs::path(testing::TempDir()) / ("wrinkle_rules_" + std::to_string(getpid()))) {}
  ~Rule() override { fs::remove_all(root_); }

  void write(const std::string& file, const std::string& text) const {
    fs::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text;
  }

  const fs::path project_ = WRINKLE_SOURCE_DIR;
  fs::path root_;
};

TEST_F(Rule, VerilogFilesAreShort) {
  EXPECT_THAT(long_files(project_), IsEmpty());
  write("rtl/wrinkle_core.v", std::string(1000, '\n'));
  write("rtl/wrinkle_config.vh", std::string(1000, '\n'));
  write("rtl/unit/wrinkle_short.v", std::string(250, '\n'));
  write("rtl/unit/wrinkle_long.v", std::string(251, '\n'));
  EXPECT_THAT(long_files(root_), ElementsAre("rtl/unit/wrinkle_long.v has 251 lines, more than 250"));
}

TEST_F(Rule, VerilogHasNoInitialBlocks) {
  EXPECT_THAT(initial_blocks(project_), IsEmpty());
  write("rtl/lib/wrinkle_memory.v", "reg q;\ninitial q = 0;\n");
  write("rtl/lib/wrinkle_initial_value.v", "// the initial value\nreg q;\n");
  EXPECT_THAT(initial_blocks(root_), ElementsAre("rtl/lib/wrinkle_memory.v has an initial block"));
}

TEST_F(Rule, StagesDoNotKnowTheDatapath) {
  EXPECT_THAT(stages_that_know_datapaths(project_), IsEmpty());
  write("rtl/wrinkle_core.v", "if (DATAPATH == 2)");
  write("rtl/stage/wrinkle_light.v", "// DATAPATH\nparameter UNIT_BITS = 9");
  write("rtl/stage/wrinkle_perturb.v", "parameter DATAPATH = 1");
  write("golden/pixel/perturb-inl.h", "with_datapath(config, [&](const auto& datapath) {});");
  write("golden/exact/light.h", "if (config.datapath == 2) {}");
  write("tb/core.cpp", "Datapath::kBlinn");
  EXPECT_THAT(stages_that_know_datapaths(root_), ElementsAre("rtl/stage/wrinkle_perturb.v asks which datapath there is",
                                                             "golden/exact/light.h asks which datapath there is",
                                                             "tb/core.cpp asks which datapath there is"));
}

}  // namespace
}  // namespace wrinkle

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

}  // namespace
}  // namespace wrinkle

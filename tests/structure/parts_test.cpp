// A stage and a datapath each have all their parts under one name. A part that is missing is named; the tests below
// take every part away once and ask for the sentence that says so.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "golden/config/config.h"
#include "tests/structure/tree.h"

namespace wrinkle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct Part {
  std::string what, file;
  std::string instead = {};  // what may stand in its place
};

struct Stage {
  std::string name;
  bool before_pixels =
      false;  // takes words apart: it has no pixels, rounds nothing, and is golden/triangle to the host
};

// WRINKLE_STAGE(name, Name, moves, latency): what moves no fragment comes before there are any.
std::vector<Stage> stages_of(const fs::path& root) {
  const std::string list = without_comments(text_of(root / "golden/stages.def"));
  std::vector<Stage> stages;
  for (const std::string& name : matches(list, "\\bWRINKLE_STAGE\\((\\w+)"))
    stages.push_back({name, !matches(list, "\\b(WRINKLE_STAGE)\\(" + name + ",[^,]*, 0,").empty()});
  return stages;
}

std::vector<Part> parts_of(const Stage& stage) {
  // A stage that differs between datapaths has a folder with a module for each.
  const Part verilog{"Verilog module", "rtl/stage/wrinkle_" + stage.name + ".v", "rtl/" + stage.name};
  if (stage.before_pixels)
    return {verilog,
            {"host file", "golden/triangle/" + stage.name + ".cpp"},
            {"test", "tests/host/" + stage.name + "_test.cpp"}};
  return {verilog,
          {"golden file", "golden/pixel/" + stage.name + "-inl.h"},
          {"exact twin", "golden/exact/" + stage.name + ".h"},
          {"test", "tests/stage/" + stage.name + "_test.cpp"}};
}

// golden/datapath/list.def includes a header for each.
std::vector<std::string> datapaths_of(const fs::path& root) {
  return matches(text_of(root / "golden/datapath/list.def"), "#include \"golden/datapath/(\\w+)\\.h\"");
}

std::vector<Part> parts_of_datapath(const std::string& name) {
  return {{"header", "golden/datapath/" + name + ".h"},
          {"Verilog module", "rtl/perturb/wrinkle_perturb_" + name + ".v"},
          {"test", "tests/datapath/" + name + "_test.cpp"}};
}

void expect_files(const fs::path& root, const std::string& owner, const std::vector<Part>& parts, Faults& faults) {
  for (const Part& part : parts)
    if (!fs::exists(root / part.file) && (part.instead.empty() || !fs::exists(root / part.instead)))
      faults.push_back(owner + " has no " + part.what + ": " + part.file);
}

void expect_heading(const fs::path& root, const std::string& owner, const std::string& name, Faults& faults) {
  if (!contains(headings(root / "docs/architecture.md"), name))
    faults.push_back(owner + " has no heading \"" + name + "\" in docs/architecture.md");
}

Faults faults_of_stages(const fs::path& root) {
  Faults faults;
  for (const Stage& stage : stages_of(root)) {
    expect_files(root, "stage " + stage.name, parts_of(stage), faults);
    expect_heading(root, "stage " + stage.name, stage.name, faults);
  }
  return faults;
}

// The datapath of a configuration file: its own, that of the file it is based on, or the default.
std::string datapath_of(const fs::path& root, const std::string& config) {
  const std::string text = text_of(root / "sim/configs" / (config + ".toml"));
  if (const auto own = matches(text, "(?:^|\n)datapath = \"(\\w+)\""); !own.empty()) return own[0];
  if (const auto base = matches(text, "(?:^|\n)base = \"(\\w+)\""); !base.empty()) return datapath_of(root, base[0]);
  const std::vector<std::string> names = datapaths_of(root);
  const auto standard = static_cast<std::size_t>(Config{}.datapath);
  return standard < names.size() ? names[standard] : "";
}

Faults faults_of_datapaths(const fs::path& root) {
  std::vector<std::string> configured, drawn;
  for (const fs::path& config : files_below(root / "sim/configs", {".toml"}))
    configured.push_back(datapath_of(root, config.stem()));
  for (const fs::path& scene : files_below(root / "sim/scenes", {".toml"})) {
    for (const std::string& config : matches(text_of(scene), "(?:^|\n)config = \"(\\w+)\""))
      drawn.push_back(datapath_of(root, config));
  }
  // Rows of `verify --all`: {row, {name, scene, configuration, overrides}}.
  for (const std::string& config :
       matches(text_of(root / "sim/datapaths.cpp"), "\\{\\d+, \\{\"\\w+\", \"\\w+\", \"(\\w+)\""))
    drawn.push_back(datapath_of(root, config));
  Faults faults;
  for (const std::string& name : datapaths_of(root)) {
    const std::string owner = "datapath " + name;
    expect_files(root, owner, parts_of_datapath(name), faults);
    if (!contains(configured, name)) faults.push_back(owner + " has no configuration in sim/configs");
    if (!contains(drawn, name)) faults.push_back(owner + " has no scene in sim/scenes or row in sim/datapaths.cpp");
    expect_heading(root, owner, name, faults);
  }
  return faults;
}

// A tree of empty files, which are there to be taken away.
class Scratch : public testing::Test {
 protected:
  Scratch() : root_(fs::path(testing::TempDir()) / ("wrinkle_structure_" + std::to_string(getpid()))) {}
  ~Scratch() override { fs::remove_all(root_); }

  void write(const std::string& file, const std::string& text = "") const {
    fs::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text;
  }

  fs::path root_;
};

TEST(Stages, HaveAllTheirParts) {
  ASSERT_THAT(matches(without_comments(text_of(fs::path(WRINKLE_SOURCE_DIR) / "golden/stages.def")), "\\(scan, (Scan)"),
              ElementsAre("Scan"));
  EXPECT_THAT(faults_of_stages(WRINKLE_SOURCE_DIR), IsEmpty());
}

TEST(Datapaths, HaveAllTheirParts) {
  ASSERT_THAT(datapaths_of(WRINKLE_SOURCE_DIR), testing::Contains("phong"));
  EXPECT_THAT(faults_of_datapaths(WRINKLE_SOURCE_DIR), IsEmpty());
}

TEST_F(Scratch, AMissingPartOfAStageIsNamed) {
  for (const Stage& stage : {Stage{"ghost", false}, Stage{"herald", true}}) {
    write("golden/stages.def", "// WRINKLE_STAGE(name, Name, moves, latency)\nWRINKLE_STAGE(" + stage.name +
                                   ", Title, " + (stage.before_pixels ? "0" : "1") + ", 0)\n");
    write("docs/architecture.md", "# Architecture\n\n## " + stage.name + "\n");
    for (const Part& part : parts_of(stage)) write(part.file);
    EXPECT_THAT(faults_of_stages(root_), IsEmpty());
    for (const Part& part : parts_of(stage)) {
      fs::remove(root_ / part.file);
      EXPECT_THAT(faults_of_stages(root_),
                  ElementsAre("stage " + stage.name + " has no " + part.what + ": " + part.file));
      if (!part.instead.empty()) {
        fs::create_directories(root_ / part.instead);
        EXPECT_THAT(faults_of_stages(root_), IsEmpty());
        fs::remove(root_ / part.instead);
      }
      write(part.file);
    }
    write("docs/architecture.md", "# Architecture\n\n" + stage.name + "\n");
    EXPECT_THAT(faults_of_stages(root_), ElementsAre(HasSubstr("has no heading \"" + stage.name + "\"")));
  }
}

TEST_F(Scratch, AMissingPartOfADatapathIsNamed) {
  write("golden/datapath/list.def", "#include \"golden/datapath/ghost.h\"\n");
  write("docs/architecture.md", "### ghost\n");
  write("sim/configs/old.toml", "datapath = \"ghost\"\n");
  write("sim/configs/haunted.toml", "base = \"old\"\n");
  write("sim/scenes/house.toml", "config = \"haunted\"\n");
  for (const Part& part : parts_of_datapath("ghost")) write(part.file);
  EXPECT_THAT(faults_of_datapaths(root_), IsEmpty());
  for (const Part& part : parts_of_datapath("ghost")) {
    fs::remove(root_ / part.file);
    EXPECT_THAT(faults_of_datapaths(root_), ElementsAre("datapath ghost has no " + part.what + ": " + part.file));
    write(part.file);
  }
  write("sim/scenes/house.toml", "config = \"young\"\n");
  EXPECT_THAT(faults_of_datapaths(root_), ElementsAre(HasSubstr("ghost has no scene")));
  write("sim/datapaths.cpp", "{2, {\"name\", \"house\", \"haunted\", {}}},");
  EXPECT_THAT(faults_of_datapaths(root_), IsEmpty());
  fs::remove(root_ / "sim/datapaths.cpp");
  write("sim/configs/old.toml", "datapath = \"spirit\"\n");
  EXPECT_THAT(faults_of_datapaths(root_),
              ElementsAre(HasSubstr("ghost has no configuration"), HasSubstr("ghost has no scene")));
  write("sim/configs/old.toml", "datapath = \"ghost\"\n");
  write("sim/scenes/house.toml", "config = \"haunted\"\n");
  write("docs/architecture.md", "");
  EXPECT_THAT(faults_of_datapaths(root_), ElementsAre(HasSubstr("ghost has no heading")));
}

}  // namespace
}  // namespace wrinkle

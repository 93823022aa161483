// Configuration files: the named ones, bases, overrides, and everything that may be wrong with one.
#include "sim/config_file.h"

#include "support.h"

namespace wrinkle::test {
namespace {

struct BadConfig {
  const char* name;
  const char* text;
  std::vector<std::string> message;
};

class BadConfigs : public ::testing::TestWithParam<BadConfig> {};

TEST_P(BadConfigs, SayWhereAndWhy) {
  const Folder folder;
  const fs::path path = folder.write("bad.toml", GetParam().text);
  std::vector<std::string> parts = GetParam().message;
  parts.push_back("bad.toml");
  expect_error([&] { load_config(path.string(), "/"); }, parts);
}

INSTANTIATE_TEST_SUITE_P(
    Extremes48, BadConfigs,
    ::testing::Values(
        BadConfig{"UnknownKey", "unit_bit = 8\n", {":1:1", "unknown key \"unit_bit\"", "did you mean \"unit_bits\"?"}},
        BadConfig{"FarFromAnyKey", "\nzzzzzzzzzz = 8\n", {":2:1", "unknown key \"zzzzzzzzzz\"", "it may have"}},
        BadConfig{"WidthAsString", "unit_bits = \"8\"\n", {":1:13", "string \"8\"", "an integer from 6 to 16"}},
        BadConfig{"WidthAsFloat", "unit_bits = 8.0\n", {":1:13", "number 8", "an integer from 6 to 16"}},
        BadConfig{"WidthNaN", "unit_bits = nan\n", {":1:13", "an integer from 6 to 16"}},
        BadConfig{"WidthTooSmall", "unit_bits = 5\n", {":1:13", "integer 5", "an integer from 6 to 16"}},
        BadConfig{"WidthTooLarge", "\n\nscreen_bits = 13\n", {":3:15", "integer 13", "an integer from 4 to 12"}},
        BadConfig{"WidthHuge", "unit_bits = 4294967295\n", {":1:13", "4294967295", "an integer from 6 to 16"}},
        BadConfig{"ChoiceUnknown", "filter = \"bilinaer\"\n", {":1:10", "bilinaer", "did you mean \"bilinear\"?"}},
        BadConfig{
            "ChoiceAsInteger", "filter = 1\n", {":1:10", "integer 1", "\"nearest\", \"bilinear\" or \"trilinear\""}},
        BadConfig{"ChoiceAsTable", "[filter]\n", {":1:1", "a table", "\"nearest\""}},
        BadConfig{"PowerBelowDot",
                  "dot_bits = 12\npower_bits = 10\n",
                  {":2:14", "power_bits = 10", "at least dot_bits (12)"}},
        BadConfig{"DotAboveTwiceUnit", "unit_bits = 6\ndot_bits = 13\npower_bits = 18\n", {":2:12", "dot_bits = 13"}},
        BadConfig{"ReciprocalBelowQ",
                  "perspective = \"on\"\nq_bits = 20\nreciprocal_bits = 12\n",
                  {":3:19", "reciprocal_bits = 12", "at least q_bits (20) - 1"}},
        BadConfig{"NotToml", "unit_bits = = 8\n", {":1:"}},
        BadConfig{"KeyTwice", "unit_bits = 8\nunit_bits = 9\n", {":2:"}},
        BadConfig{"BaseUnknown", "base = \"standart\"\n", {":1:8", "standart", "did you mean \"standard\"?"}},
        BadConfig{"BaseItself", "base = \"bad.toml\"\n", {":1:8", "chain of bases that ends"}},
        BadConfig{"Empty", "", {"empty file"}}),
    CaseName());

TEST(ConfigFile, NamedConfigurationsAreLegalAndDiffer) {
  const std::vector<std::string> names = named_configs();
  for (const char* name : {"lean", "standard", "perspective", "fine", "extreme"}) {
    ASSERT_NE(std::find(names.begin(), names.end(), name), names.end()) << name;
  }
  EXPECT_EQ(load_config("standard"), Config{});
  EXPECT_EQ(load_config("lean").unit_bits, 6);
  EXPECT_EQ(load_config("fine").unit_bits, 12);
  EXPECT_EQ(load_config("fine").screen_size(), 4096);
  EXPECT_EQ(load_config("extreme").unit_bits, 16);
  Config gloss = load_config("fine");
  gloss.gloss_map = 1;
  EXPECT_EQ(load_config("gloss"), gloss);
  Config perspective = load_config("perspective");
  EXPECT_EQ(perspective.perspective, 1);
  perspective.perspective = 0;
  EXPECT_EQ(perspective, Config{});
}

TEST(ConfigFile, WhatIsWrittenIsReadAgain) {
  const Folder folder;
  for (const std::string& name : named_configs()) {
    const Config config = load_config(name);
    EXPECT_EQ(load_config(folder.write(name + ".toml", write_config(config)).string(), "/"), config) << name;
  }
}

TEST(ConfigFile, BaseIsReadFirstAndRelativeToTheFile) {
  const Folder folder;
  folder.write("sub/first.toml", "unit_bits = 10\ncolour_bits = 6\n");
  const fs::path second = folder.write("sub/second.toml", "colour_bits = 7\nbase = \"first.toml\"\n");
  const Config config = load_config(second.string(), "/");
  EXPECT_EQ(config.unit_bits, 10);
  EXPECT_EQ(config.colour_bits, 7);
}

TEST(ConfigFile, IllegalAcrossFilesNamesTheFileThatSetsTheKey) {
  const Folder folder;
  folder.write("first.toml", "power_bits = 10\n");
  const fs::path second = folder.write("second.toml", "base = \"first.toml\"\ndot_bits = 12\n");
  expect_error([&] { load_config(second.string(), "/"); }, {"first.toml:1:14", "power_bits = 10"});
}

TEST(ConfigFile, MissingFileFolderAndName) {
  const Folder folder;
  expect_error([&] { load_config("nothing.toml", folder.path()); }, {"nothing.toml", "a file that exists"});
  expect_error([&] { load_config(folder.path().string() + "/", "/"); }, {"the folder"});
  expect_error([&] { load_config("standart"); }, {"standart", "did you mean \"standard\"?"});
}

TEST(ConfigFile, Overrides) {
  const std::vector<std::string> good{"dot_bits=12", "power_bits=14", "filter=nearest"};
  const Config config = apply_overrides(Config{}, good);
  EXPECT_EQ(config.dot_bits, 12);
  EXPECT_EQ(config.power_bits, 14);
  EXPECT_EQ(config.filter, 0);
  const auto fails = [](const std::string& assignment, const std::vector<std::string>& parts) {
    const std::vector<std::string> list{assignment};
    expect_error([&] { apply_overrides(Config{}, list); }, parts);
  };
  fails("unit_bits", {"--set unit_bits", "key=value"});
  fails("unit_bit=8", {"--set unit_bit=8", "did you mean \"unit_bits\"?"});
  fails("unit_bits=8x", {"\"8x\"", "an integer from 6 to 16"});
  fails("unit_bits=", {"an integer from 6 to 16"});
  fails("unit_bits=99999999999999999999", {"an integer from 6 to 16"});
  fails("filter=bilinaer", {"did you mean \"bilinear\"?"});
  fails("power_bits=6", {"--set power_bits=6", "at least dot_bits (10)"});
}

}  // namespace
}  // namespace wrinkle::test

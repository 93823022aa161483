// The lists that the bench is made from: ports against the Verilog, wires against the models, taps and texels of any
// width.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "golden/config/verilog.h"
#include "golden/stages.h"
#include "tb/bench.h"
#include "tb/model.h"
#include "tb/process.h"
#include "tb/random_frame.h"
#include "tb/random_texels.h"
#include "tb/tap_recorder.h"
#include "tb/texel_store.h"
#include "tests/bench/configurations.h"
#include "tests/bench/drawn.h"
#include "tests/bench/verilog_copy.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

// Direction and width by name.
using Ports = std::map<std::string, std::pair<std::string, int>>;

Ports listed_ports(const Shape& c) {
  Ports ports{{"clk", {"input", 1}}, {"rst", {"input", 1}}};
  const auto stream = [&](const std::string& name, const char* forth, const char* back) {
    const bool in = std::string(forth) == "_i";
    ports[name + "_valid" + forth] = {in ? "input" : "output", 1};
    ports[name + "_ready" + back] = {in ? "output" : "input", 1};
  };
  const auto field = [&](const std::string& name, int most, int width, bool in) {
    EXPECT_LE(width, most) << name;
    ports[name + (in ? "_i" : "_o")] = {in ? "input" : "output", width};
  };
#define WRINKLE_INPUT(name, stage) stream(#name, "_i", "_o");
#define WRINKLE_OUTPUT(name, stage) stream(#name, "_o", "_i");
#define WRINKLE_INPUT_FIELD(stream, name, most, width) field(#name, most, width, true);
#define WRINKLE_OUTPUT_FIELD(stream, name, most, width) field(#name, most, width, false);
#define WRINKLE_STATUS(name) field(#name, 1, 1, false);
#include "golden/streams.def"
  return ports;
}

// The ports of wrinkle_core as Yosys elaborates it; its stages stay unknown modules.
Ports elaborated_ports(const Config& config) {
  const fs::path root = fs::path(WRINKLE_SOURCE_DIR) / "rtl";
  const fs::path folder = fs::path(testing::TempDir()) / ("wrinkle_ports_" + std::to_string(getpid()));
  fs::create_directories(folder);
  std::string script =
      "read_verilog -I" + root.string() + " " + (root / "wrinkle_core.v").string() + "\nhierarchy -top wrinkle_core";
  const std::string core = read_text(root / "wrinkle_core.v") + read_text(root / "wrinkle_config.vh");
  for (const Parameter& parameter : parameters()) {
    const std::string name = verilog_text(parameter.name);
    // What set-up alone reads is no parameter of the core.
    if (core.find("parameter " + name + " ") != std::string::npos)
      script += " -chparam " + name + " " + std::to_string(config.*parameter.member);
  }
  script += "\nwrite_json " + (folder / "core.json").string() + "\n";
  std::ofstream(folder / "ports.ys") << script;
  const int code = Process({"yosys", "-q", "-s", folder / "ports.ys"}, folder / "log").wait();
  EXPECT_EQ(code, 0) << read_text(folder / "log");
  Ports ports;
  if (code != 0) return ports;
  const auto netlist = nlohmann::json::parse(read_text(folder / "core.json"));
  for (const auto& module : netlist["modules"]) {
    if (!module["attributes"].contains("top")) continue;
    for (const auto& [name, port] : module["ports"].items())
      ports[name] = {port["direction"], static_cast<int>(port["bits"].size())};
  }
  fs::remove_all(folder);
  return ports;
}

void expect_listed_ports(const std::string& what, const Config& config) {
  const Ports elaborated = elaborated_ports(config), listed = listed_ports(config);
  for (const auto& [name, port] : elaborated) {
    const auto found = listed.find(name);
    if (found == listed.end()) {
      ADD_FAILURE() << what << ": golden/streams.def lacks the port " << name;
      continue;
    }
    EXPECT_EQ(found->second, port) << what << ": " << name;
  }
  for (const auto& [name, port] : listed)
    EXPECT_TRUE(elaborated.contains(name)) << what << ": wrinkle_core has no port " << name;
}

TEST(Streams, AreThePortsOfTheCore) {
  for (const Rival& rival : rivals()) expect_listed_ports(rival.name, rival.config);
  for (int i = 0; i < kSpread; ++i) expect_listed_ports("spread " + std::to_string(i), spread_config(i));
}

// Every value that a configuration has lies on a wire of the model that is wide enough.
class Wires : public testing::TestWithParam<Rival> {};

TEST_P(Wires, OfAllValuesAndStagesAreVisible) {
  const Config& config = GetParam().config;
  const Model model(build_model(config), 1);
  for (std::size_t stage = 0; stage < kStageNames.size(); ++stage) {
    if (stage_moves(config)[stage] == 0) continue;
    for (const char* end : {"_valid", "_ready"})
      EXPECT_NE(model.wire(std::string(kStageNames[stage]) + end).data, nullptr) << kStageNames[stage] << end;
  }
  for (const Value& value : values(config)) {
    const Wire wire = model.wire(value.wire);
    ASSERT_NE(wire.data, nullptr) << value.stage << '.' << value.name << " has no wire " << value.wire;
    EXPECT_GE(wire.bytes * 8, static_cast<std::size_t>(value.lowest_bit + value.elements * value.width)) << value.wire;
  }
}

std::vector<Rival> with_small_config() {
  std::vector<Rival> all = rivals();
  all.push_back({"small", small_config()});
  return all;
}

INSTANTIATE_TEST_SUITE_P(Streams, Wires, testing::ValuesIn(with_small_config()),
                         [](const testing::TestParamInfo<Rival>& test) { return test.param.name; });

// A bench of wires of any width, written bit by bit.
struct MadeUpWire {
  std::string name;
  std::vector<unsigned char> bytes;

  MadeUpWire(std::string wire_name, std::size_t size) : name(std::move(wire_name)), bytes(size) {}
  void set(int low, int width, std::int64_t value) {
    for (int i = 0; i < width; ++i) {
      const auto bit = static_cast<std::size_t>(low + i);
      const auto mask = static_cast<unsigned char>(1U << bit % 8);
      bytes[bit / 8] =
          static_cast<unsigned char>((value >> i & 1) != 0 ? bytes[bit / 8] | mask : bytes[bit / 8] & ~mask);
    }
  }
  Wire wire() const { return {name.c_str(), bytes.data(), bytes.size()}; }
};

TEST(Taps, ElementsLieAnywhereOnAWireOfAnyWidth) {
  Random random(5);
  for (int i = 0; i < 20000; ++i) {
    const int width = random.between(1, 64), low = random.between(0, 500), element = random.between(0, 11);
    MadeUpWire wire("interpolate_frame", 256);
    for (unsigned char& byte : wire.bytes) byte = static_cast<unsigned char>(random.next());
    const bool is_signed = random.below(2) != 0;
    const std::uint64_t drawn = random.next() >> (64 - width);
    const int shift = 64 - width;
    const std::int64_t expected =
        is_signed ? static_cast<std::int64_t>(drawn << shift) >> shift : static_cast<std::int64_t>(drawn);
    wire.set(low + element * width, width, static_cast<std::int64_t>(drawn));
    const Value value{"interpolate", "a", 12, width, 0, is_signed, ValueKind::plane, "interpolate_frame", low};
    ASSERT_EQ(unpack(value, wire.wire(), element), expected) << width << " bits from " << low;
  }
}

// A stage that moves each fragment three times, between stages that move it once: the rows are of the right fragments,
// and hold the values of all three moves.
TEST(Taps, OfAStageThatMovesAFragmentSeveralTimes) {
  const auto at = [](Stage stage) { return static_cast<std::size_t>(stage); };
  PerStage<int> moves = stage_moves(Config{});
  moves[at(Stage::texture)] = 3;
  const std::vector<Value> list{{"scan", "x", 1, 8, 0, false, ValueKind::wire, "scan_x", 0},
                                {"texture", "tap", 1, 8, 0, false, ValueKind::wire, "texture_tap", 4}};
  MadeUpWire scan_valid("scan_valid", 1), scan_ready("scan_ready", 1), scan_x("scan_x", 1);
  MadeUpWire texture_valid("texture_valid", 1), texture_ready("texture_ready", 1), tap("texture_tap", 2);
  const std::vector<Wire> wires{scan_valid.wire(),    scan_ready.wire(),    scan_x.wire(),
                                texture_valid.wire(), texture_ready.wire(), tap.wire()};
  TapRecorder recorder(list, moves, wires);
  EXPECT_EQ(recorder.visible_values(), (std::vector<bool>{true, true}));
  EXPECT_FALSE(recorder.stages()[at(Stage::packet)].visible);
  constexpr int kFragments = 5;
  // scan stands while texture hands on its three; the first clock of texture lies a clock behind that of scan.
  for (int clock = 0; clock <= 3 * kFragments; ++clock) {
    scan_valid.set(0, 1, clock < 3 * kFragments);
    scan_ready.set(0, 1, clock % 3 == 0);
    scan_x.set(0, 8, 100 + clock / 3);
    texture_valid.set(0, 1, clock > 0);
    texture_ready.set(0, 1, 1);
    tap.set(4, 8, clock - 1);
    recorder.sample();
  }
  EXPECT_EQ(recorder.stages()[at(Stage::scan)].transfers, 5U);
  EXPECT_EQ(recorder.stages()[at(Stage::texture)].transfers, 15U);
  for (int i = 0; i < kFragments; ++i) {
    const FragmentValues row = recorder.take();
    EXPECT_EQ(row[0][0], 100 + i);
    for (int move = 0; move < 3; ++move) EXPECT_EQ(row[1][static_cast<std::size_t>(move)], 3 * i + move);
  }
}

// A texel of `words` words, each another number.
std::vector<std::uint64_t> numbered(std::size_t count) {
  std::vector<std::uint64_t> words(count);
  for (std::size_t i = 0; i < count; ++i) words[i] = 0x0101010101010101 * (i + 1);
  return words;
}

TEST(TexelStore, TexelsAreAsWideAsTheWidest) {
  Texture narrow{.log2_width = 1, .components = 3, .component_bits = 8, .levels = {{1ULL << 40 | 11, 22}, {33}}};
  Texture wide{.log2_width = 1, .log2_height = 1, .components = 13, .component_bits = 10, .levels = {numbered(12)}};
  TexelStore store;
  store.load({narrow, wide});
  ASSERT_EQ(store.texel_words(), 3U);
  const auto word = [&](unsigned texture, unsigned level, std::uint32_t x, std::uint32_t y, std::size_t k) {
    const TexelStore::Level& place = *store.level(texture, level);
    std::uint64_t value = 0;
    std::memcpy(&value, store.bytes() + place.base + 8 * (store.texel_words() * (y * place.width + x) + k),
                sizeof value);
    return value;
  };
  EXPECT_EQ(word(0, 0, 0, 0, 0), 11U);  // above its 24 bits there is nothing
  EXPECT_EQ(word(0, 0, 1, 0, 0), 22U);
  EXPECT_EQ(word(0, 0, 1, 0, 1), 0U);
  EXPECT_EQ(word(0, 1, 0, 0, 0), 33U);
  EXPECT_EQ(word(1, 0, 1, 1, 0), 0x0101010101010101U * 10);
  EXPECT_EQ(word(1, 0, 1, 1, 1), 0x0101010101010101U * 11);
  EXPECT_EQ(word(1, 0, 1, 1, 2), 0x0101010101010101U * 12 & 3);
  EXPECT_EQ(store.level(0, 2), nullptr);
  EXPECT_EQ(store.level(2, 0), nullptr);
}

// A core whose texel ports are 100 bits wider, and that reads its texels from the top of them, draws what the core
// draws: responses of several words reach the pins whole, through direct memory access and through transactions.
TEST(Streams, TexelsWiderThanAWordReachTheCore) {
  constexpr int kMore = 130 - 36;  // six components of six bits fill the lower part of the port
  const fs::path root = fs::path(testing::TempDir()) / ("wrinkle_wide_" + std::to_string(getpid()));
  fs::remove_all(root);
  fs::create_directories(root);
  fs::copy(fs::path(WRINKLE_SOURCE_DIR) / "rtl", root / "rtl", fs::copy_options::recursive);
  std::string core = read_text(root / "rtl" / "wrinkle_core.v");
  const auto replace_all = [&](const std::string& from, const std::string& to) {
    std::size_t found = 0;
    for (auto at = core.find(from); at != std::string::npos; at = core.find(from, at + to.size()), ++found)
      core.replace(at, from.size(), to);
    return found;
  };
  for (const char* name : {"a00", "a10", "a01", "a11", "b00", "b10", "b01", "b11"}) {
    const std::string port = "texel_" + std::string(name) + "_i";
    const std::size_t declared = core.find(" " + port + ";");
    ASSERT_NE(declared, std::string::npos) << port;
    const std::size_t width = core.rfind(")-1:0]", declared);
    ASSERT_NE(width, std::string::npos) << port;
    core.replace(width, 6, ") + " + std::to_string(kMore) + " - 1:0]");
    EXPECT_EQ(replace_all("(" + port + ")", "(" + port + "[" + std::to_string(kMore) + " +: 36])"), 1U) << port;
  }
  std::ofstream(root / "rtl" / "wrinkle_core.v") << core;

  const Config config = small_config();
  ASSERT_EQ(Shape(config).texels * config.texel_bits, 36);
  RandomFrame wish;
  wish.seed = 8;
  wish.fragments = 3000;
  const Frame frame = random_frame(config, wish);
  const std::vector<Fragment> expected = drawn(config, frame);
  ASSERT_GT(expected.size(), 1000U);

  Frame wide = frame;
  for (Texture& texture : wide.textures) {
    texture.components = 13;
    texture.component_bits = 10;
    for (auto& level : texture.levels) {
      std::vector<std::uint64_t> texels;
      for (const std::uint64_t texel : level)
        texels.insert(texels.end(), {0, texel << (kMore - 64), texel >> (128 - kMore)});
      level = texels;
    }
  }
  BenchOptions options;
  options.compare = options.blame = false;  // the golden model knows no such textures
  options.model.source_root = root;
  options.model.cache = root / "cache";
  options.model.optimize = false;
  for (const bool direct : {true, false}) {
    options.dmi = direct;
    EXPECT_EQ(drawn(config, wide, options), expected) << (direct ? "direct" : "transactions");
  }
  fs::remove_all(root);
}

// The core by the widest texel there may be: a bump map of nine components, of which the datapath reads the first
// three, a base colour and a gloss. It draws what the core with three components draws.
TEST(Streams, ThirteenComponentsReachTheirStages) {
  Config config = small_config();
  config.gloss_map = 1;
  config.texel_bits = 10;
  const fs::path root = copy_verilog("thirteen");
  std::string text = read_text(root / "rtl" / "wrinkle_config.vh");
  const auto replace = [&](const std::regex& from, const std::string& to) {
    EXPECT_TRUE(std::regex_search(text, from)) << to;
    text = std::regex_replace(text, from, to);
  };
  replace(std::regex("localparam BUMP_COMPONENTS = [^;]*;"), "localparam BUMP_COMPONENTS = 9;");
  replace(std::regex(R"(\.BUMP\(BUMP\))"), ".BUMP(NORMAL)");
  replace(std::regex(R"(\.bump_i\(texture_bump\))"), ".bump_i(texture_bump[NORMAL-1:0])");
  std::ofstream(root / "rtl" / "wrinkle_config.vh") << text;

  RandomFrame wish;
  wish.seed = 9;
  wish.fragments = 3000;
  const Frame frame = random_frame(config, wish);
  const std::vector<Fragment> expected = drawn(config, frame);
  ASSERT_GT(expected.size(), 1000U);

  Frame wide_frame = frame;
  std::vector<Texture>& wide = wide_frame.textures;
  Random random(13);
  for (std::size_t t = 0; t < wide.size(); ++t) {
    wide[t].components = 13;
    for (std::size_t level = 0; level < wide[t].levels.size(); ++level) {
      const auto& narrow = frame.textures[t].levels[level];
      const std::size_t texels = narrow.size() / static_cast<std::size_t>(frame.textures[t].texel_words());
      auto& words = wide[t].levels[level];
      words.assign(texels * static_cast<std::size_t>(wide[t].texel_words()), 0);
      for (std::size_t i = 0; i < texels; ++i) {
        for (int k = 0; k < 13; ++k) {
          const bool unread = k >= 3 && k < 9;
          const std::uint64_t code =
              unread ? random.next() & 1023 : frame.textures[t].code(narrow, i, k < 3 ? k : k - 6);
          put_code(wide[t], words, i, k, code);
        }
      }
    }
  }
  ASSERT_EQ(wide[0].components * wide[0].component_bits, kMaxTexelWidth);
  BenchOptions options;
  options.compare = options.blame = false;  // the golden model knows no such textures
  options.stalls = StallProfile::kRandom;
  options.model.source_root = root;
  options.model.cache = root / "cache";
  options.model.optimize = false;
  EXPECT_EQ(drawn(config, wide_frame, options), expected);
  fs::remove_all(root);
}

}  // namespace
}  // namespace wrinkle

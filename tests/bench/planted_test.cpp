// The bench itself is tested: a wrong bit planted in each stage in turn is found, and the stage is named.
// Slow: each case builds a model of its own.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "tb/bench.h"
#include "tb/process.h"
#include "tb/random_frame.h"
#include "tests/bench/configurations.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

struct Planted {
  const char* name;
  const char* file;
  std::vector<std::pair<std::string, std::string>> edits;  // text, and what is put in its place
  std::string stage, value;                                // as it must be named
  Difference::Kind kind = Difference::Kind::kValue;
  std::string rival = {};  // which of rivals(); empty: small_config()

  Config config() const {
    for (const Rival& r : rivals())
      if (rival == r.name) return r.config;
    return small_config();
  }
};

// The name of the test, in the lists of gtest.
void PrintTo(const Planted& planted, std::ostream* out) { *out << planted.name; }

const std::vector<Planted>& cases() {
  using Kind = Difference::Kind;
  static const std::vector<Planted> list = {
      {"packet",
       "stage/wrinkle_packet.v",
       {{"word_o           = word;", "word_o = word ^ {63'd0, plane_shift_o & word[9]};"}},
       "interpolate",
       ""},
      {"scan",
       "stage/wrinkle_scan.v",
       {{"y_o         = y_q;", "y_o = y_q ^ {{(X-1){1'b0}}, &w_q[2:0]};"}},
       "scan",
       "y"},
      {"scan_last", "stage/wrinkle_scan.v", {{"last_o      = ", "last_o = (y_q == 5) ^ "}}, "scan", "last"},
      {"interpolate",
       "stage/wrinkle_interpolate.v",
       {{"packet[AT +: BITS_OF_PLANE]", "packet[AT +: BITS_OF_PLANE] ^ (k == 3 && e == 1 ? 1 << (G + 3) : 0)"}},
       "interpolate",
       "l"},
      {"perspective",
       "stage/wrinkle_perspective.v",
       {{".value_i(v3)", ".value_i(v3 ^ ({{(UV-1){1'b0}}, 1'b1} << (UV - 7)))"}},
       "perspective",
       "v"},
      {"texture",
       "stage/wrinkle_texture.v",
       {{".a00_i(texel_a00_i)", ".a00_i(texel_a00_i ^ (1 << (TEXEL_BITS - 2)))"}},
       "texture",
       "n"},
      {"texture_decal",
       "stage/wrinkle_texture.v",
       {{".a11_i(texel_a11_i)", ".a11_i(texel_a11_i ^ (1 << (4 * TEXEL_BITS - 1)))"}},
       "texture",
       "decal"},
      {"texture_address",
       "stage/wrinkle_texture.v",
       {{".u_i(u_i)", ".u_i(u_i ^ (1 << (UV_BITS - 2)))"}},
       "texture",
       "n"},
      {"perturb",
       "perturb/wrinkle_perturb_normal_map.v",
       {{"draw_bump_i ? bump_i", "draw_bump_i ? bump_i ^ 16"}},
       "perturb",
       "n"},
      {"normalize",
       "unit/wrinkle_separate_units.v",
       {{".vector_i(l_i)", ".vector_i(l_i ^ (1 << (VECTOR_BITS - 2)))"}},
       "normalize",
       "l"},
      {"normalize_zero",
       "unit/wrinkle_separate_units.v",
       {{"zero_n | zero_l | zero_h", "zero_n | zero_l | zero_h | (l_o[2:0] == 7)"}},
       "normalize",
       "zero"},
      {"light",
       "unit/wrinkle_separate_light.v",
       {{".data_i(nl_early)", ".data_i(nl_early ^ (1 << (DOT_BITS - 3)))"}},
       "light",
       "nl"},
      {"light_power",
       "unit/wrinkle_separate_light.v",
       {{".a_i(power)", ".a_i(power ^ (1 << (POWER_BITS - 1)))"}},
       "light",
       "specular"},
      {"output", "stage/wrinkle_output.v", {{".data_i(colour)", ".data_i(colour ^ 2)"}}, "output", "colour"},
      {"output_z",
       "wrinkle_core.v",
       {{".bus_i(output_others)", ".bus_i(output_others ^ ({{TAG{1'b0}}, 1'b1} << (2*SCREEN_BITS+1)))"}},
       "output",
       "z"},
      {"dropped",
       "unit/wrinkle_separate_units.v",
       {{".in_valid_i(in_valid_i)", ".in_valid_i(in_valid_i & carry_i[4:0] != 5'd21)"}},
       "normalize",
       "",
       Kind::kValue},
      {"doubled",
       "perturb/wrinkle_perturb_normal_map.v",
       {{"in_ready_o  = out_ready_i;", "in_ready_o  = out_ready_i & frame_i[4:0] != 5'd21;"}},
       "perturb",
       ""},
      {"hung",
       "unit/wrinkle_separate_light.v",
       {{".in_valid_i(in_valid_i)", ".in_valid_i(in_valid_i & carry_i[5:0] != 6'd21)"},
        {"in_ready_o = advance;", "in_ready_o = advance & carry_i[5:0] != 6'd21;"}},
       "light",
       "",
       Kind::kHang},
      {"not_held",
       "wrinkle_core.v",
       {{"= output_others[2*SCREEN_BITS-1:0];", "= output_others[2*SCREEN_BITS-1:0] ^ light_valid;"}},
       "output",
       "x"},
      {"interpolate_product",
       "stage/wrinkle_interpolate.v",
       {{"packet[AT +: BITS_OF_PLANE]", "packet[AT +: BITS_OF_PLANE] ^ (k == 2 && e == 0 ? 1 << (G + 4) : 0)"}},
       "interpolate",
       "c",
       Kind::kValue,
       "blinn"},
      {"interpolate_held",
       "stage/wrinkle_interpolate.v",
       {{".load_i(load_i), .take_i(span_i & first_i)", ".load_i(step_i), .take_i(span_i)"}},
       "interpolate",
       "b",
       Kind::kValue,
       "blinn_held"},
      {"texture_gradient",
       "unit/wrinkle_texture_filter.v",
       {{"textured_i ? value", "textured_i ? value ^ 4"}},
       "texture",
       "gradient",
       Kind::kValue,
       "blinn"},
      {"perturb_product",
       "unit/wrinkle_perturbed.v",
       {{".b_i(c_i)", ".b_i(b_i)"}},
       "perturb",
       "n",
       Kind::kValue,
       "blinn"},
      {"packet_light",
       "stage/wrinkle_packet.v",
       {{"l_q <= word[CONSTANT-1:0]", "l_q <= word[CONSTANT:1]"}},
       "normalize",
       "l",
       Kind::kValue,
       "constant_light"},
      {"normalize_halfangle",
       "unit/wrinkle_halfangle.v",
       {{"{l[N-1], l} + ", "{l[N-1], l} - "}},
       "normalize",
       "h",
       Kind::kValue,
       "pixel_halfangle"},
      {"normalize_scale",
       "unit/wrinkle_deferred_vector.v",
       {{"halve ? {1'b0, r[SCALE_BITS:1]} : r", "halve ? r : r"}},
       "normalize",
       "scale",
       Kind::kValue,
       "deferred"},
      {"light_scaled",
       "unit/wrinkle_separate_light.v",
       {{".scale_b_i(scale_i[SCALE +: SCALE])", ".scale_b_i(scale_i[0 +: SCALE])"}},
       "light",
       "nl",
       Kind::kValue,
       "deferred_blinn"},
      {"light_reflection",
       "unit/wrinkle_reflection.v",
       {{"lit3_q ? re", "lit_q ? re"}},
       "light",
       "nh",
       Kind::kValue,
       "reflection"},
      {"light_rotated",
       "unit/wrinkle_separate_light.v",
       {{".value_i(l_i[2*N +: N])", ".value_i(l_i[N +: N])"}},
       "light",
       "nl",
       Kind::kValue,
       "rotated"},
      {"packet_does_not_wait",
       "stage/wrinkle_packet.v",
       {{"scan_done & walking_i", "scan_done & walking_i & index_q[0]"}},
       "interpolate",
       "",
       Kind::kValue,
       "single"},
      {"interpolate_one_adder",
       "unit/wrinkle_dda_in_place.v",
       {{"{BITS{carry_i | pixel_i}}", "{BITS{pixel_i}}"}},
       "interpolate",
       "",
       Kind::kValue,
       "shared_single"},
      {"normalize_shared",
       "unit/wrinkle_shared_units.v",
       {{"in_l_q ? l_i : in_h_q ? h_i", "in_l_q ? h_i : in_h_q ? l_i"}},
       "normalize",
       "",
       Kind::kValue,
       "shared"},
      {"light_shared",
       "unit/wrinkle_shared_light.v",
       {{"if (second_q) nl_q <= dot;", "if (third_q) nl_q <= dot;"}},
       "light",
       "nl",
       Kind::kValue,
       "shared"},
      {"payload_changes_while_stalled",
       "wrinkle_core.v",
       {{"= output_others[2*SCREEN_BITS-1:0];",
         "= output_others[2*SCREEN_BITS-1:0] ^ turned;\n  reg turned;\n"
         "  always @(posedge clk) turned <= fragment_valid_o & ~fragment_ready_i & ~turned & ~rst;\n"}},
       "output",
       "",
       Kind::kHold},
      // Its weight is zero, so that no fragment shows it.
      {"texel_outside",
       "unit/wrinkle_texture_address.v",
       {{"b = below ? 4'd0 : beyond ? max_level_i :", "b = below ? 4'd0 : beyond ? 4'd15 :"}},
       "texture",
       "",
       Kind::kRequest},
  };
  return list;
}

// A copy of the Verilog with the edits made; each must fit.
fs::path plant(const Planted& planted) {
  const fs::path root = fs::path(testing::TempDir()) / ("wrinkle_planted_" + std::to_string(getpid())) / planted.name;
  fs::remove_all(root);
  fs::create_directories(root);
  fs::copy(fs::path(WRINKLE_SOURCE_DIR) / "rtl", root / "rtl", fs::copy_options::recursive);
  const fs::path file = root / "rtl" / planted.file;
  std::string text = read_text(file);
  for (const auto& [from, to] : planted.edits) {
    const auto at = text.find(from);
    if (at == text.npos) {
      ADD_FAILURE() << planted.file << " has no \"" << from << "\" to plant an error in";
      continue;
    }
    text.replace(at, from.size(), to);
  }
  std::ofstream(file) << text;
  return root;
}

class PlantedSlow : public testing::TestWithParam<Planted> {};

TEST_P(PlantedSlow, IsFoundAndItsStageNamed) {
  const Planted& planted = GetParam();
  const fs::path root = plant(planted);
  BenchOptions options;
  options.seed = 11;
  options.stalls = StallProfile::kRandom;
  options.watchdog = 5000;
  options.model.source_root = root;
  options.model.cache = root / "cache";
  options.model.optimize = false;
  RandomFrame wish;
  wish.seed = 3;
  wish.fragments = 4000;
  const Config config = planted.config();
  const BenchResult result = run_bench(config, random_frame(config, wish), options);
  fs::remove_all(root);

  ASSERT_FALSE(result.equal()) << "the planted error was not found";
  ASSERT_TRUE(result.first.has_value());
  const std::string text = describe(*result.first);
  std::cout << text << '\n';
  EXPECT_EQ(result.first->stage, planted.stage) << text;
  if (!planted.value.empty()) {
    EXPECT_EQ(result.first->value, planted.value) << text;
    EXPECT_NE(result.first->golden, result.first->rtl) << text;
  }
  EXPECT_EQ(result.first->kind, planted.kind) << text;
  // A port is watched clock by clock, and knows no triangle.
  if (planted.kind == Difference::Kind::kHold || planted.kind == Difference::Kind::kRequest) return;
  EXPECT_GE(result.first->triangle, 0) << text;
  EXPECT_GE(result.first->draw, 0) << text;
}

std::string case_name(const testing::TestParamInfo<Planted>& test) { return test.param.name; }

INSTANTIATE_TEST_SUITE_P(Bench, PlantedSlow, testing::ValuesIn(cases()), case_name);

TEST(Planted, NothingPlantedIsNoDifference) {
  BenchOptions options;
  options.stalls = StallProfile::kRandom;
  RandomFrame wish;
  wish.seed = 3;
  wish.fragments = 4000;
  const BenchResult result = run_bench(small_config(), random_frame(small_config(), wish), options);
  EXPECT_TRUE(result.equal()) << (result.first ? describe(*result.first) : "");
}

}  // namespace
}  // namespace wrinkle

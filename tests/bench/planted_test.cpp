// The bench itself is tested: a wrong bit planted in each stage in turn is found, and the stage is named.
// Slow: each case builds a model of its own.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tb/bench.h"
#include "tb/random_frame.h"
#include "tb/random_packets.h"
#include "tests/bench/configurations.h"
#include "tests/bench/verilog_copy.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

struct Planted {
  const char* name;
  const char* file;
  std::vector<std::pair<std::string, std::string>> edits;  // text, and what is put in its place
  std::string stage, value;                                // as it must be named
  Difference::Kind kind = Difference::Kind::kValue;
  std::string rival = {};   // which of rivals(); empty: small_config()
  bool by_packets = false;  // only by packets that set-up never sends
  bool by_law = false;      // only where the law of the streams is watched

  Config config() const {
    for (const Rival& r : rivals())
      if (rival == r.name) return r.config;
    if (rival == "longest_packet") return longest_packet();
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
      {"texture_gloss",
       "unit/wrinkle_texture_filter.v",
       {{"assign gloss_o = tint_q;", "assign gloss_o = tint_q ^ 4;"}},
       "texture",
       "gloss",
       Kind::kValue,
       "gloss_without_decal"},
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
      {"output_gloss",
       "stage/wrinkle_output.v",
       {{"{{T{1'b0}}, gloss_i[T-1]}", "{{T{1'b0}}, gloss_i[T-2]}"}},
       "output",
       "colour",
       Kind::kValue,
       "gloss_without_decal"},
      {"output_gloss_of_the_fragment_before",
       "unit/wrinkle_shade.v",
       {{"assign base = base2_q;\n      always @(posedge clk) if (advance_i) base2_q <= base1_q;",
         "assign base = base1_q;"}},
       "output",
       "colour",
       Kind::kValue,
       "gloss_without_decal"},
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
       {{"{BITS{carry}} & dw_q", "{BITS{step}} & dw_q"}},
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
      {"light_looks_after_the_transfer",
       "unit/wrinkle_shared_light.v",
       {{"wire [3*W-1:0]            other = second_q ?",
         "reg [3*W-1:0] n_q;\n  always @(posedge clk) n_q <= n_i;\n"
         "  wire [3*W-1:0] n = third_q ? n_q : n_i;\n  wire [3*W-1:0] other = third_q ?"},
        {".a_i(n_i[0 ", ".a_i(n[0 "},
        {".a_i(n_i[W ", ".a_i(n[W "},
        {".a_i(n_i[2*W ", ".a_i(n[2*W "},
        {"if (second_q) nl_q <= dot;", "if (third_q) nl_q <= dot;"}},
       "light",
       "nl",
       Kind::kValue,
       "shared",
       false,
       true},
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
      {"idle_with_a_packet_held",
       "wrinkle_core.v",
       {{"~(packet_busy | fragments_busy)", "~fragments_busy"}},
       "",
       "",
       Kind::kIdle},
      {"idle_with_a_fragment_in_flight",
       "wrinkle_core.v",
       {{"~(packet_busy | fragments_busy)", "~(packet_busy | scan_busy | texture_busy)"}},
       "",
       "",
       Kind::kIdle},
      {"packet_counts_32_words",
       "stage/wrinkle_packet.v",
       {{"opcode ? FIRST : index_q + FIRST", "opcode ? FIRST : {1'b0, index_q[INDEX-2:0]} + FIRST"}},
       "scan",
       "",
       Kind::kHang,
       "longest_packet",
       true},
      {"packet_texture_of_8_bits",
       "stage/wrinkle_packet.v",
       {{"{word[35:12], word[11:8]}", "{4'd0, word[31:12], word[11:8]}"}},
       "texture",
       "",
       Kind::kValue,
       "",
       true},
      {"scan_no_rows_by_the_first_edge",
       "stage/wrinkle_scan.v",
       {{"packet_end0 == {(X + 1){1'b0}} ? end1_fields : end0_fields", "end0_fields"}},
       "scan",
       "",
       Kind::kValue,
       "",
       true},
      {"scan_takes_an_offer_back",
       "stage/wrinkle_scan.v",
       {{"& ~waits & ~held;", "& ~waits;"}},
       "normalize",
       "",
       Kind::kValue,
       "shared_single_phong",
       true},
      // A buffer behind it takes either, so that no fragment shows it.
      {"scan_takes_an_offer_back_before_a_buffer",
       "stage/wrinkle_scan.v",
       {{"& ~waits & ~held;", "& ~waits;"}},
       "",
       "",
       Kind::kMissing,
       "shared_single",
       true,
       true},
      {"normalize_none_wraps",
       "unit/wrinkle_unit_vector.v",
       {{".value_i(rounded), .result_o(unit[k*N +: N])",
         ".value_i({rounded[N-1], rounded[N-1:0]}), .result_o(unit[k*N +: N])"}},
       "normalize",
       "",
       Kind::kValue,
       "without_normalizers",
       true},
      {"light_scale_of_4_wraps",
       "unit/wrinkle_scaled_dot.v",
       {{"scale1_q  <= scale0", "scale1_q  <= {{(SCALE - DOT_BITS - 2){1'b0}}, scale0[DOT_BITS+1:0]}"}},
       "light",
       "",
       Kind::kValue,
       "deferred_blinn",
       true},
      {"texture_mirrored_4096",
       "unit/wrinkle_wrap.vh",
       {{"|(index[12:0] & period)", "|(index[11:0] & period[11:0])"}},
       "texture",
       "",
       Kind::kValue,
       "",
       true},
  };
  return list;
}

// A copy of the Verilog with the edits made; each must fit.
fs::path plant(const Planted& planted) {
  const fs::path root = copy_verilog(planted.name);
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
  if (planted.by_law) {
    invert_payloads_that_are_not_valid(root);
    stop_at_an_offer_taken_back(root);
  }
  return root;
}

BenchResult drawn(const Planted& planted, const BenchOptions& options) {
  const Config config = planted.config();
  if (!planted.by_packets) {
    RandomFrame wish;
    wish.seed = 3;
    wish.fragments = 4000;
    return run_bench(config, random_frame(config, wish), options);
  }
  const std::vector<Texture> textures = random_textures(config, 3);
  RandomPackets wish;
  wish.seed = 3;
  wish.fragments = 20000;
  wish.draws = 100;
  return run_bench(config, random_packets(config, textures, wish), textures, "random packets", options);
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
  const BenchResult result = drawn(planted, options);
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
  // A port is watched clock by clock, and knows no triangle; a packet that never ends draws none.
  const std::set<Difference::Kind> without{Difference::Kind::kHold, Difference::Kind::kRequest,
                                           Difference::Kind::kIdle};
  if (without.contains(planted.kind) || planted.stage.empty()) return;
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

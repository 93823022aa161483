#include "sim/synthesis/check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tb/process.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// A source and the gates that Yosys makes of it, to be spoilt.
class NetlistCheck : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    options_.folder = fs::path(::testing::TempDir()) / ("wrinkle_check_" + name);
    fs::remove_all(options_.folder);
    fs::create_directories(options_.folder);
    options_.gates = options_.folder / "gates.blif";
  }
  void TearDown() override { fs::remove_all(options_.folder); }

  // The gates of `top` by a script between reading the source and writing them.
  void make(const std::string& top, const std::string& source, const std::string& passes) {
    options_.top = top;
    options_.sources = {options_.folder / "source.v"};
    std::ofstream(options_.sources[0]) << source;
    const fs::path script = options_.folder / "gates.ys";
    std::ofstream(script) << passes << "\nwrite_blif -gates -icells " << options_.gates.string() << "\n";
    ASSERT_EQ(Process({"yosys", "-Q", "-s", script}, options_.folder / "log").wait(), 0)
        << read_text(options_.folder / "log");
  }

  void make_counter() {
    make("counter", R"(
module counter (input clk, input rst, input advance_i, input [7:0] step_i, output [7:0] count_o, output big_o);
  reg [7:0] count_q;
  always @(posedge clk)
    if (rst) count_q <= 8'd0;
    else if (advance_i) count_q <= count_q + step_i;
  assign count_o = count_q;
  assign big_o = count_q > 8'd200;
endmodule
)",
         "read_verilog " + (options_.folder / "source.v").string() +
             "\nsynth -flatten\ndfflegalize -cell $_DFF_P_ x\nopt_clean");
  }

  // Replaces the first `from` behind the first `after` of the netlist.
  void spoil(const std::string& after, const std::string& from, const std::string& to) {
    std::string text = read_text(options_.gates);
    const std::size_t start = text.find(after), at = text.find(from, start);
    ASSERT_NE(at, std::string::npos);
    std::ofstream(options_.gates) << text.replace(at, from.size(), to);
  }

  void expect_refused(const std::string& named) {
    try {
      check_netlist(options_);
      FAIL() << "not refused";
    } catch (const NetlistDiffers& difference) {
      EXPECT_THAT(difference.what(), HasSubstr(named));
      EXPECT_THAT(difference.what(), HasSubstr("at clock"));
      EXPECT_THAT(difference.what(), HasSubstr("step_i="));
    }
  }

  CheckOptions options_;
};

TEST_F(NetlistCheck, WhatIsRightIsEqualAndEverythingChanges) {
  make_counter();
  options_.faults = 100;
  const NetlistChecked checked = check_netlist(options_);
  EXPECT_GE(checked.clocks, 2000);
  EXPECT_EQ(checked.registers, 8);
  EXPECT_EQ(checked.registers_changed, 8);
  EXPECT_EQ(checked.outputs, 9);
  EXPECT_EQ(checked.outputs_changed, 9);
  EXPECT_EQ(checked.faults, 100);
  EXPECT_GE(checked.faults_found, 97);
}

TEST_F(NetlistCheck, AnotherGateIsRefused) {
  make_counter();
  spoil(".gate $_XOR_", "$_XOR_", "$_XNOR_");
  expect_refused("counter");
}

TEST_F(NetlistCheck, AStuckPinIsRefused) {
  make_counter();
  spoil(".gate $_XOR_", "A=", "A=$false UNUSED=");
  expect_refused("counter");
}

constexpr const char* kDelayed = R"(
module delayed (input clk, input [1:0] step_i, output [1:0] step_o);
  reg [1:0] early_q, late_q;
  always @(posedge clk) {late_q, early_q} <= {early_q, step_i};
  assign step_o = late_q;
endmodule
)";

TEST_F(NetlistCheck, AMissingRegisterIsRefused) {
  make("delayed", kDelayed, "read_verilog " + (options_.folder / "source.v").string() + "\nsynth -flatten");
  EXPECT_EQ(check_netlist(options_).registers, 4);
  std::string text = read_text(options_.gates);
  const std::size_t at = text.find(".gate $_DFF_P_ C=clk D="), end = text.find('\n', at);
  ASSERT_NE(at, std::string::npos);
  std::string line = text.substr(at, end - at);
  const std::size_t d = line.find("D=") + 2, q = line.find(" Q=");
  line = ".names " + line.substr(d, q - d) + " " + line.substr(q + 3) + "\n1 1";
  std::ofstream(options_.gates) << text.replace(at, end - at, line);
  expect_refused("delayed");
}

// A register that never becomes 1: what it would do then is not known.
TEST_F(NetlistCheck, WhatNeverChangesHasNoFigure) {
  make("latch", R"(
module latch (input clk, input step_i, output step_o);
  reg kept_q;
  always @(posedge clk) kept_q <= kept_q & step_i;
  assign step_o = kept_q;
endmodule
)",
       "read_verilog " + (options_.folder / "source.v").string() + "\nsynth -flatten");
  try {
    check_netlist(options_);
    FAIL() << "not refused";
  } catch (const SynthesisError& error) {
    EXPECT_THAT(error.what(), HasSubstr("kept_q[0] of latch never changed in 100000 clocks"));
  }
}

// Where not every register can be set, one may stay as it is whatever comes in. That is counted; where each can be set,
// it is refused.
TEST_F(NetlistCheck, WhatAnFpgaHidesMayKeepARegister) {
  make("hidden", R"(
module hidden (input clk, input step_i, output step_o);
  reg never_q, early_q, late_q;
  always @(posedge clk) {never_q, early_q, late_q} <= {never_q & early_q, step_i, early_q | never_q};
  assign step_o = late_q;
endmodule
)",
       "read_verilog " + (options_.folder / "source.v").string() + "\nproc\nsimplemap\nclean");
  EXPECT_THROW(check_netlist(options_), SynthesisError);
  std::string text = read_text(options_.gates);
  for (std::size_t at = text.find("early_q"); at != std::string::npos; at = text.find("early_q"))
    text.replace(at, 7, "inside");
  std::ofstream(options_.gates) << text;
  options_.keeps_registers = false;
  const NetlistChecked checked = check_netlist(options_);
  EXPECT_EQ(checked.registers, 2);
  EXPECT_EQ(checked.registers_changed, 1);
  EXPECT_EQ(checked.outputs_changed, 1);
  EXPECT_GE(checked.clocks, 100'000);
}

// An FPGA's cell may hold a register without its name. Then both sides start from another state, and soon it matters no
// more; where names are kept, that is refused.
TEST_F(NetlistCheck, RegistersWithoutNamesAreForgotten) {
  make("delayed", kDelayed, "read_verilog " + (options_.folder / "source.v").string() + "\nsynth -flatten");
  std::string text = read_text(options_.gates);
  for (std::size_t at = text.find("early_q"); at != std::string::npos; at = text.find("early_q"))
    text.replace(at, 7, "inside");
  std::ofstream(options_.gates) << text;
  expect_refused("delayed");
  options_.keeps_registers = false;
  const NetlistChecked checked = check_netlist(options_);
  EXPECT_EQ(checked.registers, 2);
  EXPECT_EQ(checked.outputs_changed, 2);
  spoil("inside[1]", "D=", "D=$true UNUSED=");
  expect_refused("delayed");
}

// A buffer of 64 places, into which a word comes only where five streams have all gone on for 16 clocks.
TEST_F(NetlistCheck, EveryPlaceOfADeepBufferChanges) {
  make("deep", R"(
module deep (input clk, input rst, input a_valid_i, input b_valid_i, input c_valid_i, input d_valid_i,
             input e_ready_i, input [3:0] data_i, output [3:0] data_o);
  reg [3:0]  memory_q [0:63];
  reg [15:0] gone_on_q;
  reg [5:0]  write_q, read_q;
  wire goes_on = a_valid_i & b_valid_i & c_valid_i & d_valid_i & e_ready_i;
  wire push = goes_on & (&gone_on_q);
  assign data_o = memory_q[read_q];
  always @(posedge clk) begin
    gone_on_q <= {gone_on_q[14:0], goes_on & ~rst};
    if (push) memory_q[write_q] <= data_i;
    write_q <= rst ? 6'd0 : write_q + {5'd0, push};
    read_q  <= rst ? 6'd0 : read_q + 6'd1;
  end
endmodule
)",
       "read_verilog " + (options_.folder / "source.v").string() +
           "\nsynth -flatten\ndfflegalize -cell $_DFF_P_ x\nopt_clean");
  const NetlistChecked checked = check_netlist(options_);
  EXPECT_EQ(checked.registers, 64 * 4 + 16 + 12);
  EXPECT_EQ(checked.registers_changed, checked.registers);
}

// y is a whatever the second gate does: its faults are proved to change nothing, all others are found.
TEST_F(NetlistCheck, FaultsThatChangeNothingAreProvedToChangeNothing) {
  make("absorbed", R"(
module absorbed (input a_i, input b_i, output y_o, output z_o);
  wire both, either;
  \$_AND_ and_gate (.A(a_i), .B(b_i), .Y(both));
  \$_OR_ or_gate (.A(a_i), .B(both), .Y(y_o));
  \$_XOR_ xor_gate (.A(a_i), .B(b_i), .Y(z_o));
endmodule
)",
       "read_verilog -icells " + (options_.folder / "source.v").string() + "\nhierarchy -top absorbed");
  std::ofstream(options_.sources[0]) << R"(
module absorbed (input a_i, input b_i, output y_o, output z_o);
  assign y_o = a_i, z_o = a_i ^ b_i;
endmodule
)";
  options_.faults = 100;
  const NetlistChecked checked = check_netlist(options_);
  EXPECT_GT(checked.faults_redundant, 10);
  EXPECT_GT(checked.faults_found, 50);
  EXPECT_EQ(checked.faults_found + checked.faults_redundant, 100);
  EXPECT_THAT(checked.faults_missed, ::testing::IsEmpty());
}

// Cells that stay modules: each instance has gates of its own.
TEST_F(NetlistCheck, CellsMayStayModules) {
  make("parts", R"(
module part (input clk, input step_i, output reg out_o);
  always @(posedge clk) out_o <= ~step_i;
endmodule
module parts (input clk, input [2:0] step_i, output [2:0] step_o);
  wire [2:0] early_q;
  part first (.clk(clk), .step_i(step_i[0]), .out_o(early_q[0]));
  part second (.clk(clk), .step_i(step_i[1]), .out_o(early_q[1]));
  part third (.clk(clk), .step_i(step_i[2]), .out_o(early_q[2]));
  assign step_o = early_q;
endmodule
)",
       "read_verilog " + (options_.folder / "source.v").string() + "\nhierarchy -top parts\nproc\nsimplemap\nclean");
  EXPECT_THAT(read_text(options_.gates), HasSubstr(".subckt part"));
  options_.keeps_registers = false;
  const NetlistChecked checked = check_netlist(options_);
  EXPECT_EQ(checked.outputs_changed, 3);
  spoil(".model part", "$_NOT_", "$_BUF_");
  expect_refused("parts");
}

TEST_F(NetlistCheck, AMissingResetIsRefused) {
  make("held", R"(
module held (input clk, input rst, input [1:0] step_i, output [1:0] q_o);
  reg [1:0] q_q;
  always @(posedge clk) if (rst) q_q <= 2'd0; else q_q <= q_q ^ step_i;
  assign q_o = q_q;
endmodule
)",
       "read_verilog " + (options_.folder / "source.v").string() +
           "\nsynth -flatten\ndfflegalize -cell $_DFF_P_ x\nopt_clean");
  std::ofstream(options_.folder / "other.v") << R"(
module held (input clk, input rst, input [1:0] step_i, output [1:0] q_o);
  reg [1:0] q_q;
  always @(posedge clk) q_q <= {q_q[1] ^ step_i[1], !rst && (q_q[0] ^ step_i[0])};
  assign q_o = q_q;
endmodule
)";
  const fs::path script = options_.folder / "other.ys";
  std::ofstream(script) << "read_verilog " << (options_.folder / "other.v").string()
                        << "\nsynth -flatten\nwrite_blif -gates -icells " << options_.gates.string() << "\n";
  ASSERT_EQ(Process({"yosys", "-Q", "-s", script}, options_.folder / "log").wait(), 0);
  expect_refused("q_o[1]");
}

// Registers of every kind of path and fate start alike on both sides: in an else branch, in a memory, two that become
// one, one that becomes a constant, and one that nothing reads.
TEST_F(NetlistCheck, EveryRegisterStartsAlike) {
  make("fates", R"(
module fates #(parameter KIND = 2) (input clk, input push_i, input [1:0] at_i, input [2:0] data_i,
                                    output [2:0] data_o, output [2:0] twin_o, output one_o);
  generate
    if (KIND == 0) begin : none assign data_o = data_i; end
    else if (KIND == 1) begin : wire_alone assign data_o = ~data_i; end
    else begin : buffer
      reg [2:0] memory_q [0:3];
      always @(posedge clk) if (push_i) memory_q[at_i] <= data_i;
      assign data_o = memory_q[at_i];
    end
  endgenerate
  reg [2:0] first_q, second_q, unread_q;
  reg one_q;
  always @(posedge clk) begin
    first_q  <= data_i;
    second_q <= data_i;
    unread_q <= data_i;
    one_q    <= 1'b1;
  end
  assign twin_o = first_q & {3{at_i[0]}} | second_q & ~{3{at_i[0]}};
  assign one_o = one_q;
endmodule
)",
       "read_verilog " + (options_.folder / "source.v").string() +
           "\nsynth -flatten\ndfflegalize -cell $_DFF_P_ x\nopt_clean");
  const NetlistChecked checked = check_netlist(options_);
  EXPECT_EQ(checked.registers, 4 * 3 + 3);
  EXPECT_EQ(checked.registers_changed, 4 * 3 + 3);
  EXPECT_EQ(checked.outputs_changed, 7);
}

// Every cell of logic by its Liberty function, which the check reads, against the vendor's Verilog.
TEST_F(NetlistCheck, LibertyFunctionsAreThoseOfTheVendorsVerilog) {
  struct Cell {
    const char* names;
    int inputs;
    const char* outputs;
  };
  static constexpr Cell kCells[] = {{"BUFX2 BUFX4 CLKBUF1 CLKBUF2 CLKBUF3 INVX1 INVX2 INVX4 INVX8", 1, "Y"},
                                    {"AND2X1 AND2X2 NAND2X1 NOR2X1 OR2X1 OR2X2 XNOR2X1 XOR2X1", 2, "Y"},
                                    {"HAX1", 2, "YC YS"},
                                    {"AOI21X1 NAND3X1 NOR3X1 OAI21X1", 3, "Y"},
                                    {"FAX1", 3, "YC YS"},
                                    {"MUX2X1", -1, "Y"},
                                    {"AOI22X1 OAI22X1", 4, "Y"}};
  for (const CellLibrary library : {CellLibrary::kOsu035, CellLibrary::kOsu018}) {
    std::string ports, cells;
    for (const Cell& kind : kCells) {
      std::istringstream names(kind.names);
      for (std::string name; names >> name;) {
        std::string pins;
        const std::string inputs = kind.inputs < 0 ? "ABS" : std::string("ABCD").substr(0, std::size_t(kind.inputs));
        for (std::size_t i = 0; i < inputs.size(); ++i)
          pins += std::string(i ? ", ." : ".") + inputs[i] + "(a_i[" + std::to_string(i) + "])";
        std::istringstream outputs(kind.outputs);
        for (std::string output; outputs >> output;) {
          ports += ", output " + name + "_" + output;
          pins += ", ." + output + "(" + name + "_" + output + ")";
        }
        cells += "  " + name + " u_" + name + " (" + pins + ");\n";
      }
    }
    fs::path vendor = liberty_path(library);
    vendor.replace_extension(".v");
    make("cells", "module cells (input [3:0] a_i" + ports + ");\n" + cells + "endmodule\n",
         "read_verilog " + (options_.folder / "source.v").string() + "\nread_liberty -ignore_miss_func " +
             liberty_path(library).string() + "\nhierarchy -top cells\nproc\nflatten\nopt_clean");
    options_.sources.push_back(vendor);
    const NetlistChecked checked = check_netlist(options_);
    EXPECT_EQ(checked.outputs, 28);
    EXPECT_EQ(checked.outputs_changed, 28);
  }
}

// A module that has a map is made of the map, whose adders are cells, and is compared with the Verilog of rtl/, which
// Icarus reads and the cells of a map it would not.
TEST_F(NetlistCheck, WhatHasAMapIsComparedWithItsVerilog) {
  SynthesisOptions options;
  options.cache = options_.folder / "cache";
  const SynthesisResult result = synthesise("wrinkle_truncated_squares", {{"BITS", 5}}, CellLibrary::kOsu035, options);
  EXPECT_GE(result.checked.clocks, 2000);
  EXPECT_GT(result.cells.at("FAX1"), 20);
}

// Shift registers of Xilinx lose their enable in Yosys (upstream 6058), so none may be made.
TEST_F(NetlistCheck, AnEnabledDelayIsEqualOnXilinx) {
  SynthesisOptions options;
  options.cache = options_.folder / "cache";
  const SynthesisResult result =
      synthesise("wrinkle_delay", {{"WIDTH", 1}, {"RANKS", 8}}, CellLibrary::kXilinx, options);
  EXPECT_EQ(result.flip_flops, 8);
  EXPECT_GE(result.checked.clocks, 4000);
}

TEST_F(NetlistCheck, ItsWordsFindNinetyNineOfAHundredFaults) {
  SynthesisOptions options;
  options.cache = options_.folder / "cache";
  options.faults = 300;
  for (const char* stage : {"wrinkle_packet", "wrinkle_scan", "wrinkle_output"}) {
    const NetlistChecked checked = synthesise(stage, {}, CellLibrary::kOsu035, options).checked;
    EXPECT_EQ(checked.faults, 300) << stage;
    EXPECT_GE(checked.faults_found + checked.faults_redundant, 297) << stage;
  }
}

// The old map of adders, kept as a file of this test.
TEST_F(NetlistCheck, GuessedAddersAreRefused) {
  SynthesisOptions options;
  options.cache = options_.folder / "cache";
  options.adders = fs::path(WRINKLE_SOURCE_DIR) / "tests" / "synthesis" / "data" / "guessed_adders.ys";
  try {
    synthesise("wrinkle_light", {}, CellLibrary::kOsu035, options);
    FAIL() << "not refused";
  } catch (const NetlistDiffers& difference) {
    EXPECT_THAT(difference.what(), HasSubstr("wrinkle_light"));
  }
}

}  // namespace
}  // namespace wrinkle

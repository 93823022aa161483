// The Verilog of a check between files: what goes in, the registers it starts with, and what comes out.
#pragma once

#include <string>
#include <vector>

#include "sim/synthesis/check.h"
#include "sim/synthesis/elaborate.h"
#include "sim/synthesis/gates.h"

namespace wrinkle {

// Ports of one direction without the clock, and the nets of their bits: bit 0 of the first port first.
struct Bundle {
  std::vector<NetlistPort> ports;
  std::vector<std::uint32_t> nets;

  Bundle(const std::vector<NetlistPort>& all, bool is_input);
  // "a_i=01 b_i=1" of a line of bits, bit 0 last.
  std::string text(const std::string& line) const;
  std::string name_of(std::size_t bit) const;
};

// Ports NAME_0_, NAME_1_ ... as one port NAME.
std::vector<NetlistPort> joined(const std::vector<NetlistPort>& bits);

struct Testbench {
  Bundle inputs, outputs;
  bool has_clock = false;
  std::vector<Register> registers;
  int clocks = 1000;
  int shortest_episode = 64;
};

// A module `wrinkle_check` around the Verilog of `options`. It reads a line for each clock from `inputs` in the folder
// of the check and a line for each register and episode from `state`, at +episode=CLOCKS from each other; into
// `results` it writes, for each clock, all registers, the first one last, and behind them the outputs.
std::string testbench_text(const Testbench& bench, const CheckOptions& options);

}  // namespace wrinkle

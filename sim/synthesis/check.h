// A netlist against the Verilog it was made from: the same inputs into both, every output compared at every clock.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/synthesis/synthesis.h"

namespace wrinkle {

struct CheckOptions {
  std::string top;
  VerilogParameters parameters;
  std::vector<std::filesystem::path> sources, include_folders;  // of the Verilog
  std::filesystem::path gates;                                  // the netlist as read_gates takes it
  std::filesystem::path folder;                                 // for what the simulator reads and writes
  bool registers = true;  // off: in the netlist registers are wires, and each port is split into bits NAME_I_
  int faults = 0;         // how many single faults of the netlist are tried after it was found equal
};

// Icarus simulates the Verilog, from power-up without known registers and through resets. What it does not know is not
// compared. The netlist powers up in 64 ways at once, and soon all of them must agree. Runs of 1,000 clocks follow each
// other until every register and every output has been 0 and 1, two of them at least and eight at most.
//
// Throws NetlistDiffers, whose text says the first output, its clock and the inputs.
NetlistChecked check_netlist(const CheckOptions& options);

}  // namespace wrinkle

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
  bool registers = true;        // off: in the netlist registers are wires, and each port is split into bits NAME_I_
  bool keeps_registers = true;  // off: some may be inside of an FPGA's multipliers and memories, without their names
  int faults = 0;               // how many single faults of the netlist are tried after it was found equal
};

// Icarus simulates the Verilog, gates.h the netlist. Both start from the same random state, and go on from another one
// every 40 or every 5 clocks: each register of the Verilog is what the net of its name in the netlist is, and random
// where there is none. So every output and every register is known and compared at every clock, the first included, and
// a reset that is missing is seen. Runs of 1,000 clocks follow each other until a clock has changed every register to 0
// and to 1 and every output has been both: twenty at least (of an FPGA and without registers eight), a hundred at most,
// and then SynthesisError names what has not. An output that the netlist wires to a constant has one value only.
//
// A netlist that does not keep its registers starts from another random state than the Verilog, and outputs are
// compared from clock 256 on, when what came in has taken the place of either. A register that no input makes change is
// then counted as it is, after a hundred runs.
//
// Throws NetlistDiffers, whose text says the first output, its clock and the inputs.
NetlistChecked check_netlist(const CheckOptions& options);

}  // namespace wrinkle

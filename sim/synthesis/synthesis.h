// Area, cells and speed of a Verilog module, by Yosys, OpenSTA and nextpnr run as child processes. Results are kept on
// disk under a key of everything they depend on.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace wrinkle {

// The scripts in sim/synthesis/scripts: one for standard cells, one for each FPGA.
enum class CellLibrary { kOsu035, kOsu018, kIce40, kEcp5, kXilinx };

// The value of a Verilog parameter: a number, or a constant as Yosys writes it.
struct VerilogValue {
  VerilogValue(std::int64_t number) : text(std::to_string(number)) {}
  VerilogValue(std::string constant) : text(std::move(constant)) {}
  bool operator==(const VerilogValue&) const = default;

  std::string text;
};

// Verilog names and values.
using VerilogParameters = std::map<std::string, VerilogValue>;

// Every member is part of the cache key.
struct SynthesisOptions {
  // Sums become ripples and trees of the library's full adder; off: Yosys's own adders in simple gates. Standard cells.
  bool full_adders = true;
  // With full_adders: the script that maps adders; empty: scripts/full_adders.ys.
  std::filesystem::path adders;
  // Name of a script scripts/EFFORT.abc: `area`, smallest gates, then buffers and sizes; `speed`, the same for delay;
  // `unbuffered`, smallest gates alone, whose path through a net of many loads means nothing. Standard cells.
  std::string effort = "area";
  // off: registers are wires, so that the area is that of the logic alone and the path goes through all ranks. For a
  // pipeline without feedback. Standard cells.
  bool registers = true;
  // iCE40: place and route, on an UP5K, between shift registers that stand in for pins.
  bool place_and_route = false;
  // How many single faults of the netlist are tried, to measure what its check finds.
  int faults = 0;
  // Verilog files; empty: those of rtl/ and its folders in this project.
  std::vector<std::filesystem::path> sources;
  // Where results are kept; empty: $WRINKLE_CACHE/synthesis, else `synthesis` in the build directory.
  std::filesystem::path cache;
};

// A product of the source, before it became adders or a DSP.
struct Multiplier {
  int a_bits = 0;
  int b_bits = 0;
  bool is_signed = false;
  bool operator==(const Multiplier&) const = default;
};

// How a netlist was compared with the Verilog it was made from (check.h). There is no result of one that differs.
struct NetlistChecked {
  int clocks = 0;
  // Registers and outputs, and those that have been 0 and 1 while all was compared.
  int registers = 0, registers_changed = 0;
  int outputs = 0, outputs_changed = 0;
  // Single faults put into the netlist, those that the same inputs found, those that are proved to change nothing, and
  // what the rest are.
  int faults = 0, faults_found = 0, faults_redundant = 0;
  std::vector<std::string> faults_missed;
};

struct SynthesisResult {
  // Standard cells; 0 for an FPGA. nand2 is in areas of the library's NAND2X1.
  double um2 = 0;
  double nand2 = 0;
  // Longest path between flip-flops and pins: typical corner, no wires. For an FPGA, of the placed and routed design,
  // shift registers included; 0 when it was not asked for.
  double critical_path_ns = 0;
  int flip_flops = 0;
  std::vector<Multiplier> multipliers;
  // Every cell of the netlist by type, flattened.
  std::map<std::string, int> cells;
  NetlistChecked checked;
  // Tools and scripts that made this, for the report's provenance.
  std::string provenance;
};

// A tool failed; what() has the end of its output.
struct SynthesisError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A netlist does something else than its Verilog; what() has the first output, its clock and the inputs.
struct NetlistDiffers : SynthesisError {
  using SynthesisError::SynthesisError;
};

// Called with what is being done when a result is not in the cache.
using SynthesisProgress = std::function<void(const std::string& message)>;

// Synthesises module `top` alone and compares the netlist with the Verilog; throws NetlistDiffers. Parameters not given
// keep the values of the source. Safe to call from several threads and processes.
SynthesisResult synthesise(const std::string& top, const VerilogParameters& parameters, CellLibrary library,
                           const SynthesisOptions& options = {}, const SynthesisProgress& progress = {});

// `osu035`, `osu018`, `ice40`, `ecp5`, `xilinx`.
std::string cell_library_name(CellLibrary library);

// Area in um^2 of every cell as it is drawn, from a LEF file. The areas of the Liberty files of osu035 and osu018 are
// wrong for some cells.
std::map<std::string, double> lef_areas(const std::filesystem::path& lef);

// The files of a standard cell library.
std::filesystem::path liberty_path(CellLibrary library);
std::filesystem::path lef_path(CellLibrary library);

}  // namespace wrinkle

// Cells of FPGAs by stage, and the clock that place and route reaches for stages that fit.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "golden/config/config.h"
#include "sim/synthesis/synthesis.h"

namespace wrinkle {

// Look-up tables, flip-flops, multiplier and memory blocks of a netlist.
struct FpgaCells {
  int luts = 0, flip_flops = 0, carries = 0, multipliers = 0, memories = 0;
};
FpgaCells count_fpga_cells(const SynthesisResult& result);

// One stage on one FPGA, or `core`, the whole. With `place`, an iCE40 design that an UP5K holds is placed and routed.
struct FpgaStage {
  std::string library, stage;
  FpgaCells cells;
  SynthesisResult result;
  std::string placed;  // ns
};
FpgaStage measure_fpga(const Config& config, const std::string& stage, CellLibrary library, bool place,
                       const SynthesisProgress& progress);
nlohmann::json to_json(const FpgaStage& stage);

constexpr CellLibrary kFpgas[] = {CellLibrary::kIce40, CellLibrary::kEcp5, CellLibrary::kXilinx};

// Prints a table and gives the same as an array of {library, stage, luts, flip_flops, carries, multipliers, memories,
// placed_ns}. `stages` empty: all, and the whole. With `place`, iCE40 designs that an UP5K holds are placed and routed.
nlohmann::json measure_fpga(const Config& config, const std::vector<std::string>& stages, bool place,
                            const SynthesisProgress& progress);

}  // namespace wrinkle

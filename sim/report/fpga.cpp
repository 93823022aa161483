#include "sim/report/fpga.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "sim/report/modules.h"
#include "sim/synthesis/result.h"

namespace wrinkle {
namespace {

// What an iCE40 UP5K holds. Shift registers stand in for pins that it does not have, and take logic cells too.
constexpr int kUp5kCells = 5280, kUp5kMultipliers = 8, kUp5kMemories = 30;

bool may_fit(const FpgaCells& cells) {
  return cells.luts + cells.flip_flops <= kUp5kCells && cells.multipliers <= kUp5kMultipliers &&
         cells.memories <= kUp5kMemories;
}

}  // namespace

FpgaCells count_fpga_cells(const SynthesisResult& result) {
  static const std::regex lut("SB_LUT4|LUT[1-6]"), carry("SB_CARRY|CCU2C|CARRY4"),
      multiplier("SB_MAC16|MULT18X18D|DSP48E1"),
      memory("SB_RAM40_4K.*|DP16KD|TRELLIS_DPR16X4|RAMB(18|36)E1|RAM(32|64)(M|X1D)|RAM128X1D");
  FpgaCells cells;
  cells.flip_flops = result.flip_flops;
  for (const auto& [type, count] : result.cells) {
    if (std::regex_match(type, lut)) cells.luts += count;
    if (std::regex_match(type, carry)) cells.carries += count;
    if (std::regex_match(type, multiplier)) cells.multipliers += count;
    if (std::regex_match(type, memory)) cells.memories += count;
  }
  return cells;
}

FpgaStage measure_fpga(const Config& config, const std::string& stage, CellLibrary library, bool place,
                       const SynthesisProgress& progress) {
  const auto [module, values] = stage_module(stage, config);
  SynthesisOptions options;
  FpgaStage found{cell_library_name(library), stage, {}, synthesise(module, values, library, options, progress), "-"};
  found.cells = count_fpga_cells(found.result);
  if (place && library == CellLibrary::kIce40 && found.cells.luts > 0 && may_fit(found.cells)) {
    options.place_and_route = true;
    try {
      found.result = synthesise(module, values, library, options, progress);
      found.placed = fmt::format("{:.1f}", found.result.critical_path_ns);
    } catch (const NetlistDiffers&) {
      throw;
    } catch (const SynthesisError&) {
      found.placed = "too large";
    }
  }
  return found;
}

nlohmann::json measure_fpga(const Config& config, const std::vector<std::string>& stages, bool place,
                            const SynthesisProgress& progress) {
  nlohmann::json rows = nlohmann::json::array();
  std::vector<std::string> names = stages.empty() ? stage_names() : stages;
  if (stages.empty()) names.push_back("core");
  fmt::print("{:<8} {:<12} {:>7} {:>7} {:>8} {:>12} {:>9} {:>10} {:>7}\n", "FPGA", "stage", "LUTs", "FFs", "carries",
             "multipliers", "memories", "placed ns", "equal");
  for (const CellLibrary library : kFpgas) {
    for (const std::string& name : names) {
      const FpgaStage stage = measure_fpga(config, name, library, place, progress);
      const FpgaCells& cells = stage.cells;
      fmt::print("{:<8} {:<12} {:>7} {:>7} {:>8} {:>12} {:>9} {:>10} {:>7}\n", stage.library, name, cells.luts,
                 cells.flip_flops, cells.carries, cells.multipliers, cells.memories, stage.placed,
                 stage.result.checked.clocks);
      rows.push_back(to_json(stage));
    }
  }
  return rows;
}

nlohmann::json to_json(const FpgaStage& stage) {
  return {{"library", stage.library},
          {"stage", stage.stage},
          {"luts", stage.cells.luts},
          {"flip_flops", stage.cells.flip_flops},
          {"carries", stage.cells.carries},
          {"multipliers", stage.cells.multipliers},
          {"memories", stage.cells.memories},
          {"placed_ns", stage.result.critical_path_ns},
          {"checked", to_json(stage.result.checked)}};
}

}  // namespace wrinkle

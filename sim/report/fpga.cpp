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

nlohmann::json measure_fpga(const Config& config, const std::vector<std::string>& stages, bool place,
                            const SynthesisProgress& progress) {
  nlohmann::json rows = nlohmann::json::array();
  std::vector<std::string> names = stages.empty() ? stage_names() : stages;
  if (stages.empty()) names.push_back("core");
  fmt::print("{:<8} {:<12} {:>7} {:>7} {:>8} {:>12} {:>9} {:>10} {:>7}\n", "FPGA", "stage", "LUTs", "FFs", "carries",
             "multipliers", "memories", "placed ns", "equal");
  for (const CellLibrary library : {CellLibrary::kIce40, CellLibrary::kEcp5, CellLibrary::kXilinx}) {
    for (const std::string& name : names) {
      const auto [module, values] = stage_module(name, config);
      SynthesisOptions options;
      SynthesisResult result = synthesise(module, values, library, options, progress);
      const FpgaCells cells = count_fpga_cells(result);
      std::string placed = "-";
      if (place && library == CellLibrary::kIce40 && cells.luts > 0 && may_fit(cells)) {
        options.place_and_route = true;
        try {
          result = synthesise(module, values, library, options, progress);
          placed = fmt::format("{:.1f}", result.critical_path_ns);
        } catch (const SynthesisError&) {
          placed = "too large";
        }
      }
      fmt::print("{:<8} {:<12} {:>7} {:>7} {:>8} {:>12} {:>9} {:>10} {:>7}\n", cell_library_name(library), name,
                 cells.luts, cells.flip_flops, cells.carries, cells.multipliers, cells.memories, placed,
                 result.checked.clocks);
      rows.push_back({{"library", cell_library_name(library)},
                      {"stage", name},
                      {"luts", cells.luts},
                      {"flip_flops", cells.flip_flops},
                      {"carries", cells.carries},
                      {"multipliers", cells.multipliers},
                      {"memories", cells.memories},
                      {"placed_ns", result.critical_path_ns},
                      {"checked", to_json(result.checked)}});
    }
  }
  return rows;
}

}  // namespace wrinkle

#include "sim/report/all_areas.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "sim/config_file.h"
#include "sim/report/collect.h"
#include "sim/report/fpga.h"
#include "sim/report/modules.h"

namespace wrinkle {
namespace {

// "118,257"
std::string grouped(double number) {
  std::string text = fmt::format("{:.0f}", number);
  for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, ",");
  return text;
}

// The rows so far. Each is printed as soon as it is known, for some take minutes.
class Table {
 public:
  Table() { fmt::print("| | netlist | | clocks equal |\n| --- | --- | --- | --- |\n"); }

  void add(const std::string& name, const std::string& netlist, const char* unit, double size, int clocks) {
    fmt::print("| {} | {} | {} {} | {} |\n", name, netlist, grouped(size), unit, grouped(clocks));
    std::fflush(stdout);
    rows_.push_back(
        {{"name", name}, {"netlist", netlist}, {unit == kLuts ? "luts" : "nand2", size}, {"clocks", clocks}});
  }
  void add(const std::string& name, const AreaReport& report) {
    add(name, "by stage, " + report.library, kNand2, report.sum_nand2(), report.clocks_equal());
    if (!report.flat.cells.empty())
      add(name, "flat, " + report.library, kNand2, report.flat.nand2, report.flat.checked.clocks);
  }

  static constexpr const char *kNand2 = "NAND2", *kLuts = "LUTs";
  nlohmann::json rows() const { return rows_; }

 private:
  nlohmann::json rows_ = nlohmann::json::array();
};

void add_fpgas(Table& table, const std::string& name, const Config& config, const SynthesisProgress& progress) {
  for (const CellLibrary library : kFpgas) {
    double luts = 0;
    int clocks = 0;
    for (const std::string& stage : stage_names()) {
      const FpgaStage found = measure_fpga(config, stage, library, false, progress);
      luts += found.cells.luts;
      clocks = clocks == 0 ? found.result.checked.clocks : std::min(clocks, found.result.checked.clocks);
    }
    table.add(name, "by stage, " + cell_library_name(library), Table::kLuts, luts, clocks);
  }
}

}  // namespace

nlohmann::json measure_all(const AreaOptions& options, bool fpga) {
  Table table;
  for (const std::string& name : named_configs()) table.add(name, measure_area(name, load_config(name), options));
  const Figures figures = named_figures(options);
  for (const auto& [name, report] :
       {std::pair{"Fig. 1", &figures.fig1}, {"Fig. 2", &figures.fig2}, {"Fig. 3", &figures.fig3}})
    table.add(name, *report);
  for (const NormalizerArea& area : measure_normalizers(kNormalizerWidths, options))
    table.add(fmt::format("normalizer `{}`, F = {}", normalizer_name(area.kind), area.unit_bits),
              "logic, " + cell_library_name(options.library), Table::kNand2, area.result.nand2,
              area.result.checked.clocks);
  if (fpga) {
    for (const std::string& name : named_configs()) add_fpgas(table, name, load_config(name), options.progress);
  }
  return table.rows();
}

}  // namespace wrinkle

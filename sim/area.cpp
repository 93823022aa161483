// area: synthesis by stage and flat, in standard cells and for FPGAs; Fig. 1, 2 and 3 side by side.
#include "sim/report/area.h"

#include <fmt/format.h>
#include <unistd.h>

#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "sim/command.h"
#include "sim/config_file.h"
#include "sim/input_error.h"
#include "sim/report/all_areas.h"
#include "sim/report/baseline.h"
#include "sim/report/collect.h"
#include "sim/report/fpga.h"
#include "sim/report/modules.h"

namespace wrinkle {
namespace {

struct Options {
  std::string name = "standard", library = "osu035", effort = "area";
  std::vector<std::string> set, stages;
  bool figures = false, normalizers = false, all = false, fpga = false, place = false, no_flat = false, quick = false,
       check = false, keep = false, plain_adders = false, shading = false;
  int faults = 0;
  std::filesystem::path json;
};

void say(const std::string& message) { fmt::print(stderr, "{}\n", message); }

AreaOptions area_options(const Options& options) {
  AreaOptions area;
  area.library = options.library == "osu018" ? CellLibrary::kOsu018 : CellLibrary::kOsu035;
  area.flat = !options.no_flat;
  area.stages = options.stages;
  area.synthesis.effort = options.effort;
  area.synthesis.full_adders = !options.plain_adders;
  area.synthesis.faults = options.faults;
  if (isatty(STDERR_FILENO)) area.progress = say;
  return area;
}

constexpr const char* kRow = "{:<22} {:>12.0f} {:>10.1f} {:>8} {:>9.2f} {:>7}  {}\n";

void print_report(const AreaReport& report) {
  fmt::print("{} in {}\n{:<22} {:>12} {:>10} {:>8} {:>9} {:>7}  multipliers\n", report.name, report.library, "stage",
             "um^2", "NAND2", "FFs", "path ns", "equal");
  for (const StageArea& stage : report.stages) {
    const SynthesisResult& r = stage.result;
    fmt::print(kRow, stage.stage + (stage.given ? " (given)" : ""), r.um2, r.nand2, r.flip_flops, r.critical_path_ns,
               r.checked.clocks, multiplier_text(r.multipliers));
  }
  const nlohmann::json whole = to_json(report);
  fmt::print(kRow, "sum", report.sum_um2(), report.sum_nand2(), report.flip_flops(),
             whole["critical_path_ns"].get<double>(), report.clocks_equal(), "");
  if (!report.flat.cells.empty())
    fmt::print(kRow, "flat", report.flat.um2, report.flat.nand2, report.flat.flip_flops, report.flat.critical_path_ns,
               report.flat.checked.clocks, fmt::format("sum of stages {:+.2f} %", 100 * report.deviation()));
}

void add_by_name(FiguresByName& figures, const std::string& name, const SynthesisResult& result) {
  figures[name + ".nand2"] = result.nand2;
  figures[name + ".critical_path_ns"] = result.critical_path_ns;
}

// Against one file of tests/baselines, or into it.
bool check_or_keep(const Options& options, const std::string& file, const FiguresByName& figures) {
  if (options.keep) write_baseline(baseline_path(file), figures);
  return !options.check || check_baseline(baseline_path(file), figures);
}

// The stages but texture have a baseline of their own: they take a fraction of the time of texture and flat netlists.
bool check_or_keep(const Options& options, const Figures& figures) {
  FiguresByName quick, slow;
  for (const AreaReport* report : {&figures.fig1, &figures.fig2, &figures.fig3}) {
    for (const StageArea& stage : report->stages) {
      if (stage.stage == "texture coordinates") continue;  // of packet and interpolate
      add_by_name(stage.stage == "texture" ? slow : quick, report->name + "." + stage.stage, stage.result);
    }
    add_by_name(slow, report->name, report->flat);
  }
  const bool good = check_or_keep(options, "area", quick);
  return (options.quick || check_or_keep(options, "area_slow", slow)) && good;
}

AreaOptions figure_options(const Options& options) {
  AreaOptions area = area_options(options);
  if (options.quick) {
    area.flat = false;
    area.stages = stage_names();
    std::erase(area.stages, "texture");
  }
  return area;
}

int run_figures(const Options& options) {
  const Figures figures = named_figures(figure_options(options));
  for (const AreaReport* report : {&figures.fig1, &figures.fig2, &figures.fig3}) print_report(*report);
  nlohmann::json json = to_json(figures);
  fmt::print("(fig3 - fig1) / fig1 = {:.3f} %   (fig2 - fig1) / fig1 = {:.1f} %\n",
             100 * json["fig3_over_fig1"].get<double>(), 100 * json["fig2_over_fig1"].get<double>());
  write_json(options.json, json);
  return check_or_keep(options, figures) ? kExitEqual : kExitDifferent;
}

// The most that a normalizer of less than 1 ulp is meant to take, in NAND2 of osu035, by F.
const std::map<int, int> kNormalizerGoals{{8, 3430}, {10, 4990}, {12, 6340}, {16, 10610}};

int run_normalizers(const Options& options) {
  const std::vector<NormalizerArea> areas = measure_normalizers(kNormalizerWidths, area_options(options));
  nlohmann::json json{{"library", options.library}, {"normalizers", nlohmann::json::array()}};
  fmt::print("logic of one normalizer in {}, without registers, V = F\n{:<10} {:>3} {:>10} {:>12} {:>9} {:>7}  {}\n",
             options.library, "kind", "F", "NAND2", "um^2", "path ns", "equal", "goal");
  for (const NormalizerArea& area : areas) {
    const auto goal = kNormalizerGoals.find(area.unit_bits);
    fmt::print("{:<10} {:>3} {:>10.1f} {:>12.0f} {:>9.2f} {:>7}  {}\n", normalizer_name(area.kind), area.unit_bits,
               area.result.nand2, area.result.um2, area.result.critical_path_ns, area.result.checked.clocks,
               goal == kNormalizerGoals.end() || area.kind == Normalizer::kLite ? "" : std::to_string(goal->second));
    json["normalizers"].push_back(to_json(area));
  }
  write_json(options.json, json);
  return kExitEqual;
}

// Of faults put into each netlist, those that the words of its check find and those that are proved to change nothing.
void print_faults(const AreaReport& report) {
  fmt::print("{:<22} {:>8} {:>8} {:>10} {:>22} {:>22}\n", "stage", "faults", "found", "redundant",
             "registers that changed", "outputs that changed");
  for (const StageArea& stage : report.stages) {
    const NetlistChecked& c = stage.result.checked;
    fmt::print("{:<22} {:>8} {:>8} {:>10} {:>22} {:>22}\n", stage.stage, c.faults, c.faults_found, c.faults_redundant,
               fmt::format("{} of {}", c.registers_changed, c.registers),
               fmt::format("{} of {}", c.outputs_changed, c.outputs));
    for (const std::string& missed : c.faults_missed) fmt::print("  missed: {}\n", missed);
  }
}

int measure(const Options& options) {
  if (options.normalizers) return run_normalizers(options);
  if (options.all) {
    write_json(options.json, measure_all(area_options(options), options.fpga));
    return kExitEqual;
  }
  if (options.figures || options.quick || options.check || options.keep) return run_figures(options);
  const Config config = apply_overrides(load_config(options.name), options.set);
  if (options.shading) {
    const AreaReport report = measure_shading(options.name, config, area_options(options));
    print_report(report);
    write_json(options.json, {{"shading", to_json(report)}});
    return kExitEqual;
  }
  const AreaReport report = measure_area(options.name, config, area_options(options));
  print_report(report);
  if (options.faults > 0) print_faults(report);
  nlohmann::json json = to_json(report);
  if (options.fpga) json["fpga"] = measure_fpga(config, options.stages, options.place, area_options(options).progress);
  write_json(options.json, json);
  return kExitEqual;
}

// A netlist that is not its Verilog has no figure.
int area(const Options& options) {
  try {
    return measure(options);
  } catch (const NetlistDiffers& difference) {
    fmt::print(stderr, "{}\n", difference.what());
    return kExitDifferent;
  }
}

}  // namespace

void add_area(CLI::App& app, Action& run) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("area", "Synthesise every stage alone and the whole flat: area, timing, FPGA cells");
  command->add_option("config", options->name, "Configuration, by name or .toml file")->capture_default_str();
  command->add_option("--set", options->set, "Change a parameter of the configuration: KEY=VALUE")
      ->allow_extra_args(false);
  command->add_option("--library", options->library, "Standard cells")
      ->capture_default_str()
      ->check(CLI::IsMember({"osu035", "osu018"}));
  command->add_option("--effort", options->effort, "What mapping aims at")
      ->capture_default_str()
      ->check(CLI::IsMember({"area", "speed", "unbuffered"}));
  command->add_option("--stage", options->stages, "Only this stage")->check(CLI::IsMember(stage_names()));
  command->add_flag("--no-flat", options->no_flat, "Leave out the flat whole");
  command->add_flag("--plain-adders", options->plain_adders, "Adders in simple gates, not in full adder cells");
  command->add_flag("--fpga", options->fpga, "Also cells of iCE40, ECP5 and Xilinx");
  command->add_flag("--place", options->place, "With --fpga: place and route on iCE40 UP5K what fits");
  command->add_option("--faults", options->faults,
                      "Put so many single faults into each netlist and say how many its check finds");
  command->add_flag("--shading", options->shading,
                    "Only what shades: interpolators of N, L, H to dot products and power");
  command->add_flag("--figures", options->figures, "Fig. 1, Fig. 2 and Fig. 3 of the paper");
  command->add_flag("--normalizers", options->normalizers, "Every kind of normalizer at several widths, logic alone")
      ->excludes("--figures");
  command->add_flag("--all", options->all, "Every named configuration, the figures and the normalizers, in one table")
      ->excludes("--figures")
      ->excludes("--normalizers");
  command->add_flag("--check", options->check,
                    "The figures against tests/baselines/area.json and area_slow.json; exit 1 when worse");
  command->add_flag("--keep", options->keep, "Write the figures to these files");
  command->add_flag("--quick", options->quick,
                    "The figures without texture units and flat netlists, and area.json alone");
  add_json_option(*command, options->json);
  command->callback([options, &run] { run = [options] { return area(*options); }; });
}

}  // namespace wrinkle

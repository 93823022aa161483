#include "sim/synthesis/synthesis.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

#include "sim/synthesis/check.h"
#include "sim/synthesis/elaborate.h"
#include "sim/synthesis/pins.h"
#include "sim/synthesis/result.h"
#include "tb/fingerprint.h"
#include "tb/process.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

// Another number makes every kept result be checked anew.
constexpr int kCheckVersion = 12;

// One run: what to make, from what, where.
struct Job {
  std::string top;
  VerilogParameters parameters;
  CellLibrary library;
  SynthesisOptions options;
  std::vector<fs::path> sources;  // of the Verilog
  std::vector<fs::path> mapped;   // what is synthesised: the same with its maps
  fs::path folder;

  bool is_standard_cells() const { return library == CellLibrary::kOsu035 || library == CellLibrary::kOsu018; }
  bool is_placed() const { return library == CellLibrary::kIce40 && options.place_and_route; }
  std::string main_script() const { return is_standard_cells() ? "cells.ys" : cell_library_name(library) + ".ys"; }
};

// Where no registers are wanted. Ports of one bit each, for OpenSTA reads no assignment to a concatenation, which is
// what becomes of outputs that share a gate.
constexpr const char* kRegistersToWires = R"(opt_dff -nosdff
techmap -map @FOLDER@/wires.v
splitnets -ports -format __
opt
wreduce
opt_clean
)";
constexpr const char* kWires = R"((* techmap_celltype = "$dff $dffe" *)
module wires #(parameter WIDTH = 1, parameter CLK_POLARITY = 1, parameter EN_POLARITY = 1) (
  input CLK, input EN, input [WIDTH-1:0] D, output [WIDTH-1:0] Q);
  assign Q = D;
endmodule
)";

fs::path scripts() { return fs::path(WRINKLE_SOURCE_DIR) / "sim" / "synthesis" / "scripts"; }

std::string script_text(const fs::path& name) {
  const std::string text = read_text(scripts() / name);
  if (text.empty()) throw SynthesisError((scripts() / name).string() + ": script not found");
  return text;
}

template <typename Folders>
std::vector<fs::path> files_in(const Folders& folders, const std::string& extension) {
  std::vector<fs::path> files;
  for (const fs::path& folder : folders) {
    if (!fs::is_directory(folder)) continue;
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() == extension) files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::set<fs::path> folders_of(const std::vector<fs::path>& files) {
  std::set<fs::path> folders;
  for (const fs::path& file : files) folders.insert(file.parent_path());
  return folders;
}

// Maps are read beside every source, and include headers of rtl/unit.
std::vector<fs::path> include_folders(const std::vector<fs::path>& sources) {
  std::set<fs::path> folders = folders_of(sources);
  folders.insert(fs::path(WRINKLE_SOURCE_DIR) / "rtl" / "unit");
  return {folders.begin(), folders.end()};
}

// Modules that are synthesised in the place of those of the same names in rtl/, with the same ports, parameters and
// values, but with an arrangement of their own. The check of the netlist reads those of rtl/.
fs::path maps() { return fs::path(WRINKLE_SOURCE_DIR) / "sim" / "synthesis" / "maps"; }

// The sources with every module that has a map replaced by it; a map that replaces nothing may be part of another.
std::vector<fs::path> mapped_sources(const std::vector<fs::path>& sources) {
  std::vector<fs::path> mapped = files_in(std::set<fs::path>{maps()}, ".v");
  for (const fs::path& source : sources) {
    if (!fs::exists(maps() / source.filename())) mapped.push_back(source);
  }
  return mapped;
}

std::string replace_all(std::string text, const std::string& from, const std::string& to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

// Verilog of what an FPGA's cells do: Yosys's own, and what it has only the ports of.
std::string simulation_models(CellLibrary library) {
  const std::string name = cell_library_name(library);
  const fs::path more = scripts() / (name + "_models.v");
  return fmt::format("+/{}/cells_sim.v{}", name, fs::exists(more) ? " " + more.string() : "");
}

std::string techmap(const char* map) { return fmt::format("techmap -map {}\n", (scripts() / map).string()); }

// Rounds enough that no full adder of a stage keeps a constant pin.
std::string without_constant_pins() {
  std::string text;
  for (int round = 0; round < 8; ++round)
    text += techmap("full_adder_constant.v") + "techmap t:$xor t:$and t:$or %u %u\nopt_expr\nopt_merge\nopt_clean\n";
  return text + "opt -full\n";
}

// What the @...@ of a script stand for.
std::string filled_in(const Job& job, const std::string& script) {
  std::string sources, includes, parameters;
  for (const fs::path& source : job.mapped) sources += " " + source.string();
  for (const fs::path& folder : include_folders(job.sources)) includes += " -I" + folder.string();
  for (const auto& [name, value] : job.parameters) parameters += fmt::format(" -chparam {} {}", name, value.text);
  const std::string map_registers =
      job.options.registers ? "" : replace_all(kRegistersToWires, "@FOLDER@", job.folder.string());
  const std::string map_products =
      map_registers + (job.options.full_adders ? techmap("square.v") + techmap("signed_multiply.v") + "opt\n" : "");
  const fs::path adders = job.options.adders.empty() ? "full_adders.ys" : job.options.adders;
  std::string text = script_text(script);
  text = replace_all(text, "@MAP_ADDERS@", job.options.full_adders ? script_text(adders) : "techmap");
  text = replace_all(text, "@CONSTANT_PINS@", without_constant_pins());
  text = replace_all(text, "@SOURCES@", sources);
  text = replace_all(text, "@INCLUDES@", includes);
  text = replace_all(text, "@TOP@", job.top);
  text = replace_all(text, "@PARAMETERS@", parameters);
  text = replace_all(text, "@FOLDER@", job.folder);
  text = replace_all(text, "@SCRIPTS@", scripts());
  text = replace_all(text, "@MODELS@", simulation_models(job.library));
  text = replace_all(text, "@EFFORT@", job.options.effort);
  text = replace_all(text, "@MAP_PRODUCTS@", map_products);
  if (job.is_standard_cells()) text = replace_all(text, "@LIBERTY@", liberty_path(job.library));
  return text;
}

std::string tail(const std::string& text) { return text.size() <= 4000 ? text : text.substr(text.size() - 4000); }

// Runs a tool; its output.
std::string run(const Arguments& command, const fs::path& log) {
  const int code = Process(command, log).wait();
  const std::string output = read_text(log);
  if (code != 0) throw SynthesisError(fmt::format("{} ended with code {}:\n{}", command[0], code, tail(output)));
  return output;
}

// Runs a script of ours with its blanks filled in; the tool's output.
std::string run_script(const Job& job, const Arguments& tool, const std::string& script) {
  const fs::path path = job.folder / script;
  std::ofstream(path) << filled_in(job, script);
  Arguments command = tool;
  command.push_back(path);
  return run(command, job.folder / (script + ".log"));
}

SynthesisResult cell_counts(const Job& job) {
  if (job.is_standard_cells())
    std::ofstream(job.folder / "gates.lib") << without_pads(read_text(liberty_path(job.library)));
  if (!job.options.registers) std::ofstream(job.folder / "wires.v") << kWires;
  run_script(job, {"yosys", "-Q", "-s"}, job.main_script());
  SynthesisResult result;
  result.cells = read_cells(job.folder / "stat.json");
  result.multipliers = read_multipliers(job.folder / "multipliers.il");
  result.flip_flops = count_flip_flops(result.cells);
  if (!job.options.registers && result.flip_flops > 0)
    throw SynthesisError(fmt::format("{} registers of {} did not become wires", result.flip_flops, job.top));
  return result;
}

void add_area(SynthesisResult& result, const fs::path& lef) {
  const auto areas = lef_areas(lef);
  for (const auto& [type, number] : result.cells) {
    const auto area = areas.find(type);
    if (area == areas.end()) throw SynthesisError(fmt::format("cell {} is not in {}", type, lef.string()));
    result.um2 += area->second * number;
  }
  result.nand2 = result.um2 / areas.at("NAND2X1");
}

// Critical path in ns of the design between shift registers, as nextpnr's report gives it.
double placed_path(const Job& job) {
  std::ofstream(job.folder / "pins.v") << pin_wrapper(job.top, job.folder / "netlist.json");
  run_script(job, {"yosys", "-Q", "-s"}, "ice40_pins.ys");
  const fs::path report = job.folder / "report.json";
  run({"nextpnr-ice40", "--up5k", "--package", "sg48", "--pcf-allow-unconstrained", "--seed", "1", "--json",
       job.folder / "pins.json", "--report", report},
      job.folder / "nextpnr.log");
  const auto clocks = nlohmann::json::parse(read_text(report)).at("fmax");
  if (clocks.size() != 1) throw SynthesisError(fmt::format("{} clocks in {}, not one", clocks.size(), report.string()));
  return 1000.0 / clocks.front().at("achieved").get<double>();
}

NetlistChecked checked(const Job& job, const fs::path& gates) {
  return check_netlist({job.top, job.parameters, job.sources, include_folders(job.sources), gates, job.folder,
                        job.options.registers, job.is_standard_cells(), job.options.faults});
}

std::string provenance(const Job& job) {
  static const std::string yosys = first_line({"yosys", "-V"});
  std::string text = fmt::format("{}, {}, ", yosys, cell_library_name(job.library));
  if (job.is_standard_cells()) {
    static const std::string sta = first_line({"sta", "-version"});
    text += fmt::format("{} adders, effort {}, OpenSTA {}", job.options.full_adders ? "mapped full" : "plain",
                        job.options.effort, sta);
  } else if (job.is_placed()) {
    text += "placed and routed on UP5K, " + first_line({"nextpnr-ice40", "--version"});
  }
  return text;
}

// A netlist that is not checked yet, and its gates as gates.blif in the folder of the job.
SynthesisResult make(const Job& job) {
  SynthesisResult result = cell_counts(job);
  result.provenance = provenance(job);
  run_script(job, {"yosys", "-Q", "-s"}, job.is_standard_cells() ? "cells_gates.ys" : "fpga_gates.ys");
  if (job.is_standard_cells()) {
    add_area(result, lef_path(job.library));
    // A module of wires alone comes out a hair below 0.
    const std::string timing = run_script(job, {"sta", "-no_splash", "-exit"}, "timing.tcl");
    result.critical_path_ns = std::max(0.0, number_after(timing, "critical_path_ns"));
  }
  if (job.is_placed()) result.critical_path_ns = placed_path(job);
  return result;
}

// Files and the headers beside them.
void add_files(Fingerprint& key, const std::vector<fs::path>& files) {
  for (const fs::path& file : files) key.add(read_text(file));
  for (const fs::path& header : files_in(folders_of(files), ".vh")) key.add(read_text(header));
}

// The scripts that a job can come to use: those of an FPGA bear its name or are for every FPGA, all others are for
// standard cells.
std::vector<fs::path> own_scripts(const Job& job) {
  std::vector<fs::path> found;
  for (const std::string extension : {".ys", ".v", ".abc", ".tcl"}) {
    for (const fs::path& script : files_in(std::set<fs::path>{scripts()}, extension)) {
      const std::string name = script.filename();
      const auto is_of = [&](CellLibrary library) { return name.starts_with(cell_library_name(library)); };
      const bool is_of_fpga = name.starts_with("fpga") || is_of(CellLibrary::kIce40) || is_of(CellLibrary::kEcp5) ||
                              is_of(CellLibrary::kXilinx);
      const bool is_own = is_of(job.library) || name.starts_with("fpga");
      if (job.is_standard_cells() ? !is_of_fpga : is_own) found.push_back(script);
    }
  }
  return found;
}

// Of what the netlist depends on.
std::string netlist_key(const Job& job) {
  Fingerprint key;
  key.add(job.top);
  for (const auto& [name, value] : job.parameters) key.add(fmt::format("{}={}", name, value.text));
  add_files(key, job.mapped);
  for (const fs::path& header : files_in(folders_of(job.sources), ".vh")) key.add(read_text(header));
  for (const fs::path& script : own_scripts(job)) key.add(read_text(script));
  if (job.is_standard_cells()) {
    key.add(read_text(liberty_path(job.library)));
    key.add(read_text(lef_path(job.library)));
  }
  key.add(fmt::format("{} {}", job.is_placed(), job.options.full_adders));
  key.add(job.options.effort);
  key.add(replace_all(without_constant_pins(), scripts().string(), ""));
  if (!job.options.adders.empty()) key.add(read_text(job.options.adders));
  if (!job.options.registers) key.add(std::string(kRegistersToWires) + kWires);
  key.add(provenance(job));
  return key.hex();
}

// Of what its check depends on too.
std::string job_key(const Job& job, const std::string& netlist) {
  Fingerprint key;
  key.add(netlist);
  add_files(key, job.sources);
  key.add(fmt::format("{} {}", job.options.faults, kCheckVersion));
  return key.hex();
}

fs::path cache_folder(const SynthesisOptions& options) {
  if (!options.cache.empty()) return fs::absolute(options.cache);
  const char* chosen = std::getenv("WRINKLE_CACHE");
  return chosen != nullptr && *chosen != '\0' ? fs::absolute(chosen) / "synthesis" : fs::path(WRINKLE_SYNTHESIS_DIR);
}

fs::path library_file(CellLibrary library, const char* extension) {
  const std::string name = cell_library_name(library);
  return fs::path("/usr/share/qflow/tech") / name / (name + "_stdcells" + extension);
}

// Removes a folder with all that is in it when it goes.
struct TemporaryFolder {
  fs::path path;
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
};

void keep(const SynthesisResult& result, const fs::path& path) {
  const fs::path partial = path.string() + ".partial";
  std::ofstream(partial) << to_json(result).dump(1) << '\n';
  fs::rename(partial, path);
}

// What is known of a netlist whose gates are KEY.blif.
fs::path unchecked(const fs::path& cache, const std::string& key) { return cache / (key + ".unchecked"); }

// What make() made before, or makes now.
SynthesisResult kept_netlist(const Job& job, const fs::path& cache, const std::string& key) {
  const fs::path kept = unchecked(cache, key);
  if (fs::exists(kept)) return synthesis_result(nlohmann::json::parse(read_text(kept)));
  const SynthesisResult result = make(job);
  fs::rename(job.folder / "gates.blif", cache / (key + ".blif"));
  keep(result, kept);
  return result;
}

}  // namespace

std::string cell_library_name(CellLibrary library) {
  static constexpr const char* kNames[] = {"osu035", "osu018", "ice40", "ecp5", "xilinx"};
  return kNames[static_cast<std::size_t>(library)];
}

fs::path liberty_path(CellLibrary library) { return library_file(library, ".lib"); }
fs::path lef_path(CellLibrary library) { return library_file(library, ".lef"); }

SynthesisResult synthesise(const std::string& top, const VerilogParameters& parameters, CellLibrary library,
                           const SynthesisOptions& options, const SynthesisProgress& progress) {
  Job job{top, parameters, library, options, options.sources, {}, {}};
  const fs::path rtl = fs::path(WRINKLE_SOURCE_DIR) / "rtl";
  if (job.sources.empty())
    job.sources = files_in(std::set<fs::path>{rtl, rtl / "stage", rtl / "perturb", rtl / "unit", rtl / "lib"}, ".v");
  for (fs::path& source : job.sources) source = fs::absolute(source);

  const fs::path cache = cache_folder(options);
  fs::create_directories(cache);
  const std::vector<fs::path> folders = include_folders(job.sources);
  job.mapped = elaborated_files(top, parameters, mapped_sources(job.sources), folders, cache);
  job.sources = elaborated_files(top, parameters, job.sources, folders, cache);
  const std::string netlist = netlist_key(job), key = job_key(job, netlist);
  const fs::path kept = cache / (key + ".json");
  if (fs::exists(kept)) return synthesis_result(nlohmann::json::parse(read_text(kept)));

  const FileLock lock(cache / (netlist + ".lock"));
  if (fs::exists(kept)) return synthesis_result(nlohmann::json::parse(read_text(kept)));
  const TemporaryFolder folder{cache / (netlist + ".work")};
  fs::remove_all(folder.path);
  fs::create_directories(folder.path);
  job.folder = folder.path;
  if (progress)
    progress(fmt::format("{} {} for {}", fs::exists(unchecked(cache, netlist)) ? "comparing" : "synthesising", top,
                         cell_library_name(library)));
  SynthesisResult result = kept_netlist(job, cache, netlist);
  result.checked = checked(job, cache / (netlist + ".blif"));
  keep(result, kept);
  return result;
}

}  // namespace wrinkle

#include "tb/build_model.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>

#include "golden/config/verilog.h"
#include "golden/pixel/pixel.h"
#include "golden/stages.h"
#include "tb/fingerprint.h"
#include "tb/process.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

struct Tools {
  std::string verilator_version = first_line({"verilator", "--version"});
  fs::path verilator_include = fs::path(first_line({"verilator", "--getenv", "VERILATOR_ROOT"})) / "include";
  std::string compiler_version = first_line({WRINKLE_CXX, "--version"});
};

const Tools& tools() {
  static const Tools found;
  return found;
}

// -march=native is not used: it gains nothing on integer code of this kind and would tie the cache to one machine.
Arguments compiler_flags(const ModelOptions& options) {
  Arguments flags{
      "-std=c++20", "-fPIC",   "-fvisibility=hidden", "-fno-gnu-unique", "-faligned-new", "-fcf-protection=none",
      "-w",         "-pthread"};
  flags.push_back(options.optimize ? "-O3" : "-O0");
  if (options.trace) flags.push_back("-DWRINKLE_TRACE");
  return flags;
}

// -fno-const-bit-op-tree: Verilator 5.006 computes wrong values without it.
Arguments verilator_flags(const Config& config, const ModelOptions& options) {
  Arguments flags{
      "--cc",        "--top-module", "wrinkle_core", "-O3",        "-fno-const-bit-op-tree", "--x-assign", "unique",
      "--x-initial", "unique",       "-Wno-lint",    "-Wno-style", "--default-language",     "1364-2005"};
  if (options.trace) flags.push_back("--trace-fst");
  for (const Parameter& parameter : parameters()) {
    if (parameter.scope != Scope::core) continue;
    flags.push_back(fmt::format("-G{}={}", verilog_text(parameter.name), config.*parameter.member));
  }
  return flags;
}

std::vector<fs::path> verilog_folders(const fs::path& root) {
  const fs::path rtl = root / "rtl";
  return {rtl, rtl / "stage", rtl / "perturb", rtl / "unit", rtl / "lib"};
}

std::vector<fs::path> verilog_sources(const fs::path& root) {
  std::vector<fs::path> sources;
  for (const fs::path& folder : verilog_folders(root)) {
    if (!fs::is_directory(folder)) continue;
    for (const auto& entry : fs::directory_iterator(folder)) {
      const fs::path extension = entry.path().extension();
      if (extension == ".v" || extension == ".vh") sources.push_back(entry.path());
    }
  }
  std::sort(sources.begin(), sources.end());
  if (sources.empty()) throw ModelBuildError((root / "rtl").string() + ": no Verilog sources");
  return sources;
}

fs::path glue_source() { return fs::path(WRINKLE_SOURCE_DIR) / "tb" / "glue" / "glue.cpp"; }

std::string model_key(const Config& config, const ModelOptions& options, const fs::path& root) {
  Fingerprint key;
  for (const fs::path& source : verilog_sources(root)) {
    key.add(fs::relative(source, root).string());
    key.add(read_text(source));
  }
  for (const char* file :
       {"tb/glue/glue.cpp", "tb/model.h", "tb/pins.h", "golden/streams.def", "golden/texel/texture.h"}) {
    key.add(read_text(fs::path(WRINKLE_SOURCE_DIR) / file));
  }
  for (const std::string& wire : visible_wires(config)) key.add(wire);
  for (const std::string& flag : verilator_flags(config, options)) key.add(flag);
  for (const std::string& flag : compiler_flags(options)) key.add(flag);
  key.add(tools().verilator_version);
  key.add(tools().compiler_version);
  return key.hex();
}

void check(int code, const std::string& what, const fs::path& log) {
  if (code != 0) throw ModelBuildError(fmt::format("{} failed with code {}:\n{}", what, code, read_text(log)));
}

// Makes the wires between the stages visible: to Verilator by one file, to the glue by another. Names that the netlist
// lacks do no harm.
void write_visible_wires(const Config& config, const fs::path& folder) {
  std::ofstream verilator(folder / "wires.vlt"), glue(folder / "wires.def");
  verilator << "`verilator_config\n";
  for (const std::string& wire : visible_wires(config)) {
    verilator << fmt::format("public_flat_rd -module \"wrinkle_core\" -var \"{}\"\n", wire);
    glue << fmt::format("WRINKLE_WIRE({})\n", wire);
  }
}

Arguments compile_command(const ModelOptions& options) {
  Arguments command;
  if (*WRINKLE_CCACHE != '\0') command.push_back(WRINKLE_CCACHE);
  command.push_back(WRINKLE_CXX);
  for (const std::string& flag : compiler_flags(options)) command.push_back(flag);
  command.push_back("-I" + tools().verilator_include.string());
  command.push_back("-I" + (tools().verilator_include / "vltstd").string());
  command.push_back("-I" + std::string(WRINKLE_SOURCE_DIR));
  return command;
}

Arguments operator+(Arguments a, const Arguments& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// Verilator's own run-time library, compiled once for each way of compiling models; always in the default cache, since
// it is the same for every model.
fs::path runtime_library(const ModelOptions& options, const fs::path& cache, const BuildProgress& progress) {
  ModelOptions runtime = options;
  runtime.optimize = true;
  Fingerprint key;
  key.add(tools().verilator_version);
  key.add(tools().compiler_version);
  for (const std::string& flag : compiler_flags(runtime)) key.add(flag);
  const fs::path library = cache / ("runtime-" + key.hex() + ".o");
  if (fs::exists(library)) return library;

  const FileLock lock(cache / ("runtime-" + key.hex() + ".lock"));
  if (fs::exists(library)) return library;
  if (progress) progress("compiling Verilator's run-time library");
  const fs::path unity = cache / ("runtime-" + key.hex() + ".cpp");
  std::ofstream(unity)
      << "#include \"verilated.cpp\"\n#include \"verilated_dpi.cpp\"\n#include \"verilated_threads.cpp\"\n"
      << (options.trace ? "#include \"verilated_fst_c.cpp\"\n" : "");
  const fs::path partial = cache / ("runtime-" + key.hex() + ".partial");
  const fs::path log = cache / ("runtime-" + key.hex() + ".log");
  const int code = Process(compile_command(runtime) + Arguments{"-c", unity, "-o", partial}, log).wait();
  check(code, "compiling Verilator's run-time library", log);
  fs::remove(log);
  fs::remove(unity);
  fs::rename(partial, library);
  return library;
}

// Two source files that include all generated ones: what runs every clock, and the rest.
void write_unities(const fs::path& generated, const fs::path& fast, const fs::path& slow) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(generated)) {
    if (entry.path().extension() == ".cpp") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::ofstream fast_out(fast), slow_out(slow);
  for (const fs::path& file : files) {
    const std::string name = file.filename();
    const bool is_slow = name.find("Slow") != std::string::npos || name.find("Trace") != std::string::npos ||
                         name.find("Syms") != std::string::npos || name.find("Dpi") != std::string::npos;
    (is_slow ? slow_out : fast_out) << "#include \"" << name << "\"\n";
  }
  fast_out << "#include \"" << glue_source().string() << "\"\n";
}

void build(const Config& config, const ModelOptions& options, const fs::path& root, const fs::path& folder,
           const fs::path& runtime, const fs::path& library) {
  const fs::path wires = folder / "wires.vlt", log = folder / "log", fast = folder / "fast.cpp",
                 slow = folder / "slow.cpp";
  write_visible_wires(config, folder);
  Arguments verilate = Arguments{"verilator"} + verilator_flags(config, options) + Arguments{"--Mdir", folder, wires};
  for (const fs::path& include : verilog_folders(root)) verilate.push_back("-I" + include.string());
  for (const fs::path& source : verilog_sources(root)) {
    if (source.extension() == ".v") verilate.push_back(source);
  }
  check(Process(verilate, log).wait(), "verilator", log);

  write_unities(folder, fast, slow);
  const Arguments compile = compile_command(options) + Arguments{"-I" + folder.string()};
  const fs::path slow_log = folder / "slow.log";
  {
    Process fast_process(compile + Arguments{"-c", fast, "-o", folder / "fast.o"}, log);
    Process slow_process(compile + Arguments{options.optimize ? "-O1" : "-O0", "-c", slow, "-o", folder / "slow.o"},
                         slow_log);
    const int fast_code = fast_process.wait(), slow_code = slow_process.wait();
    check(fast_code, "compiling the model", log);
    check(slow_code, "compiling the model", slow_log);
  }
  Arguments link{WRINKLE_CXX, "-shared", "-pthread", folder / "fast.o", folder / "slow.o", runtime, "-o", library};
  if (options.trace) link.push_back("-lz");
  check(Process(link, log).wait(), "linking the model", log);
}

fs::path cache_directory(const ModelOptions& options) {
  if (!options.cache.empty()) return fs::absolute(options.cache);
  const char* chosen = std::getenv("WRINKLE_CACHE");
  return chosen != nullptr && *chosen != '\0' ? fs::absolute(chosen) : fs::path(WRINKLE_MODEL_DIR);
}

}  // namespace

std::vector<std::string> visible_wires(const Config& config) {
  std::vector<std::string> wires;
  for (const std::string_view stage : kStageNames) {
    wires.push_back(fmt::format("{}_valid", stage));
    wires.push_back(fmt::format("{}_ready", stage));
  }
  for (const Value& value : values(config)) {
    if (std::find(wires.begin(), wires.end(), value.wire) == wires.end()) wires.emplace_back(value.wire);
  }
  return wires;
}

fs::path build_model(const Config& config, const ModelOptions& options, const BuildProgress& progress) {
  const fs::path root = options.source_root.empty() ? fs::path(WRINKLE_SOURCE_DIR) : fs::absolute(options.source_root);
  const fs::path cache = cache_directory(options);
  fs::create_directories(cache);
  const std::string key = model_key(config, options, root);
  const fs::path library = cache / (key + ".so");
  if (fs::exists(library)) return library;

  const fs::path shared = cache_directory({});
  fs::create_directories(shared);
  const fs::path runtime = runtime_library(options, shared, progress);
  const FileLock lock(cache / (key + ".lock"));
  if (fs::exists(library)) return library;
  if (progress) progress("building the Verilated model " + key.substr(0, 8));
  const auto start = std::chrono::steady_clock::now();
  // Under the lock the folder is ours alone; one left by an interrupted build is swept away here.
  const fs::path folder = cache / (key + ".build");
  fs::remove_all(folder);
  fs::create_directories(folder);
  build(config, options, root, folder, runtime, folder / "model.so");
  fs::rename(folder / "model.so", library);
  fs::remove_all(folder);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if (progress) progress(fmt::format("model {} built in {:.1f} s", key.substr(0, 8), seconds.count()));
  return library;
}

}  // namespace wrinkle

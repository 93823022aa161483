#include "sim/report/modules.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "golden/config/verilog.h"
#include "golden/stages.h"
#include "tb/process.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

// Every module by name.
const std::map<std::string, fs::path>& all_modules() {
  static const std::map<std::string, fs::path> modules = [] {
    std::map<std::string, fs::path> found;
    const fs::path rtl = fs::path(WRINKLE_SOURCE_DIR) / "rtl";
    for (const fs::path& folder : {rtl, rtl / "stage", rtl / "perturb", rtl / "unit", rtl / "lib"}) {
      for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == ".v") found[entry.path().stem()] = entry.path();
      }
    }
    return found;
  }();
  return modules;
}

const fs::path& file_of(const std::string& module) {
  const auto found = all_modules().find(module);
  if (found == all_modules().end()) throw SynthesisError("no module " + module + " under rtl/");
  return found->second;
}

std::set<std::string> words_of(const std::string& text, const char* pattern) {
  const std::regex word(pattern);
  std::set<std::string> words;
  for (std::sregex_iterator i(text.begin(), text.end(), word), end; i != end; ++i) words.insert((*i)[1]);
  return words;
}

// The instances in the core, each other module a black box.
std::vector<StageModule> instances_of_core(const std::string& chparams) {
  const fs::path rtl = fs::path(WRINKLE_SOURCE_DIR) / "rtl";
  std::string boxes;
  for (const auto& [name, file] : all_modules()) {
    if (name != "wrinkle_core") boxes += " " + file.string();
  }
  const fs::path stem = fs::temp_directory_path() / fmt::format("wrinkle_core_{}", getpid());
  const fs::path json = stem.string() + ".json", log = stem.string() + ".log";
  const std::string script = fmt::format(
      "read_verilog -lib{}; read_verilog -defer -I{} {}; hierarchy -check -top wrinkle_core{}; proc; write_json {}",
      boxes, rtl.string(), file_of("wrinkle_core").string(), chparams, json.string());
  const int code = Process({"yosys", "-Q", "-p", script}, log).wait();
  if (code != 0) throw SynthesisError("elaborating wrinkle_core:\n" + read_text(log));
  const nlohmann::json core = nlohmann::json::parse(read_text(json)).at("modules").at("wrinkle_core").at("cells");
  fs::remove(json);
  fs::remove(log);
  std::vector<StageModule> instances;
  for (const auto& cell : core) {
    StageModule instance{cell.at("type"), {}};
    if (!all_modules().contains(instance.module)) continue;
    for (const auto& [name, bits] : cell.at("parameters").items()) {
      const std::string digits = bits;
      instance.parameters.emplace(name, fmt::format("{}'b{}", digits.size(), digits));
    }
    instances.push_back(std::move(instance));
  }
  return instances;
}

}  // namespace

std::vector<std::string> stage_names() { return {kStageNames.begin(), kStageNames.end()}; }

VerilogParameters core_parameters(const Config& config) {
  const std::string text =
      read_text(file_of("wrinkle_core")) + read_text(fs::path(WRINKLE_SOURCE_DIR) / "rtl" / "wrinkle_config.vh");
  const std::set<std::string> declared = words_of(text, R"(\bparameter\s+(\w+)\s*=)");
  VerilogParameters values;
  for (const Parameter& parameter : parameters()) {
    const std::string name = verilog_text(parameter.name);
    if (declared.contains(name)) values.emplace(name, config.*parameter.member);
  }
  return values;
}

StageModule stage_module(const std::string& stage, const Config& config) {
  static std::mutex mutex;
  static std::map<std::string, std::vector<StageModule>> elaborated;
  const VerilogParameters core = core_parameters(config);
  std::string key;
  for (const auto& [name, value] : core) key += fmt::format(" -chparam {} {}", name, value.text);
  const std::lock_guard lock(mutex);
  auto found = elaborated.find(key);
  if (found == elaborated.end()) found = elaborated.emplace(key, instances_of_core(key)).first;
  const std::string module = "wrinkle_" + stage;
  for (const StageModule& instance : found->second) {
    if (instance.module == module || instance.module.starts_with(module + "_")) return instance;
  }
  throw SynthesisError("no stage " + stage + " in wrinkle_core");
}

}  // namespace wrinkle

#include "sim/report/modules.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <regex>
#include <set>

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
    for (const fs::path& folder : {rtl, rtl / "lib"}) {
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

void collect(const std::string& module, std::set<std::string>& found) {
  if (!found.insert(module).second) return;
  for (const std::string& name : words_of(read_text(file_of(module)), R"(\b(wrinkle_\w+))")) {
    if (all_modules().contains(name)) collect(name, found);
  }
}

std::string upper(std::string_view name) {
  std::string text(name);
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::toupper(c)); });
  return text;
}

}  // namespace

std::vector<std::string> stage_names() { return {kStageNames.begin(), kStageNames.end()}; }

std::vector<fs::path> module_sources(const std::string& module) {
  std::set<std::string> names;
  collect(module, names);
  std::vector<fs::path> sources;
  for (const std::string& name : names) sources.push_back(file_of(name));
  return sources;
}

VerilogParameters module_parameters(const std::string& module, const Config& config) {
  const std::set<std::string> declared = words_of(read_text(file_of(module)), R"(\bparameter\s+(\w+)\s*=)");
  VerilogParameters values;
  for (const Parameter& parameter : parameters()) {
    const std::string name = upper(parameter.name);
    if (declared.contains(name)) values[name] = config.*parameter.member;
  }
  return values;
}

}  // namespace wrinkle

#include "sim/synthesis/elaborate.h"

#include <fmt/format.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "tb/fingerprint.h"
#include "tb/process.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

// What Yosys is told, but for the names of its own files.
std::string commands(const std::string& top, const VerilogParameters& parameters, const std::vector<fs::path>& files,
                     const std::vector<fs::path>& include_folders) {
  std::string text = "read_verilog -icells -defer";
  for (const fs::path& folder : include_folders) text += " -I" + folder.string();
  for (const fs::path& file : files) text += " " + file.string();
  text += "\nhierarchy -check -top " + top;
  for (const auto& [name, value] : parameters) text += fmt::format(" -chparam {} {}", name, value.text);
  return text + "\n";
}

// The files that the modules of a design come from.
std::set<fs::path> sources_in(const fs::path& design) {
  const auto modules = nlohmann::json::parse(read_text(design)).at("modules");
  std::set<fs::path> found;
  for (const auto& module : modules) {
    const std::string source = module.at("attributes").value("src", "");
    found.insert(source.substr(0, source.rfind(':')));
  }
  return found;
}

// Of Yosys's `dump`: the wires that output Q of a cell connects to, with their bits.
std::vector<Register> registers_in(const fs::path& dump) {
  std::map<std::string, std::size_t> bits;
  std::set<std::string> registers;
  std::istringstream in(read_text(dump));
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string word, wire;
    std::size_t width = 1;
    words >> word;
    if (word == "wire") {
      while (words >> word) {
        if (word == "width") words >> width;
        if (word[0] == '\\') wire = word;
      }
      bits[wire] = width;
    } else if (word == "connect" && words >> word && word == "\\Q") {
      while (words >> word) {
        if (word[0] == '\\') registers.insert(word);
      }
    }
  }
  // In a clocked block Yosys makes a register of each variable of a function, which nothing reads.
  std::erase_if(registers, [](const std::string& name) { return name.find("$func$") != std::string::npos; });
  std::vector<Register> found;
  // Every generate block has a name in the source; Yosys makes up others for the branches of an `else if`.
  static const std::regex made_up(R"(\bgenblk\d+\.)");
  for (const std::string& name : registers)
    found.push_back({name.substr(1), std::regex_replace(name.substr(1), made_up, ""), bits.at(name)});
  return found;
}

}  // namespace

std::vector<Register> elaborated_registers(const std::string& top, const VerilogParameters& parameters,
                                           const std::vector<fs::path>& files,
                                           const std::vector<fs::path>& include_folders, const fs::path& folder) {
  const fs::path script = folder / "registers.ys", log = folder / "registers.log", dump = folder / "registers.il";
  std::ofstream(script) << commands(top, parameters, files, include_folders) << "rename -top " << top
                        << "\nproc\nflatten\nmemory_map\ntee -q -o " << dump.string() << " dump t:$dff %x1:+[Q]\n";
  if (Process({"yosys", "-Q", "-s", script}, log).wait() != 0)
    throw SynthesisError("yosys cannot list the registers of " + top + ":\n" + read_text(log));
  return registers_in(dump);
}

std::vector<fs::path> elaborated_files(const std::string& top, const VerilogParameters& parameters,
                                       const std::vector<fs::path>& files, const std::vector<fs::path>& include_folders,
                                       const fs::path& cache) {
  const std::string text = commands(top, parameters, files, include_folders);
  Fingerprint key;
  key.add(text);
  for (const fs::path& file : files) key.add(read_text(file));
  for (const fs::path& folder : include_folders) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() == ".vh") key.add(entry.path().string() + read_text(entry.path()));
    }
  }
  const fs::path kept = cache / (key.hex() + ".files");
  const FileLock lock(cache / (key.hex() + ".lock"));
  if (!fs::exists(kept)) {
    const fs::path script = cache / (key.hex() + ".ys"), log = cache / (key.hex() + ".log");
    const fs::path design = cache / (key.hex() + ".design");
    // Only modules are asked for, and the writer takes no processes.
    std::ofstream(script) << text << "delete */p:*\nwrite_json " << design.string() << "\n";
    if (Process({"yosys", "-Q", "-s", script}, log).wait() != 0)
      throw SynthesisError("yosys cannot elaborate " + top + ":\n" + read_text(log));
    std::string names;
    for (const fs::path& file : sources_in(design)) names += file.string() + "\n";
    const fs::path partial = cache / (key.hex() + ".partial");
    std::ofstream(partial) << names;
    for (const fs::path& scratch : {script, log, design}) fs::remove(scratch);
    fs::rename(partial, kept);
  }
  std::vector<fs::path> found;
  std::ifstream in(kept);
  for (std::string name; std::getline(in, name);) found.emplace_back(name);
  return found;
}

}  // namespace wrinkle

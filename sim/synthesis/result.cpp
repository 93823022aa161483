#include "sim/synthesis/result.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "tb/process.h"

namespace wrinkle {

std::map<std::string, int> read_cells(const std::filesystem::path& stat) {
  const auto json = nlohmann::json::parse(read_text(stat));
  return json.at("design").at("num_cells_by_type").get<std::map<std::string, int>>();
}

std::vector<Multiplier> read_multipliers(const std::filesystem::path& dump) {
  std::vector<Multiplier> found;
  std::istringstream in(read_text(dump));
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string keyword, name;
    int value = 0;
    words >> keyword >> name;
    if (keyword == "cell") found.emplace_back();
    if (keyword != "parameter" || found.empty()) continue;
    if (name == "signed") words >> name;
    words >> value;
    if (name == "\\A_WIDTH") found.back().a_bits = value;
    if (name == "\\B_WIDTH") found.back().b_bits = value;
    if (name == "\\A_SIGNED") found.back().is_signed = value != 0;
  }
  return found;
}

double number_after(const std::string& text, const std::string& word) {
  const auto position = text.find(word);
  if (position == std::string::npos) throw SynthesisError("no \"" + word + "\" in:\n" + text);
  return std::stod(text.substr(position + word.size()));
}

std::string without_pads(const std::string& liberty) {
  static const std::regex pad(R"re(\bcell\s*\(\s*"?PAD\w*"?\s*\)\s*\{)re");
  std::string text;
  auto from = liberty.cbegin();
  for (std::smatch match; std::regex_search(from, liberty.cend(), match, pad);) {
    text.append(from, match[0].first);
    from = match[0].second;
    for (int depth = 1; depth > 0 && from != liberty.cend(); ++from) depth += *from == '{' ? 1 : *from == '}' ? -1 : 0;
  }
  return text.append(from, liberty.cend());
}

int count_flip_flops(const std::map<std::string, int>& cells) {
  static const std::regex flip_flop("DFF.*|SB_DFF.*|TRELLIS_FF|FD[RSCP]E?");
  int count = 0;
  for (const auto& [type, number] : cells) {
    if (std::regex_match(type, flip_flop)) count += number;
  }
  return count;
}

std::map<std::string, double> lef_areas(const std::filesystem::path& lef) {
  std::ifstream in(lef);
  if (!in) throw SynthesisError(lef.string() + ": cell library not found");
  std::map<std::string, double> areas;
  std::string macro;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string keyword, by;
    double width = 0, height = 0;
    words >> keyword;
    if (keyword == "MACRO") words >> macro;
    if (keyword == "SIZE" && words >> width >> by >> height) areas[macro] = width * height;
  }
  return areas;
}

nlohmann::json to_json(const NetlistChecked& checked) {
  return {{"clocks", checked.clocks},
          {"different", 0},
          {"registers", checked.registers},
          {"registers_changed", checked.registers_changed},
          {"outputs", checked.outputs},
          {"outputs_changed", checked.outputs_changed},
          {"faults", checked.faults},
          {"faults_found", checked.faults_found},
          {"faults_redundant", checked.faults_redundant},
          {"faults_missed", checked.faults_missed}};
}

NetlistChecked netlist_checked(const nlohmann::json& json) {
  return {json.at("clocks"),       json.at("registers"),        json.at("registers_changed"),
          json.at("outputs"),      json.at("outputs_changed"),  json.at("faults"),
          json.at("faults_found"), json.at("faults_redundant"), json.at("faults_missed")};
}

nlohmann::json to_json(const SynthesisResult& result) {
  nlohmann::json multipliers = nlohmann::json::array();
  for (const Multiplier& m : result.multipliers) {
    multipliers.push_back({{"a_bits", m.a_bits}, {"b_bits", m.b_bits}, {"signed", m.is_signed}});
  }
  return {{"um2", result.um2},
          {"nand2", result.nand2},
          {"critical_path_ns", result.critical_path_ns},
          {"flip_flops", result.flip_flops},
          {"multipliers", multipliers},
          {"cells", result.cells},
          {"checked", to_json(result.checked)},
          {"provenance", result.provenance}};
}

SynthesisResult synthesis_result(const nlohmann::json& json) {
  SynthesisResult result;
  result.um2 = json.at("um2");
  result.nand2 = json.at("nand2");
  result.critical_path_ns = json.at("critical_path_ns");
  result.flip_flops = json.at("flip_flops");
  for (const auto& m : json.at("multipliers"))
    result.multipliers.push_back({m.at("a_bits"), m.at("b_bits"), m.at("signed")});
  result.cells = json.at("cells").get<std::map<std::string, int>>();
  result.checked = netlist_checked(json.at("checked"));
  result.provenance = json.at("provenance");
  return result;
}

}  // namespace wrinkle

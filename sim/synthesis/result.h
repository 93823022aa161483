// Reading what the tools wrote, and the results kept on disk.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "sim/synthesis/synthesis.h"

namespace wrinkle {

// Cells by type, from Yosys's `stat -json` of a flat module.
std::map<std::string, int> read_cells(const std::filesystem::path& stat);

// The $mul cells of Yosys's `dump t:$mul`.
std::vector<Multiplier> read_multipliers(const std::filesystem::path& dump);

// The number after `word` in a tool's output; throws SynthesisError when there is none.
double number_after(const std::string& text, const std::string& word);

// The text of a Liberty file without its pads: mapping takes them for buffers.
std::string without_pads(const std::string& liberty);

// Cells of an FPGA or of a standard cell library that hold a bit.
int count_flip_flops(const std::map<std::string, int>& cells);

nlohmann::json to_json(const NetlistChecked& checked);
NetlistChecked netlist_checked(const nlohmann::json& json);
nlohmann::json to_json(const SynthesisResult& result);
SynthesisResult synthesis_result(const nlohmann::json& json);

}  // namespace wrinkle

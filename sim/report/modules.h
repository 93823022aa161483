// The Verilog of this project as a set of modules: one a file, the file named after it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "golden/config/config.h"
#include "sim/synthesis/synthesis.h"

namespace wrinkle {

// The stages of wrinkle_core in the order of its list; the module of `scan` is wrinkle_scan.
std::vector<std::string> stage_names();

// The files that `module` needs, its own among them: a change elsewhere leaves its cached result alone.
std::vector<std::filesystem::path> module_sources(const std::string& module);

// The parameters that `module` declares, with the values of the configuration.
VerilogParameters module_parameters(const std::string& module, const Config& config);

}  // namespace wrinkle

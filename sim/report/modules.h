// The Verilog of this project as a set of modules: one a file, the file named after it.
#pragma once

#include <string>
#include <vector>

#include "golden/config/config.h"
#include "sim/synthesis/synthesis.h"

namespace wrinkle {

// The stages of wrinkle_core in the order of its list.
std::vector<std::string> stage_names();

// The parameters that the core declares, with the values of the configuration.
VerilogParameters core_parameters(const Config& config);

// A stage as the core has it: its module, with the parameters that the core gives it, found by elaborating the core.
struct StageModule {
  std::string module;
  VerilogParameters parameters;
};
StageModule stage_module(const std::string& stage, const Config& config);

}  // namespace wrinkle

// Every figure of area that there is, and over how many clocks its netlist was equal to its Verilog.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "sim/report/area.h"

namespace wrinkle {

// Prints a table in Markdown, a row for each named configuration, for Fig. 1, 2 and 3 and for each normalizer, and
// gives the same as an array of {name, netlist, nand2 or luts, clocks}. With `fpga`, the stages on every FPGA too.
nlohmann::json measure_all(const AreaOptions& options, bool fpga);

}  // namespace wrinkle

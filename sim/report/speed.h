// How fast each engine draws, and how fast the chip would.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "golden/config/config.h"
#include "golden/triangle/draw.h"
#include "sim/report/area.h"

namespace wrinkle {

struct EngineSpeed {
  std::string_view engine;
  double pixels_per_cpu_s = 0;  // median of the runs
  std::string_view faithful_to;
};

// ideal, exact, golden-scalar, golden and rtl on one frame, `runs` times each, interleaved. The RTL is not compared.
std::vector<EngineSpeed> measure_engines(const Config& config, const Frame& frame, int runs);

// A configuration in silicon: clocks from the RTL without stalls, the period from the flat netlist's critical path;
// with a period of 0, which is unknown, the clocks alone.
struct ChipSpeed {
  std::string config;
  double clocks_per_pixel = 0, period_ns = 0, pixels_per_s = 0;
};
ChipSpeed chip_speed(const std::string& name, const Config& config, const Frame& frame, double period_ns);

nlohmann::json to_json(const EngineSpeed& speed);
nlohmann::json to_json(const ChipSpeed& speed);

}  // namespace wrinkle

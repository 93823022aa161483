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

// The speed of a configuration as a chip: its clocks are those of the RTL without stalls, its period is the critical
// path. A period of 0 means that it is unknown; then only the clocks are given.
struct ChipSpeed {
  std::string config;
  double clocks_per_pixel = 0, period_ns = 0, pixels_per_s = 0;
};
ChipSpeed chip_speed(const std::string& name, const Config& config, const Frame& frame, double period_ns);

nlohmann::json to_json(const EngineSpeed& speed);
nlohmann::json to_json(const ChipSpeed& speed);

}  // namespace wrinkle

#include "sim/stress/catalogue.h"

#include <algorithm>
#include <cmath>

namespace wrinkle {

void Extreme::measure(double deviation, const std::string& description) {
  ++cases;
  // A NaN counts as the worst of all, and stays.
  if (deviation <= worst || std::isnan(worst)) return;
  worst = deviation;
  where = description;
}

// The widths that the values of the entries are written for.
Config stress_config() {
  Config config;
  config.vector_bits = 10;
  config.unit_bits = 9;
  config.dot_bits = 10;
  config.subpixel_bits = 8;
  config.texel_bits = 8;
  config.depth_bits = 20;
  config.uv_bits = 18;
  config.lod_bits = 5;
  return config;
}

Config stress_config_wide() {
  Config config = stress_config();
  config.datapath = static_cast<int>(Datapath::kPhong);
  config.screen_bits = 12;
  config.guard_bits = 12;
  config.channels = 0;
  return config;
}

Config stress_config_perspective() {
  Config config = stress_config();
  config.perspective = 1;
  return config;
}

std::span<const ExtremeEntry> extremes() {
  static const std::vector<ExtremeEntry> all = [] {
    std::vector<ExtremeEntry> list;
    for (auto part : {geometry_extremes, interpolation_extremes, vector_extremes, lighting_extremes, texture_extremes,
                      host_extremes, displacement_extremes})
      for (ExtremeEntry& entry : part()) list.push_back(std::move(entry));
    std::sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.number < b.number; });
    return list;
  }();
  return all;
}

}  // namespace wrinkle

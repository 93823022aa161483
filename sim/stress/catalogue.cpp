#include "sim/stress/catalogue.h"

#include <algorithm>
#include <cmath>

#include "golden/datapath/datapaths.h"

namespace wrinkle {

void Extreme::measure(double deviation, const std::string& description) {
  ++cases;
  // A NaN counts as worse than any number, and no later deviation replaces it.
  if (deviation <= worst || std::isnan(worst)) return;
  worst = deviation;
  where = description;
}

Config stress_wide(Config config) {
  config.datapath = static_cast<int>(Datapath::kPhong);
  config.decal = config.gloss_map = 0;
  config.perspective = 0;
  config.screen_bits = 12;
  config.guard_bits = std::max(config.guard_bits, 12);
  config.channels = 0;
  return config;
}

Config stress_perspective(Config config) {
  config.perspective = 1;
  return config;
}

Config stress_affine(Config config) {
  config.perspective = 0;
  return config;
}

double drift_bound(const Config& config, int steps) {
  return 0.5 + (steps + 2) * std::ldexp(1.0, -(config.guard_bits + 1));
}

const std::vector<std::string>& stress_configs() {
  static const std::vector<std::string> names{"lean", "standard", "perspective", "fine", "extreme"};
  return names;
}

std::span<const ExtremeEntry> extremes() {
  static const std::vector<ExtremeEntry> all = [] {
    std::vector<ExtremeEntry> list;
    for (auto part : {geometry_extremes, interpolation_extremes, vector_extremes, lighting_extremes, texture_extremes,
                      perspective_extremes, host_extremes, displacement_extremes})
      for (ExtremeEntry& entry : part()) list.push_back(std::move(entry));
    std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.number < b.number; });
    return list;
  }();
  return all;
}

}  // namespace wrinkle

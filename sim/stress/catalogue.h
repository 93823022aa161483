// The catalogue of numerical extremes, 1 to 48, 56 and 57: one list for `./wrinkle stress` and for tests/extremes.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "golden/config.h"
#include "sim/stress/stimulus.h"

namespace wrinkle {

// What an entry found. Its stimuli are drawn again by the RTL and compared, value by value.
struct Extreme {
  std::uint64_t cases = 0;
  double worst = 0;  // largest deviation from what is expected, in `unit`
  double bound = 0;  // stated; docs/numerics.md
  std::string unit = "pixels";
  std::string where;  // the worst case, for people
  std::vector<Stimulus> stimuli;

  // Takes one more deviation into account.
  void measure(double deviation, const std::string& description = "");
  bool inside() const { return worst <= bound; }
};

struct ExtremeEntry {
  int number;
  std::string title;
  std::string unreachable;  // why no case exists, instead of `run`
  std::function<Extreme()> run;
};

std::span<const ExtremeEntry> extremes();

// The configurations the catalogue is drawn with: few, since each is a Verilated model.
Config stress_config();       // `standard`
Config stress_config_wide();  // 4096 by 4096 pixels, no texture
Config stress_config_perspective();

// The parts of the list, one file each.
std::vector<ExtremeEntry> geometry_extremes();
std::vector<ExtremeEntry> interpolation_extremes();
std::vector<ExtremeEntry> vector_extremes();
std::vector<ExtremeEntry> lighting_extremes();
std::vector<ExtremeEntry> texture_extremes();
std::vector<ExtremeEntry> host_extremes();
std::vector<ExtremeEntry> displacement_extremes();

}  // namespace wrinkle

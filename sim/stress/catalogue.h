// The catalogue of numerical extremes, 1 to 48, 56 and 57: one list for `./wrinkle stress` and for tests/extremes.
// Values are made from the widths of the configuration that is asked about.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "golden/config/config.h"
#include "sim/stress/stimulus.h"

namespace wrinkle {

// What an entry found. Its stimuli are drawn again by the RTL and compared, value by value.
struct Extreme {
  std::uint64_t cases = 0;
  double worst = 0;  // largest deviation from what is expected, in `unit`
  double bound = 0;  // stated; docs/numerics.md
  std::string unit = "pixels";
  std::string where;        // the worst case, for people
  std::string unreachable;  // why this configuration has no case
  std::vector<Stimulus> stimuli;

  // Takes one more deviation into account.
  void measure(double deviation, const std::string& description = "");
  bool inside() const { return worst <= bound; }
};

struct ExtremeEntry {
  int number;
  std::string title;
  std::string unreachable;  // why no configuration has a case, instead of `run`
  std::function<Extreme(const Config&)> run;
  bool long_run = false;  // many fragments: left out unless asked for
};

// Sorted by number; a number may have several entries. A configuration has bump mapping, all three normalizers, depth
// and S = 8, as every named one has: positions are written in 1/256 pixel.
std::span<const ExtremeEntry> extremes();

// The named configurations the entries are made for: those of [Peercy97 fig. 3], from lean to extreme.
const std::vector<std::string>& stress_configs();

// What entries draw with besides the configuration itself: few, since each is a Verilated model.
Config stress_wide(Config config);         // 4096 by 4096 pixels, no texture
Config stress_perspective(Config config);  // u and v divided
Config stress_affine(Config config);       // u and v not divided, so that a texture coordinate is what was set

// 1.0 in LSB of s1.V, and one repeat in LSB of u.
inline std::int64_t vector_one(const Config& config) { return std::int64_t{1} << config.vector_bits; }
inline std::int64_t repeat_one(const Config& config) { return std::int64_t{1} << config.uv_bits; }
// The bound of an interpolated value that is n pixels and rows away from the anchor, the pixel at which the packet
// gives the value. docs/numerics.md, "interpolate".
double drift_bound(const Config& config, int steps);

// The parts of the list, one file each.
std::vector<ExtremeEntry> geometry_extremes();
std::vector<ExtremeEntry> interpolation_extremes();
std::vector<ExtremeEntry> vector_extremes();
std::vector<ExtremeEntry> lighting_extremes();
std::vector<ExtremeEntry> texture_extremes();
std::vector<ExtremeEntry> perspective_extremes();
std::vector<ExtremeEntry> host_extremes();
std::vector<ExtremeEntry> displacement_extremes();

}  // namespace wrinkle

// Entries 13 to 18: interpolated values against the exact plane through the corners.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <random>

#include "golden/triangle/corners.h"
#include "sim/stress/catalogue.h"

namespace wrinkle {
namespace {

using Corners = std::array<std::array<std::int32_t, 2>, 3>;

// z at the corners, in LSB of u0.Z: whole numbers, so that quantising them loses nothing. All components are
// interpolated alike; z is the one that may have any value at every corner.
using CornerValues = std::array<std::int64_t, 3>;
// Set-up keeps z this clear of the ends of its format.
constexpr std::int64_t kLow = 8;
std::int64_t top(const Config& config) { return (std::int64_t{1} << config.depth_bits) - 1 - kLow; }

ScreenTriangle triangle_with(const Config& config, const Corners& corners, const CornerValues& values) {
  ScreenTriangle triangle = screen_triangle(corners);
  // Depth 0 to 1 is drawn as margin to 2^Z - 1 - margin.
  const auto margin = double(interpolation_margin(config, config.depth_bits));
  for (std::size_t i = 0; i < 3; ++i) {
    triangle.v[i].N = triangle.v[i].L = triangle.v[i].H = {0, 0, 1};
    triangle.v[i].z = (double(values[i]) - margin) / (std::ldexp(1.0, config.depth_bits) - 1 - 2 * margin);
  }
  return triangle;
}

// The plane through the corners at a pixel centre, in LSB.
double plane_at(const Config& config, const Corners& t, const CornerValues& values, const FragmentValues& fragment,
                const Stimulus& stimulus) {
  const double one = std::ldexp(1.0, config.subpixel_bits);
  const double x = (double(fragment[stimulus.index("scan", "x")][0]) + 0.5) * one;
  const double y = (double(fragment[stimulus.index("scan", "y")][0]) + 0.5) * one;
  const auto area = [](double ax, double ay, double bx, double by, double cx, double cy) {
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  };
  const double whole = area(t[0][0], t[0][1], t[1][0], t[1][1], t[2][0], t[2][1]);
  const double a = area(x, y, t[1][0], t[1][1], t[2][0], t[2][1]) / whole;
  const double b = area(t[0][0], t[0][1], x, y, t[2][0], t[2][1]) / whole;
  return a * double(values[0]) + b * double(values[1]) + (1 - a - b) * double(values[2]);
}

// Worst distance from the plane over all fragments, in LSB.
void measure_plane(Extreme& extreme, const Config& config, const Corners& corners, const CornerValues& values,
                   int width, int height) {
  Stimulus stimulus(config);
  stimulus.add_draw({});
  stimulus.add(triangle_with(config, corners, values), width, height);
  const std::size_t z = stimulus.index("interpolate", "z");
  for (const FragmentValues& f : stimulus.golden())
    extreme.measure(std::abs(double(f[z][0]) - plane_at(config, corners, values, f, stimulus)),
                    fmt::format("({},{}) ({},{}) ({},{})", corners[0][0], corners[0][1], corners[1][0], corners[1][1],
                                corners[2][0], corners[2][1]));
  extreme.stimuli.push_back(std::move(stimulus));
}

Extreme measured_in_lsb(double bound) {
  Extreme extreme;
  extreme.unit = "LSB";
  extreme.bound = bound;
  return extreme;
}

// No fragment may be off, not even by one LSB.
Extreme gradient_zero(const Config& config) {
  Extreme extreme = measured_in_lsb(0);
  for (std::int64_t v : {kLow, kLow + 1, top(config) * 7 / 10, top(config) - 1, top(config)}) {
    Stimulus stimulus(config);
    stimulus.add_draw({});
    stimulus.add(triangle_with(config, {{{3, 7}, {9000, 900}, {500, 8000}}}, {v, v, v}), 40, 40);
    for (const FragmentValues& f : stimulus.golden())
      extreme.measure(std::abs(double(f[stimulus.index("interpolate", "z")][0] - v)), fmt::format("z {}", v));
    extreme.stimuli.push_back(std::move(stimulus));
  }
  return extreme;
}

Extreme gradient_maximum(const Config& config) {
  Extreme extreme = measured_in_lsb(drift_bound(config, 80));
  const CornerValues steep{kLow, top(config), kLow + 1};
  for (const Corners& t : {Corners{{{0, 0}, {300, 0}, {0, 10000}}}, Corners{{{0, 0}, {10000, 40}, {9000, 300}}},
                           Corners{{{0, 128}, {257, 127}, {130, 640}}}, Corners{{{0, 0}, {10000, 0}, {0, 10000}}}})
    measure_plane(extreme, config, t, steep, 40, 40);
  return extreme;
}

// Beyond the end of its range a component wraps modulo 2^width, as the formula says.
Extreme wrapping(const Config& config) {
  Extreme extreme = measured_in_lsb(0);
  Stimulus stimulus(config);
  stimulus.add_draw({});
  const std::int64_t end = std::int64_t{1} << (stimulus.config().vector_bits + 1);
  const int length = 64;
  for (std::int64_t step : {std::int64_t{1}, std::int64_t{-1}, end / 3, -end / 3}) {
    TriangleWords words = stimulus.row(0, 0, length);
    stimulus.set(words, "n", 0, step > 0 ? end - 1 : -end, step);
    stimulus.add(words);
  }
  std::vector<std::uint32_t> owners;
  const auto fragments = stimulus.golden(owners);
  const std::int64_t steps[] = {1, -1, end / 3, -end / 3};
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    const std::int64_t step = steps[owners[i]];
    const std::int64_t unwrapped = (step > 0 ? end - 1 : -end) + step * std::int64_t(i % length);
    const std::int64_t expected = ((unwrapped + end) & (2 * end - 1)) - end;
    extreme.measure(double(std::abs(fragments[i][stimulus.index("interpolate", "n")][0] - expected)),
                    fmt::format("step {}, pixel {}", step, i % length));
  }
  extreme.stimuli.push_back(std::move(stimulus));
  return extreme;
}

Extreme drift(const Config& named) {
  const Config config = stress_wide(named);
  Extreme extreme = measured_in_lsb(drift_bound(config, 4096 + 1));
  const int end = 4096 * 256;
  const std::int64_t most = top(config);
  measure_plane(extreme, config, {{{0, 0}, {end, 0}, {0, 512}}}, {kLow, most, kLow + 1}, 4096, 2);
  measure_plane(extreme, config, {{{end, 0}, {end, 512}, {0, 512}}}, {most - 5, 77, most * 3 / 10}, 4096, 2);
  measure_plane(extreme, config, {{{0, 0}, {512, 0}, {0, end}}}, {kLow + 3, kLow, most}, 2, 4096);
  return extreme;
}

// Two triangles that share an edge and its values: how far the errors on both sides of it are apart.
Extreme shared_edge(const Config& config) {
  Extreme extreme = measured_in_lsb(2 * drift_bound(config, 64));
  const Corners one{{{-300, -200}, {8500, 400}, {100, 8100}}}, two{{{8500, 400}, {8900, 8700}, {100, 8100}}};
  const std::int64_t most = top(config);
  const CornerValues ones{most * 3 / 10, most * 7 / 10, most / 10}, twos{most * 7 / 10, most * 9 / 10, most / 10};
  Stimulus stimulus(config);
  stimulus.add_draw({});
  stimulus.add(triangle_with(config, one, ones), 32, 32);
  stimulus.add(triangle_with(config, two, twos), 32, 32);
  std::vector<std::uint32_t> owners;
  const auto fragments = stimulus.golden(owners);
  std::map<std::pair<std::int64_t, std::int64_t>, std::pair<std::uint32_t, double>> error;
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    const Corners& corners = owners[i] == 0 ? one : two;
    const FragmentValues& f = fragments[i];
    error[{f[stimulus.index("scan", "y")][0], f[stimulus.index("scan", "x")][0]}] = {
        owners[i], double(f[stimulus.index("interpolate", "z")][0]) -
                       plane_at(config, corners, owners[i] == 0 ? ones : twos, f, stimulus)};
  }
  for (const auto& [pixel, mine] : error) {
    const auto right = error.find({pixel.first, pixel.second + 1});
    if (right != error.end() && right->second.first != mine.first)
      extreme.measure(std::abs(mine.second - right->second.second),
                      fmt::format("pixel {},{}", pixel.second, pixel.first));
  }
  extreme.stimuli.push_back(std::move(stimulus));
  return extreme;
}

Extreme rotated(const Config& config) {
  Extreme extreme = measured_in_lsb(0);
  std::mt19937 random(18);
  std::uniform_int_distribution<int> at(-2000, 10000), value{int{kLow}, int(top(config))};
  std::vector<Stimulus> turns(3, Stimulus(config));
  for (Stimulus& turn : turns) turn.add_draw({});
  for (int i = 0; i < 30; ++i) {
    const Corners corners{{{at(random), at(random)}, {at(random), at(random)}, {at(random), at(random)}}};
    const CornerValues values{value(random), value(random), value(random)};
    ScreenTriangle triangle = triangle_with(config, corners, values);
    for (Stimulus& turn : turns) {
      turn.add(triangle, 32, 32);
      std::rotate(triangle.v.begin(), triangle.v.begin() + 1, triangle.v.end());
    }
  }
  const auto first = turns[0].golden();
  for (std::size_t k = 1; k < 3; ++k) {
    const auto other = turns[k].golden();
    extreme.measure(std::abs(double(first.size()) - double(other.size())), "number of fragments");
    const std::size_t z = turns[k].index("interpolate", "z");
    for (std::size_t i = 0; i < std::min(first.size(), other.size()); ++i)
      extreme.measure(double(std::abs(first[i][z][0] - other[i][z][0])), fmt::format("fragment {}", i));
  }
  extreme.stimuli = std::move(turns);
  return extreme;
}

}  // namespace

std::vector<ExtremeEntry> interpolation_extremes() {
  return {{13, "gradient 0: constant", "", gradient_zero},
          {14, "steepest gradients", "", gradient_maximum},
          {15, "past the end of the range: wraps as specified", "", wrapping},
          {16, "drift over 4096 pixels", "", drift},
          {17, "mismatch across a shared edge", "", shared_edge},
          {18, "corners rotated", "", rotated}};
}

}  // namespace wrinkle

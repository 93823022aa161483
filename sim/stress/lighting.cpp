// Entries 32 to 38: the light and output stages against the same sums in real numbers, from the unit vectors they got.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "sim/stress/catalogue.h"

namespace wrinkle {
namespace {

using IntVec = std::array<std::int64_t, 3>;

double dot_of(const Stimulus& s, const FragmentValues& f, std::string_view a, std::string_view b) {
  double sum = 0;
  for (std::size_t e = 0; e < 3; ++e) sum += s.real(f, "normalize", a, e) * s.real(f, "normalize", b, e);
  return sum;
}

// N.L and N.H of every fragment, in LSB of u1.DF; clamped to [0, 1] as the format is.
void measure_dots(Extreme& extreme, const Stimulus& stimulus) {
  const double one = std::ldexp(1.0, stimulus.config().dot_bits);
  for (const FragmentValues& f : stimulus.golden()) {
    for (auto [value, vector] : {std::pair{"nl", "l"}, std::pair{"nh", "h"}}) {
      const double expected = std::clamp(dot_of(stimulus, f, "n", vector), 0.0, 1.0);
      extreme.measure(one * std::abs(stimulus.real(f, "light", value) - expected),
                      fmt::format("{} = {}", value, expected));
    }
  }
}

Extreme dots(const std::vector<std::pair<IntVec, IntVec>>& pairs) {
  Extreme extreme;
  extreme.unit = "LSB of u1.DF";
  extreme.bound = 0.5;
  Stimulus stimulus(stress_config());
  stimulus.add_draw({});
  for (const auto& [n, l] : pairs) stimulus.add_vectors(n, l, l);
  measure_dots(extreme, stimulus);
  extreme.stimuli.push_back(std::move(stimulus));
  return extreme;
}

Extreme grazing() {
  std::vector<std::pair<IntVec, IntVec>> pairs;
  for (std::int64_t d = -16; d <= 16; ++d) {
    pairs.push_back({{0, 0, 1024}, {1024, 0, d}});
    pairs.push_back({{724, 724, 0}, {724, -724 + d, 0}});
    pairs.push_back({{900, 300 + d, 4}, {-300, 900, 2 * d}});
  }
  return dots(pairs);
}

Extreme negative() {
  std::vector<std::pair<IntVec, IntVec>> pairs;
  for (std::int64_t d = 0; d < 64; ++d) pairs.push_back({{d, 32 - d, 1000}, {16 * d - 500, 16 * d, -1000}});
  Extreme extreme = dots(pairs);
  extreme.bound = 0;
  return extreme;
}

// N = L in every direction: never above one, never wrapped to zero. Rounded unit vectors are as much as 1 ulp per
// component short, so the sum may fall short of one; against the vectors themselves it is within half an LSB.
Extreme aligned() {
  std::vector<std::pair<IntVec, IntVec>> pairs;
  std::mt19937 random(34);
  std::uniform_int_distribution<std::int64_t> component(-2047, 2047);
  for (int i = 0; i < 3000; ++i) {
    const IntVec v{component(random), component(random), component(random)};
    pairs.push_back({v, v});
  }
  pairs.push_back({{0, 0, 2047}, {0, 0, 1}});
  return dots(pairs);
}

// Every exponent, N.H from 0 to 1. Squaring doubles the error before it and adds half an LSB: (2^K - 1) / 2 after K.
Extreme powers() {
  const Config config = stress_config();
  Extreme extreme;
  extreme.unit = "LSB of u1.PF";
  extreme.bound = 0.5 * ((1 << config.specular_squarings) - 1);
  Stimulus stimulus(config);
  std::vector<int> exponents{0};
  for (int k = 0; k <= config.specular_squarings; ++k) exponents.push_back(1 << k);
  constexpr int kSteps = 200;
  for (int exponent : exponents) {
    DrawState state;
    state.material.exponent = exponent;
    stimulus.add_draw(state);
    for (int i = 0; i <= kSteps; ++i) {
      // The last two: N.H = 1, and the largest that is less.
      const std::int64_t across = i == kSteps ? 0 : i == kSteps - 1 ? 90 : 1024 - 5 * i;
      stimulus.add_vectors({0, 0, 1024}, {0, 0, 1024}, {across, 0, 5 * i});
    }
  }
  const auto fragments = stimulus.golden();
  const double one = std::ldexp(1.0, config.power_bits);
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    const int exponent = exponents[i / (kSteps + 1)];
    const double nh = stimulus.real(fragments[i], "light", "nh");
    extreme.measure(one * std::abs(stimulus.real(fragments[i], "light", "specular") - std::pow(nh, exponent)),
                    fmt::format("{}^{}", nh, exponent));
  }
  extreme.stimuli.push_back(std::move(stimulus));
  return extreme;
}

// The colour in codes against ambient + diffuse + specular in real numbers, from the values the output stage got.
void measure_colour(Extreme& extreme, const Stimulus& stimulus, const Material& material) {
  const double top = (1 << stimulus.config().colour_bits) - 1;
  const auto quantised = [&](double c) { return std::round(std::ldexp(c, stimulus.config().colour_bits)) / (top + 1); };
  for (const FragmentValues& f : stimulus.golden()) {
    const double diffuse = stimulus.real(f, "light", "diffuse"), specular = stimulus.real(f, "light", "specular");
    const double a[] = {material.ambient.x, material.ambient.y, material.ambient.z};
    const double d[] = {material.diffuse.x, material.diffuse.y, material.diffuse.z};
    const double s[] = {material.specular.x, material.specular.y, material.specular.z};
    for (std::size_t c = 0; c < 3; ++c) {
      const double sum = quantised(a[c]) + quantised(d[c]) * diffuse + quantised(s[c]) * specular;
      const double code = double(f[stimulus.index("output", "colour")][c]);
      extreme.measure(std::abs(code - top * std::min(sum, 1.0)), fmt::format("sum {}", sum));
    }
  }
}

Extreme saturating() {
  Extreme extreme;
  extreme.unit = "colour codes";
  extreme.bound = 0.5;
  for (const Material& material :
       {Material{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, 1}, Material{{1, 0, 0.5}, {0.5, 1, 0}, {0, 0.25, 1}, 4},
        Material{{0, 0, 0}, {1, 1, 1}, {0, 0, 0}, 1}, Material{}}) {
    Stimulus stimulus(stress_config());
    DrawState state;
    state.material = material;
    stimulus.add_draw(state);
    for (std::int64_t i = -20; i <= 100; ++i)
      stimulus.add_vectors({0, 0, 1024}, {1024 - 10 * i, 3, 10 * i}, {900 - 9 * i, 3, 10 * i});
    measure_colour(extreme, stimulus, material);
    extreme.stimuli.push_back(std::move(stimulus));
  }
  return extreme;
}

// L = 0, as at a vertex where the light is: flag, no diffuse, no specular, the ambient colour. Constant L beside it.
Extreme light_at_vertex() {
  Extreme extreme;
  extreme.unit = "fragments";
  Stimulus stimulus(stress_config());
  stimulus.add_draw({});
  stimulus.add_vectors({0, 0, 1024}, {0, 0, 0}, {0, 0, 1024});
  stimulus.add_vectors({0, 0, 1024}, {0, 0, 1}, {0, 0, 1024});
  TriangleWords infinity = stimulus.row(0, 4, 50);
  stimulus.set(infinity, Component::kNz, 1024);
  stimulus.set(infinity, Component::kLx, 600);
  stimulus.set(infinity, Component::kLz, 800);
  stimulus.set(infinity, Component::kHz, 1024);
  stimulus.add(infinity);
  const auto fragments = stimulus.golden();
  const std::size_t zero = stimulus.index("normalize", "zero"), diffuse = stimulus.index("light", "diffuse");
  const std::int64_t full = std::int64_t{1} << stimulus.config().dot_bits;
  extreme.measure(fragments[0][zero][0] != 1 || fragments[0][diffuse][0] != 0, "L = 0");
  extreme.measure(fragments[1][zero][0] != 0 || fragments[1][diffuse][0] != full, "L = 1 LSB");
  for (std::size_t i = 3; i < fragments.size(); ++i)
    extreme.measure(
        fragments[i][stimulus.index("output", "colour")] != fragments[2][stimulus.index("output", "colour")],
        "light at infinity");
  extreme.stimuli.push_back(std::move(stimulus));
  return extreme;
}

}  // namespace

std::vector<ExtremeEntry> lighting_extremes() {
  return {
      {32, "N.L about 0, by 1 LSB", "", grazing},
      {33, "N.L negative: exactly 0", "", negative},
      {34, "N.L about 1: saturates, never wraps", "", aligned},
      {35, "exponents 0, 1 to the largest; N.H = 1 and below", "", powers},
      {36, "ends of the exponent's table", "the power is by squaring: there is no table; entry 35 has both ends", {}},
      {37, "ambient + diffuse + specular saturate", "", saturating},
      {38, "light at the vertex and at infinity", "", light_at_vertex}};
}

}  // namespace wrinkle

// Entries 32 to 38: the light and output stages against the same sums in real numbers, from the unit vectors they got.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "sim/stress/catalogue.h"

namespace wrinkle {
namespace {

using IntVec = std::array<std::int64_t, 3>;

// The entries give vectors with 10 fraction bits.
IntVec scaled(const Config& config, IntVec v) {
  for (auto& c : v) c = (c << config.vector_bits) >> 10;
  return v;
}

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

Extreme dots(const Config& config, const std::vector<std::pair<IntVec, IntVec>>& pairs) {
  Extreme extreme;
  extreme.unit = "LSB of u1.DF";
  extreme.bound = 0.5;
  Stimulus stimulus(config);
  stimulus.add_draw({});
  for (const auto& [n, l] : pairs) stimulus.add_vectors(n, l, l);
  measure_dots(extreme, stimulus);
  extreme.stimuli.push_back(std::move(stimulus));
  return extreme;
}

Extreme grazing(const Config& config) {
  std::vector<std::pair<IntVec, IntVec>> pairs;
  const std::int64_t one = vector_one(config), diagonal = std::llround(double(one) * std::sqrt(0.5));
  for (std::int64_t d = -16; d <= 16; ++d) {
    pairs.push_back({{0, 0, one}, {one, 0, d}});
    pairs.push_back({{diagonal, diagonal, 0}, {diagonal, -diagonal + d, 0}});
    pairs.push_back({{one * 7 / 8, one / 4 + d, 4}, {-one / 4, one * 7 / 8, 2 * d}});
  }
  return dots(config, pairs);
}

Extreme negative(const Config& config) {
  std::vector<std::pair<IntVec, IntVec>> pairs;
  for (std::int64_t d = 0; d < 64; ++d)
    pairs.push_back({scaled(config, {d, 32 - d, 1000}), scaled(config, {16 * d - 500, 16 * d, -1000})});
  Extreme extreme = dots(config, pairs);
  extreme.bound = 0;
  return extreme;
}

// N = L in every direction: N.L is never above one and never wraps to zero. Rounded unit vectors are as much as 1 ulp
// per component short, so the sum may fall short of one; against the vectors themselves it is within half an LSB.
Extreme aligned(const Config& config) {
  std::vector<std::pair<IntVec, IntVec>> pairs;
  std::mt19937 random(34);
  std::uniform_int_distribution<std::int64_t> component(1 - 2 * vector_one(config), 2 * vector_one(config) - 1);
  for (int i = 0; i < 3000; ++i) {
    const IntVec v{component(random), component(random), component(random)};
    pairs.push_back({v, v});
  }
  pairs.push_back({{0, 0, 2 * vector_one(config) - 1}, {0, 0, 1}});
  return dots(config, pairs);
}

// The error of (N.H)^n for the N.H that the stage rounded: e_k+1 = 2 e_k + e_k^2 2^-PF + 1/2, beginning with 0.
double power_bound(const Config& config) {
  double error = 0;
  for (int k = 0; k < config.specular_squarings; ++k)
    error = 2 * error + std::ldexp(error * error, -config.power_bits) + 0.5;
  return error;
}

// Every exponent, N.H from 0 to 1 - 2^-F and 1.
Extreme powers(const Config& config) {
  Extreme extreme;
  extreme.unit = "LSB of u1.PF";
  extreme.bound = power_bound(config);
  Stimulus stimulus(config);
  std::vector<int> exponents{0};
  for (int k = 0; k <= config.specular_squarings; ++k) exponents.push_back(1 << k);
  constexpr int kSteps = 200;
  const std::int64_t one = vector_one(config);
  // z just short of 1: rounds to 1 - 2^-F.
  const std::int64_t beside = std::llround(double(one) * std::sqrt(std::ldexp(2.0, -config.unit_bits)));
  for (int exponent : exponents) {
    DrawState state;
    state.material.exponent = exponent;
    stimulus.add_draw(state);
    for (std::int64_t i = 0; i <= kSteps; ++i) {
      IntVec h{one * (kSteps - i) / kSteps, 0, one * i / kSteps};
      if (i == kSteps - 1) h = {beside, 0, one};
      stimulus.add_vectors({0, 0, one}, {0, 0, one}, h);
    }
  }
  const auto fragments = stimulus.golden();
  const double unit = std::ldexp(1.0, config.power_bits);
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    const int exponent = exponents[i / (kSteps + 1)], step = int(i % (kSteps + 1));
    const double nh = stimulus.real(fragments[i], "light", "nh");
    if (step >= kSteps - 1) {
      const double expected = step == kSteps ? 1 : 1 - std::ldexp(1.0, -config.unit_bits);
      extreme.measure(nh == expected ? 0 : 1e9, fmt::format("N.H = {}", nh));
    }
    extreme.measure(unit * std::abs(stimulus.real(fragments[i], "light", "specular") - std::pow(nh, exponent)),
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
    for (std::size_t c = 0; c < std::size_t(Shape(stimulus.config()).count); ++c) {
      const double sum = quantised(a[c]) + quantised(d[c]) * diffuse + quantised(s[c]) * specular;
      const double code = double(f[stimulus.index("output", "colour")][c]);
      extreme.measure(std::abs(code - top * std::min(sum, 1.0)), fmt::format("sum {}", sum));
    }
  }
}

Extreme saturating(const Config& config) {
  Extreme extreme;
  extreme.unit = "colour codes";
  extreme.bound = 0.5;
  for (const Material& material :
       {Material{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, 1}, Material{{1, 0, 0.5}, {0.5, 1, 0}, {0, 0.25, 1}, 4},
        Material{{0, 0, 0}, {1, 1, 1}, {0, 0, 0}, 1}, Material{}}) {
    Stimulus stimulus(config);
    DrawState state;
    state.material = material;
    stimulus.add_draw(state);
    for (std::int64_t i = -20; i <= 100; ++i)
      stimulus.add_vectors(scaled(config, {0, 0, 1024}), scaled(config, {1024 - 10 * i, 4, 10 * i}),
                           scaled(config, {900 - 9 * i, 4, 10 * i}));
    measure_colour(extreme, stimulus, material);
    extreme.stimuli.push_back(std::move(stimulus));
  }
  return extreme;
}

// L = 0, as at a vertex where the light is: the flag is set and only the ambient colour is left. A triangle with
// constant L lies beside it.
Extreme light_at_vertex(const Config& config) {
  Extreme extreme;
  extreme.unit = "fragments";
  Stimulus stimulus(config);
  stimulus.add_draw({});
  const std::int64_t one = vector_one(config);
  stimulus.add_vectors({0, 0, one}, {0, 0, 0}, {0, 0, one});
  stimulus.add_vectors({0, 0, one}, {0, 0, 1}, {0, 0, one});
  TriangleWords infinity = stimulus.row(0, 4, 50);
  stimulus.set(infinity, "n", 2, one);
  stimulus.set(infinity, "l", 0, one * 3 / 5);
  stimulus.set(infinity, "l", 2, one * 4 / 5);
  stimulus.set(infinity, "h", 2, one);
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

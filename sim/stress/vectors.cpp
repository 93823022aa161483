// Entries 19 to 28: the normalizer against the exact unit vector, in units in the last place of s1.F.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <random>

#include "golden/pixel/normalizer_geometry.h"
#include "sim/stress/catalogue.h"

namespace wrinkle {
namespace {

using IntVec = std::array<std::int64_t, 3>;

IntVec negated(IntVec v) { return {-v[0], -v[1], -v[2]}; }

// Draws the vectors through all three normalizers and takes every component into account. The one value without a
// negative, -2^(V+1), stands for -(2^(V+1) - 1).
void measure_units(Extreme& extreme, const Config& config, const std::vector<IntVec>& vectors) {
  Stimulus stimulus(config);
  stimulus.add_draw({});
  const std::size_t count = vectors.size();
  for (std::size_t i = 0; i < count; ++i)
    stimulus.add_vectors(vectors[i], vectors[(i + 1) % count], vectors[(i + 2) % count]);
  const auto fragments = stimulus.golden();
  const std::int64_t limit = (std::int64_t{1} << (config.vector_bits + 1)) - 1;
  const double one = std::ldexp(1.0, config.unit_bits);
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    bool any_zero = false;
    for (std::size_t k = 0; k < 3; ++k) {
      IntVec v = vectors[(i + k) % count];
      for (auto& c : v) c = std::max(c, -limit);
      const double length = std::sqrt(double(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
      any_zero |= length == 0;
      const auto& unit = fragments[i][stimulus.index("normalize", k == 0 ? "n" : k == 1 ? "l" : "h")];
      for (std::size_t e = 0; e < 3; ++e)
        extreme.measure(std::abs(double(unit[e]) - (length > 0 ? one * double(v[e]) / length : 0)),
                        fmt::format("({}, {}, {})", v[0], v[1], v[2]));
    }
    extreme.measure(any_zero == (fragments[i][stimulus.index("normalize", "zero")][0] != 0) ? 0 : 1e9, "zero flag");
  }
  extreme.stimuli.push_back(std::move(stimulus));
}

Extreme units(const std::vector<IntVec>& vectors, double bound = 1) {
  Extreme extreme;
  extreme.unit = "ulp of s1.F";
  extreme.bound = bound;
  measure_units(extreme, stress_config(), vectors);
  return extreme;
}

std::int64_t largest() { return (std::int64_t{1} << (stress_config().vector_bits + 1)) - 1; }

// A span whose normal passes through zero: exactly there the flag is set and the colour is the ambient one.
Extreme through_zero() {
  Extreme extreme;
  extreme.unit = "fragments";
  Stimulus stimulus(stress_config());
  stimulus.add_draw({});
  TriangleWords words = stimulus.row(0, 0, 65);
  stimulus.set(words, Component::kNx, -32, 1);
  stimulus.set(words, Component::kLx, 512);
  stimulus.set(words, Component::kHx, 512);
  stimulus.add(words);
  const auto fragments = stimulus.golden();
  for (const FragmentValues& f : fragments) {
    const auto x = f[stimulus.index("scan", "x")][0];
    const bool zero = f[stimulus.index("normalize", "zero")][0] != 0;
    const auto diffuse = f[stimulus.index("light", "diffuse")][0], specular = f[stimulus.index("light", "specular")][0];
    extreme.measure(zero != (x == 32) || (diffuse > 0) != (x > 32) || (specular > 0) != (x > 32),
                    fmt::format("pixel {}", x));
  }
  extreme.measure(fragments.size() != 65, "number of fragments");
  extreme.stimuli.push_back(std::move(stimulus));
  return extreme;
}

Extreme nearly_zero() {
  std::vector<IntVec> vectors;
  for (std::int64_t x = -2; x <= 2; ++x)
    for (std::int64_t y = -2; y <= 2; ++y)
      for (std::int64_t z = -2; z <= 2; ++z) vectors.push_back({x, y, z});
  return units(vectors);
}

Extreme most_negative() { return units({{-largest() - 1, -largest() - 1, -largest() - 1}, {1, 0, 0}, {0, 0, 5}}); }

Extreme mixed_ends() {
  std::vector<IntVec> vectors;
  const std::int64_t ends[] = {-largest() - 1, largest(), -largest(), 0};
  for (std::int64_t x : ends)
    for (std::int64_t y : ends)
      for (std::int64_t z : ends) vectors.push_back({x, y, z});
  return units(vectors);
}

Extreme single_bit() {
  std::vector<IntVec> vectors;
  for (std::size_t e = 0; e < 3; ++e)
    for (std::int64_t other : {0, 1, -1}) {
      IntVec v{other, other, other};
      v[e] = 1;
      vectors.push_back(v);
      vectors.push_back(negated(v));
    }
  return units(vectors);
}

// Sums of squares at and beside powers of four. 4^k - 1 = 7 mod 8 is no sum of three squares: 4^k - 2 stands for it.
Extreme shift_parity() {
  std::vector<IntVec> vectors;
  for (int k = 1; k <= 9; ++k)
    for (std::int64_t offset : {-2, -1, 0, 1, 2}) {
      const std::int64_t s = (std::int64_t{1} << (2 * k)) + offset;
      bool found = false;
      for (std::int64_t x = 0; x * x <= s && !found; ++x)
        for (std::int64_t y = x; x * x + y * y <= s && !found; ++y) {
          const std::int64_t z = std::llround(std::sqrt(double(s - x * x - y * y)));
          if (z >= y && x * x + y * y + z * z == s && z <= largest()) {
            vectors.push_back({x, y, z});
            vectors.push_back({-z, x, y});
            found = true;
          }
        }
    }
  return units(vectors);
}

// Vectors whose sum of squares falls on the first or last steps of a segment of the table, all segments.
Extreme segment_boundaries() {
  const RsqrtGeometry& geometry = rsqrt_geometry(stress_config().unit_bits);
  const int product_bits = 2 * (stress_config().vector_bits + 1);
  std::map<std::int64_t, int> have;
  std::vector<IntVec> vectors{{largest(), largest(), largest()}};
  std::mt19937 random(26);
  std::uniform_int_distribution<std::int64_t> component(-largest(), largest());
  for (int i = 0; i < 400000; ++i) {
    IntVec v{largest() / 2 + 1 + std::abs(component(random)) / 2, component(random), component(random)};
    const std::int64_t s = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    const bool high = (s >> product_bits) != 0;
    const std::int64_t t = (s << (high ? 0 : 2)) >> (product_bits + 2 - geometry.input_bits);
    const std::int64_t x = (t >> (geometry.input_bits - 1)) != 0 ? t >> 1 : t;
    const std::int64_t n = std::int64_t{1} << geometry.offset_bits(), dx = x % n;
    if (dx > 2 && dx < n - 2) continue;
    if (++have[t] <= 3) vectors.push_back(v);
  }
  return units(vectors);
}

Extreme axes() {
  std::vector<IntVec> vectors;
  for (std::int64_t m = 1; m <= largest(); m += m < 64 ? 1 : 13)
    for (std::size_t e = 0; e < 3; ++e) {
      IntVec v{};
      v[e] = m;
      vectors.push_back(v);
      vectors.push_back(negated(v));
    }
  return units(vectors, 0);
}

// n(-v) = -n(v): rounding of the magnitude, so that ties go away from zero on both sides.
Extreme ties() {
  Extreme extreme;
  extreme.unit = "ulp of s1.F";
  std::mt19937 random(28);
  std::uniform_int_distribution<std::int64_t> component(-largest(), largest());
  Stimulus stimulus(stress_config());
  stimulus.add_draw({});
  std::vector<IntVec> vectors;
  for (int i = 0; i < 2000; ++i) {
    const int small = i % 8;
    IntVec v{component(random) >> small, component(random) >> small, component(random) >> small};
    vectors.push_back(v);
    stimulus.add_vectors(v, negated(v), v);
  }
  const auto fragments = stimulus.golden();
  for (std::size_t i = 0; i < fragments.size(); ++i)
    for (std::size_t e = 0; e < 3; ++e)
      extreme.measure(double(std::abs(fragments[i][stimulus.index("normalize", "n")][e] +
                                      fragments[i][stimulus.index("normalize", "l")][e])),
                      fmt::format("({}, {}, {})", vectors[i][0], vectors[i][1], vectors[i][2]));
  extreme.stimuli.push_back(std::move(stimulus));
  return extreme;
}

}  // namespace

std::vector<ExtremeEntry> vector_extremes() {
  return {{19, "opposed normals: through exact zero", "", through_zero},
          {20, "nearly opposed: 1 LSB off zero", "", nearly_zero},
          {22, "all components most negative", "", most_negative},
          {23, "most negative and most positive mixed", "", mixed_ends},
          {24, "one component of 1 LSB", "", single_bit},
          {25, "sums of squares beside powers of four", "", shift_parity},
          {26, "beside every segment of the root's table", "", segment_boundaries},
          {27, "exactly +1 and -1 along axes", "", axes},
          {28, "ties: odd symmetry", "", ties}};
}

}  // namespace wrinkle

// Entries 19 to 28: the normalizer against the exact unit vector, in units in the last place of s1.F.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "golden/pixel/rsqrt.h"
#include "sim/stress/catalogue.h"

namespace wrinkle {
namespace {

using IntVec = std::array<std::int64_t, 3>;

IntVec negated(IntVec v) { return {-v[0], -v[1], -v[2]}; }

// Sends the vectors through all three normalizers and checks every component. The value -2^(V+1), which has no positive
// counterpart, stands for -(2^(V+1) - 1).
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

Extreme units(const Config& config, const std::vector<IntVec>& vectors, double bound = 1) {
  Extreme extreme;
  extreme.unit = "ulp of s1.F";
  extreme.bound = bound;
  measure_units(extreme, config, vectors);
  return extreme;
}

// The largest magnitude of s1.V that exists with both signs.
std::int64_t largest_of(const Config& config) { return (std::int64_t{1} << (config.vector_bits + 1)) - 1; }

// A span whose normal passes through zero: at that pixel alone the flag is set and the colour is the ambient one.
Extreme through_zero(const Config& config) {
  Extreme extreme;
  extreme.unit = "fragments";
  Stimulus stimulus(config);
  stimulus.add_draw({});
  TriangleWords words = stimulus.row(0, 0, 65);
  stimulus.set(words, "n", 0, -32, 1);
  stimulus.set(words, "l", 0, vector_one(config) / 2);
  stimulus.set(words, "h", 0, vector_one(config) / 2);
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

Extreme nearly_zero(const Config& config) {
  std::vector<IntVec> vectors;
  for (std::int64_t x = -2; x <= 2; ++x)
    for (std::int64_t y = -2; y <= 2; ++y)
      for (std::int64_t z = -2; z <= 2; ++z) vectors.push_back({x, y, z});
  return units(config, vectors);
}

Extreme most_negative(const Config& config) {
  const std::int64_t largest = largest_of(config);
  return units(config, {{-largest - 1, -largest - 1, -largest - 1}, {1, 0, 0}, {0, 0, 5}});
}

Extreme mixed_ends(const Config& config) {
  const std::int64_t largest = largest_of(config);
  std::vector<IntVec> vectors;
  const std::int64_t ends[] = {-largest - 1, largest, -largest, 0};
  for (std::int64_t x : ends)
    for (std::int64_t y : ends)
      for (std::int64_t z : ends) vectors.push_back({x, y, z});
  return units(config, vectors);
}

Extreme single_bit(const Config& config) {
  std::vector<IntVec> vectors;
  for (std::size_t e = 0; e < 3; ++e)
    for (std::int64_t other : {0, 1, -1}) {
      IntVec v{other, other, other};
      v[e] = 1;
      vectors.push_back(v);
      vectors.push_back(negated(v));
    }
  return units(config, vectors);
}

// x <= y <= z with x^2 + y^2 + z^2 = s, where there are any.
std::optional<IntVec> three_squares(std::int64_t s, std::int64_t largest) {
  const auto root = [](std::int64_t n) { return std::int64_t(isqrt(std::uint64_t(n))); };
  for (std::int64_t x = 0; x * x <= s && x <= 64; ++x)
    for (std::int64_t y = x; 2 * y * y <= s - x * x; ++y) {
      const std::int64_t z = root(s - x * x - y * y);
      if (x * x + y * y + z * z == s && z <= largest) return IntVec{x, y, z};
    }
  return std::nullopt;
}

// A vector of about the squared length s, anywhere in the octant.
IntVec random_vector(std::int64_t s, std::int64_t largest, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  double d[3];
  for (double& c : d) c = std::abs(normal(random));
  const double scale = std::sqrt(double(s) / (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]));
  IntVec v;
  for (std::size_t e = 0; e < 3; ++e) v[e] = std::min(largest, std::int64_t(std::llround(d[e] * scale)));
  const std::int64_t rest = s - v[0] * v[0] - v[1] * v[1];
  if (rest >= 0) v[2] = std::min(largest, std::int64_t(isqrt(std::uint64_t(rest))));
  return v;
}

// Sums of squares at and beside powers of four, up to the largest. 4^k - 1 = 7 mod 8 is a sum of three squares for k =
// 1 alone (Legendre); 4^k - 2, the nearest below it that is one for every k, stands for it.
Extreme shift_parity(const Config& config) {
  Extreme extreme = units(config, {{1, 1, 1}});
  std::vector<IntVec> vectors;
  for (int k = 1; k <= config.vector_bits + 1; ++k)
    for (std::int64_t offset : {-2, -1, 0, 1, 2}) {
      const std::int64_t s = (std::int64_t{1} << (2 * k)) + offset;
      const auto found = three_squares(s, largest_of(config));
      if (!found) {
        // Only those that have none may be missing: 4^k - 1 for k > 1, and what the format is too narrow for.
        extreme.measure((offset == -1 && k > 1) || k == config.vector_bits + 1 ? 0 : 1e9, fmt::format("S = {}", s));
        continue;
      }
      const auto [x, y, z] = *found;
      vectors.push_back({x, y, z});
      vectors.push_back({-z, x, y});
    }
  measure_units(extreme, config, vectors);
  return extreme;
}

// Vectors whose sum of squares falls on the first and last steps of every segment of the table, shifted by an even and
// by an odd number of places.
Extreme segment_boundaries(const Config& config) {
  const std::int64_t largest = largest_of(config);
  const RsqrtGeometry& geometry = rsqrt_geometry(config.unit_bits);
  const int product_bits = 2 * (config.vector_bits + 1);
  const std::int64_t per_segment = std::int64_t{1} << geometry.offset_bits();
  Extreme extreme = units(config, {{largest, largest, largest}});
  std::vector<IntVec> vectors;
  std::mt19937_64 random(26);
  const std::int64_t end = std::int64_t{1} << geometry.input_bits;
  for (std::int64_t t = end / 4; t < end; ++t) {
    const std::int64_t in_segment = (t >= end / 2 ? t : 2 * t) % per_segment;
    if (in_segment > 2 && in_segment < per_segment - 2) continue;
    // S >= 4^P, shifted by two places less, has T up to three quarters of its range.
    bool hit = false;
    for (int high = 0; high < 2; ++high)
      for (int attempt = 0, hits = 0; attempt < 200 && hits < 2; ++attempt) {
        const int shift = product_bits + 2 * high - geometry.input_bits;
        if (shift < 0) break;
        const std::int64_t s = (t << shift) + std::int64_t(random() >> (64 - std::max(shift, 1)));
        const IntVec v = random_vector(s, largest, random);
        const std::int64_t sum = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        const bool top_bit = std::max({v[0], v[1], v[2]}) > largest / 2;
        if (!top_bit || (sum >> product_bits != 0) != (high != 0) || sum >> shift != t) continue;
        vectors.push_back(v);
        ++hits;
        hit = true;
      }
    extreme.measure(hit ? 0 : 1e9, fmt::format("T = {} not reached", t));
  }
  measure_units(extreme, config, vectors);
  return extreme;
}

Extreme axes(const Config& config) {
  const std::int64_t largest = largest_of(config);
  std::vector<IntVec> vectors;
  for (std::int64_t m = 1; m <= largest; m += m < 64 ? 1 : std::max(largest / 160, std::int64_t{1}))
    for (std::size_t e = 0; e < 3; ++e) {
      IntVec v{};
      v[e] = m;
      vectors.push_back(v);
      vectors.push_back(negated(v));
    }
  return units(config, vectors, 0);
}

// n(-v) = -n(v), because the magnitude is rounded: ties go away from zero on both sides.
Extreme ties(const Config& config) {
  const std::int64_t largest = largest_of(config);
  Extreme extreme;
  extreme.unit = "ulp of s1.F";
  std::mt19937 random(28);
  std::uniform_int_distribution<std::int64_t> component(-largest, largest);
  Stimulus stimulus(config);
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

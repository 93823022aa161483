// normalize: x y z, then the unit vector in Q1.30 and in Q1.14, or `undef`. rsqrt: x, then 2^40 / sqrt(x).
#include <fmt/format.h>

#include <cmath>

#include "golden/pixel/rsqrt.h"
#include "sim/vectors/vectors.h"

namespace wrinkle {
namespace {

using IntVec = std::array<std::int64_t, 3>;

// A vector for the core, and the unit vector that is expected of it.
struct Case {
  IntVec vector;
  std::array<double, 3> unit;
};

// One fragment tests three cases: they are its N, L and H.
Stimulus stimulus_of(const Config& config, const std::vector<Case>& cases) {
  Stimulus stimulus(config);
  stimulus.add_draw({});
  for (std::size_t i = 0; i < cases.size(); i += 3)
    stimulus.add_vectors(cases[i].vector, cases[std::min(i + 1, cases.size() - 1)].vector,
                         cases[std::min(i + 2, cases.size() - 1)].vector);
  return stimulus;
}

// 2^15 does not fit 16 bits, so -2^15 counts as -(2^15 - 1). That turns the vector by at most 2^-15.
double allowed(const Config& config, const Case& c) {
  const bool saturates = c.vector[0] == -32768 || c.vector[1] == -32768 || c.vector[2] == -32768;
  return 1 + (saturates ? std::ldexp(1.0, config.unit_bits - 15) : 0);
}

VectorScore score(const std::string& engine, const Stimulus& stimulus, const std::vector<Case>& cases,
                  const std::vector<FragmentValues>& fragments) {
  VectorScore result{.engine = engine};
  const double one = std::ldexp(1.0, stimulus.config().unit_bits);
  const std::size_t columns[] = {stimulus.index("normalize", "n"), stimulus.index("normalize", "l"),
                                 stimulus.index("normalize", "h")};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    double worst = i / 3 < fragments.size() ? 0 : NAN;
    for (std::size_t e = 0; e < 3 && i / 3 < fragments.size(); ++e)
      worst = std::max(worst, std::abs(double(fragments[i / 3][columns[i % 3]][e]) - one * cases[i].unit[e]));
    result.measure(
        worst, allowed(stimulus.config(), cases[i]),
        fmt::format("({}, {}, {}): off by {:.3f}", cases[i].vector[0], cases[i].vector[1], cases[i].vector[2], worst));
  }
  return result;
}

VectorReport check(VectorKind kind, const Config& config, const std::vector<Case>& cases, const BenchOptions* rtl) {
  const Stimulus stimulus = stimulus_of(config, cases);
  VectorReport report{kind, "ulp of s1.F", 1, {score("golden", stimulus, cases, stimulus.golden())}};
  if (rtl) report.scores.push_back(score("rtl", stimulus, cases, rtl_values(stimulus, *rtl)));
  return report;
}

// x as a sum of three squares of 16-bit numbers; false where there is none (x = 4^a (8 b + 7), or x too large).
bool three_squares(std::int64_t x, IntVec& v) {
  std::int64_t odd = x;
  while (odd > 0 && odd % 4 == 0) odd /= 4;
  if (odd % 8 == 7) return false;
  for (std::int64_t a = std::min<std::int64_t>(std::int64_t(isqrt(std::uint64_t(x))), 32767); 3 * a * a >= x && a > 0;
       --a) {
    const std::int64_t rest = x - a * a;
    for (auto b = std::min<std::int64_t>(std::int64_t(isqrt(std::uint64_t(rest))), a); 2 * b * b >= rest; --b) {
      const std::int64_t c = std::int64_t(isqrt(std::uint64_t(rest - b * b)));
      if (c * c == rest - b * b) {
        v = {a, b, c};
        return true;
      }
      if (b == 0) break;
    }
  }
  return false;
}

// The table alone, for every x: relative error in ulp of s1.F, of which half an ulp is allowed to it.
VectorScore score_table(const Config& config, const std::vector<std::pair<std::int64_t, double>>& roots) {
  VectorScore result{.engine = "golden, table"};
  const RsqrtGeometry& geometry = rsqrt_geometry(config.unit_bits);
  const std::vector<Segment> table = rsqrt_table(geometry);
  for (const auto& [x, root] : roots) {
    // t = x 4^-k in [1/4, 1); 1/sqrt(x) = r 2^-k.
    int k = 0;
    while ((x >> (2 * k)) != 0) ++k;
    const auto t = static_cast<std::int64_t>(std::floor(std::ldexp(double(x), geometry.input_bits - 2 * k)));
    const double r = std::ldexp(double(rsqrt(geometry, table, t)), -geometry.output_bits - k);
    const double error = std::abs(r / root - 1) * std::ldexp(1.0, config.unit_bits);
    result.measure(error, 0.5, fmt::format("1/sqrt({}): {} instead of {}", x, r, root));
  }
  return result;
}

}  // namespace

VectorReport check_normalize(const std::filesystem::path& path, std::span<const VectorLine> lines, const Config& config,
                             const BenchOptions* rtl) {
  std::vector<Case> cases;
  for (const VectorLine& line : lines) {
    Case next{{whole(path, line, 0), whole(path, line, 1), whole(path, line, 2)}, {}};
    for (std::size_t e = 0; e < 3 && line.words.size() > 4; ++e)
      next.unit[e] = std::ldexp(double(whole(path, line, 3 + e)), -30);
    cases.push_back(next);
  }
  return check(VectorKind::kNormalize, config, cases, rtl);
}

VectorReport check_rsqrt(const std::filesystem::path& path, std::span<const VectorLine> lines, const Config& config,
                         const BenchOptions* rtl) {
  std::vector<std::pair<std::int64_t, double>> roots;
  std::vector<Case> cases;
  for (const VectorLine& line : lines) {
    const std::int64_t x = whole(path, line, 0);
    const double root = std::ldexp(double(whole(path, line, 1)), -40);
    roots.push_back({x, root});
    IntVec v;
    if (three_squares(x, v)) cases.push_back({v, {double(v[0]) * root, double(v[1]) * root, double(v[2]) * root}});
  }
  VectorReport report = check(VectorKind::kRsqrt, config, cases, rtl);
  report.scores.insert(report.scores.begin(), score_table(config, roots));
  return report;
}

}  // namespace wrinkle

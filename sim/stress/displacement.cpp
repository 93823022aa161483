// Entries 56 and 57: Pu x Pv, Pv x N and N x Pu of every scale, and slopes from nothing to all.
#include <fmt/format.h>

#include <cmath>
#include <random>

#include "golden/datapath/datapaths.h"
#include "sim/stress/catalogue.h"

namespace wrinkle {
namespace {

Config blinn_config() {
  Config config;
  config.datapath = static_cast<int>(Datapath::kBlinn);
  return config;
}

// The widths of Fig. 2 are those of the configuration `blinn`, which differs from `standard` only in its datapath.
Extreme drawn_with_standard() {
  Extreme extreme;
  extreme.unreachable = "fig. 2 is drawn with the widths of `blinn`, by the run of `standard`";
  return extreme;
}

DrawState bumped_state(int texture) {
  DrawState state;
  state.bump = state.textured = true;
  state.texture = texture;
  return state;
}

// One texel with the codes of fu and fv.
Texture slopes(std::uint64_t u, std::uint64_t v) {
  Texture texture;
  texture.components = 2;
  texture.levels = {{u | v << 8}};
  return texture;
}

Vec3 perturbed_normal(const Stimulus& stimulus, const FragmentValues& fragment) {
  return {stimulus.real(fragment, "perturb", "n", 0), stimulus.real(fragment, "perturb", "n", 1),
          stimulus.real(fragment, "perturb", "n", 2)};
}

// One draw has |Pu| and |Pv| from 2^-12 to 2^12, and directions of Pu and Pv that are only 2^-6 apart. Since each
// triangle has an exponent of its own, N' keeps its precision everywhere, and nothing wraps.
Extreme scales_of_the_surface(const Config& asked) {
  if (asked != Config{}) return drawn_with_standard();
  Extreme extreme;
  extreme.unit = "radians";
  // docs/numerics.md; Pv x N and N x Pu lie across Pu x Pv, which is no shorter here, so that nothing cancels.
  const Config config = blinn_config();
  extreme.bound = 6 * std::sqrt(3.0) * std::ldexp(1.0, -config.wide_bits);
  Stimulus stimulus(config);
  stimulus.add_draw(bumped_state(stimulus.add_texture(slopes(192, 64))));  // fu = 1/2, fv = -1/2
  std::mt19937_64 random(56);
  const auto real = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  std::vector<Vec3> expected;
  for (int i = 0; i < 600; ++i) {
    const double size_u = std::exp2(real(-12, 12)), size_v = std::exp2(real(-12, 12));
    const Vec3 T = normalize({real(-1, 1), real(-1, 1), 0.2}), side = normalize(cross(T, Vec3{real(-1, 1), 0.3, 1}));
    const double apart = std::exp2(real(-6, 0));
    const Vec3 Pu = size_u * T, Pv = size_v * normalize(T + apart * side);
    const Vec3 area = cross(Pu, Pv), N = normalize(area);
    // Slopes of the bump as large as those of the surface.
    const double scale = length(area) / std::max(size_u, size_v);
    ScreenVertex vertex;
    vertex.frame[0] = area, vertex.frame[1] = scale * cross(Pv, N), vertex.frame[2] = scale * cross(N, Pu);
    expected.push_back(normalize(vertex.frame[0] - 0.5 * vertex.frame[1] + 0.5 * vertex.frame[2]));
    stimulus.add(screen_triangle({{{0, 0}, {700, 0}, {0, 700}}}, vertex), 8, 8);
  }
  std::vector<std::uint32_t> owners;
  const std::vector<FragmentValues> fragments = stimulus.golden(owners);
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    const Vec3 got = normalize(perturbed_normal(stimulus, fragments[i]));
    extreme.measure(length(got - expected[owners[i]]), fmt::format("triangle {}", owners[i]));
  }
  extreme.stimuli.push_back(std::move(stimulus));
  return extreme;
}

// D grows code by code from 0 to a thousand times |Pu x Pv|. N' turns from Pu x Pv to D without a jump.
Extreme bumps_from_nothing_to_all(const Config& asked) {
  if (asked != Config{}) return drawn_with_standard();
  Extreme extreme;
  extreme.unit = "ulp";
  extreme.bound = 2;  // one of the normalizer, and as much for the rounding of N'
  const Config config = blinn_config();
  Stimulus stimulus(config);
  std::vector<Vec3> expected;
  for (const double height : {1.0, 0.1, 1e-3}) {
    for (std::uint64_t code = 0; code < 256; ++code) {
      stimulus.add_draw(bumped_state(stimulus.add_texture(slopes(code, 255 - code))));
      ScreenVertex vertex;
      vertex.frame[0] = {0, 0, 0.9 * height}, vertex.frame[1] = {0.9, 0, 0}, vertex.frame[2] = {0, 0.9, 0};
      const double u = (double(code) - 128) / 128, v = (127 - double(code)) / 128;
      expected.push_back(normalize({-u, -v, height}));
      stimulus.add(screen_triangle({{{0, 0}, {300, 0}, {0, 300}}}, vertex), 4, 4);
    }
  }
  std::vector<std::uint32_t> owners;
  const std::vector<FragmentValues> fragments = stimulus.golden(owners);
  const double one = std::ldexp(1.0, config.unit_bits);
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    const Vec3& want = expected[owners[i]];
    const auto n = [&](std::size_t k) { return stimulus.real(fragments[i], "normalize", "n", k); };
    const double error = std::max({std::abs(n(0) - want.x), std::abs(n(1) - want.y), std::abs(n(2) - want.z)});
    extreme.measure(error * one, fmt::format("draw {}", owners[i]));
  }
  extreme.stimuli.push_back(std::move(stimulus));
  return extreme;
}

}  // namespace

std::vector<ExtremeEntry> displacement_extremes() {
  return {
      {56, "fig. 2: |Pu|, |Pv| from 2^-12 to 2^12 in a draw", "", scales_of_the_surface},
      {57, "fig. 2: bumps from nothing to all", "", bumps_from_nothing_to_all},
  };
}

}  // namespace wrinkle

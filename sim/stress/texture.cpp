// Entries 21 and 39 to 47: texture addresses and filters against a filter in real numbers; the perspective division.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "sim/stress/catalogue.h"

namespace wrinkle {
namespace {

Texture random_texture(int log2_size, int levels, unsigned seed) {
  std::mt19937 random(seed);
  Texture texture{.log2_width = log2_size, .log2_height = log2_size};
  for (int level = 0; level < levels; ++level) {
    auto& texels = texture.levels.emplace_back(std::size_t(texture.width(level)) * std::size_t(texture.height(level)));
    for (auto& texel : texels) texel = random() & 0xffffff;
  }
  return texture;
}

Texture texture_of(int log2_size, std::vector<std::vector<std::uint64_t>> levels) {
  return {.log2_width = log2_size, .log2_height = log2_size, .levels = std::move(levels)};
}

std::uint64_t grey(std::uint64_t code) { return code | code << 8 | code << 16; }

int wrapped(Wrap wrap, int i, int size) {
  if (wrap == Wrap::kClamp) return std::clamp(i, 0, size - 1);
  const int period = wrap == Wrap::kMirror ? 2 * size : size;
  const int k = ((i % period) + period) % period;
  return k < size ? k : period - 1 - k;
}

double bilinear(const Texture& texture, Wrap wrap, int level, double u, double v, std::size_t component) {
  const int w = texture.width(level), h = texture.height(level);
  const double x = u * w - 0.5, y = v * h - 0.5;
  const int i = int(std::floor(x)), j = int(std::floor(y));
  const auto code = [&](int a, int b) {
    const std::size_t at = std::size_t(wrapped(wrap, b, h)) * std::size_t(w) + std::size_t(wrapped(wrap, a, w));
    return double((texture.levels[std::size_t(level)][at] >> (8 * component)) & 255);
  };
  const double fx = x - i, fy = y - j;
  return (1 - fy) * ((1 - fx) * code(i, j) + fx * code(i + 1, j)) +
         fy * ((1 - fx) * code(i, j + 1) + fx * code(i + 1, j + 1));
}

// The texel normal that real numbers give, full scale as the hardware has it.
double filtered(const Texture& texture, Wrap wrap, double u, double v, double lod, std::size_t component) {
  const double level = std::clamp(lod, 0.0, double(texture.max_level()));
  const int a = int(std::floor(level)), b = std::min(a + 1, texture.max_level());
  const double f = level - a;
  const double code =
      (1 - f) * bilinear(texture, wrap, a, u, v, component) + f * bilinear(texture, wrap, b, u, v, component);
  return (2 * code - 255) / 256;
}

// Coordinates that the weights hold exactly leave only the rounding to s1.V; else a weight is off by half a step.
double filter_bound(const Config& config, bool exact_weights) {
  return 0.5 +
         (exact_weights ? 0 : 2 * 255.0 * std::ldexp(1.0, config.vector_bits - config.texel_bits - config.weight_bits));
}

struct Probe {
  std::int64_t u, v;  // LSB of u
  int lod;            // in 1/2^LB
};

struct TextureTest {
  Extreme extreme;
  Stimulus stimulus{stress_config()};

  explicit TextureTest(double bound) {
    extreme.unit = "LSB of s1.V";
    extreme.bound = bound;
  }

  // Draws probes of one texture and wrap mode; `add` may follow `add`.
  void add(const Texture& texture, Wrap wrap, const std::vector<Probe>& probes) {
    DrawState state;
    state.bump = state.textured = true;
    state.wrap_u = state.wrap_v = wrap;
    state.texture = stimulus.add_texture(texture);
    stimulus.add_draw(state);
    for (const Probe& probe : probes) {
      TriangleWords words = stimulus.row(int(drawn_.size()) % 1024, int(drawn_.size()) / 1024);
      stimulus.set(words, Component::kU, probe.u);
      stimulus.set(words, Component::kV, probe.v);
      stimulus.set(words, Component::kLz, 1024);
      stimulus.set(words, Component::kHz, 1024);
      words.lod = probe.lod;
      stimulus.add(words);
      drawn_.push_back({state.texture, wrap, probe});
    }
  }

  Extreme finish() {
    const Config& config = stimulus.config();
    const auto fragments = stimulus.golden();
    for (std::size_t i = 0; i < fragments.size(); ++i) {
      const auto& [texture, wrap, probe] = drawn_[i];
      for (std::size_t e = 0; e < 3; ++e) {
        const double expected =
            filtered(stimulus.textures()[std::size_t(texture)], wrap, std::ldexp(double(probe.u), -config.uv_bits),
                     std::ldexp(double(probe.v), -config.uv_bits), std::ldexp(probe.lod, -config.lod_bits), e);
        const double got = stimulus.real(fragments[i], "texture", "n", e);
        extreme.measure(std::ldexp(std::abs(got - expected), config.vector_bits),
                        fmt::format("u {} v {} lod {} wrap {}", probe.u, probe.v, probe.lod, int(wrap)));
      }
    }
    extreme.measure(fragments.size() == drawn_.size() ? 0 : 1e9, "number of fragments");
    extreme.stimuli.push_back(std::move(stimulus));
    return std::move(extreme);
  }

 private:
  struct Drawn {
    int texture;
    Wrap wrap;
    Probe probe;
  };
  std::vector<Drawn> drawn_;
};

constexpr Wrap kWraps[] = {Wrap::kRepeat, Wrap::kClamp, Wrap::kMirror};
constexpr std::int64_t kOne = 1 << 18;  // one repeat, in LSB of u at `standard`

Extreme wrap_borders() {
  TextureTest test(filter_bound(stress_config(), false));
  const Texture texture = random_texture(5, 6, 39);
  const std::int64_t texel = kOne / 32;
  std::vector<Probe> probes;
  for (std::int64_t border :
       {std::int64_t{0}, kOne - texel, kOne, -kOne, 2 * kOne, -texel, texel / 2, kOne - texel / 2})
    for (std::int64_t step : {-1, 0, 1})
      for (int lod : {0, 32, 80, 160}) probes.push_back({border + step, (border - step) / 2, lod});
  for (Wrap wrap : kWraps) test.add(texture, wrap, probes);
  return test.finish();
}

// The address uses the low bits alone: every repeat gives what the one about zero gives.
Extreme repeats() {
  Extreme extreme;
  extreme.unit = "LSB of s1.V";
  const std::int64_t end = std::int64_t{1} << (stress_config().uv_integer_bits - 1);
  TextureTest test(0);
  std::vector<Probe> probes;
  std::mt19937 random(40);
  for (int i = 0; i < 20; ++i) {
    const std::int64_t u = random() % kOne, v = random() % kOne;
    for (std::int64_t k : {std::int64_t{0}, -end, end - 1, -end + 1})
      probes.push_back({u + k * kOne, v - (k + 1) * kOne, int(i % 3) * 48});
  }
  test.add(random_texture(5, 6, 41), Wrap::kRepeat, probes);
  const auto fragments = test.stimulus.golden();
  const std::size_t n = test.stimulus.index("texture", "n");
  for (std::size_t i = 0; i < fragments.size(); ++i)
    for (std::size_t e = 0; e < 3; ++e)
      extreme.measure(double(std::abs(fragments[i][n][e] - fragments[i / 4 * 4][n][e])), fmt::format("probe {}", i));
  extreme.stimuli.push_back(std::move(test.stimulus));
  return extreme;
}

Extreme smallest() {
  TextureTest test(filter_bound(stress_config(), false));
  std::vector<Probe> probes;
  for (std::int64_t u : {-3 * kOne, -kOne / 3, std::int64_t{-1}, std::int64_t{0}, kOne / 2, kOne - 1, 3 * kOne + 7})
    for (int lod : {0, 31, 32, 511}) probes.push_back({u, kOne - u, lod});
  for (Wrap wrap : kWraps) {
    test.add(random_texture(0, 1, 41), wrap, probes);
    test.add(random_texture(5, 6, 42), wrap, {{kOne / 7, kOne / 3, 160}, {-kOne / 7, kOne / 3, 511}});
  }
  return test.finish();
}

// Weights sum to exactly one: a constant texture comes back exactly, at every fraction.
Extreme constant() {
  TextureTest test(0);
  std::vector<Probe> probes;
  for (int i = 0; i < 300; ++i) probes.push_back({kOne / 32 * 5 + i * 32 - 32, kOne / 16 + i * 7, i % 160});
  for (std::uint64_t code : {0, 1, 128, 255}) {
    std::vector<std::vector<std::uint64_t>> levels;
    for (int level = 0; level <= 5; ++level) levels.emplace_back(std::size_t(1) << (2 * (5 - level)), grey(code));
    test.add(texture_of(5, levels), Wrap::kRepeat, probes);
  }
  return test.finish();
}

Extreme lod_ends() {
  TextureTest test(filter_bound(stress_config(), true));
  std::vector<Probe> probes;
  for (int lod = 0; lod < 512; ++lod)
    if (lod % 32 <= 1 || lod % 32 == 31) probes.push_back({kOne / 32 * 3, kOne / 32 * 9, lod});
  for (Wrap wrap : kWraps) test.add(random_texture(5, 6, 43), wrap, probes);
  return test.finish();
}

// n = exactly zero at the fragment: the flag, as in entry 19.
Extreme zero_normals(const Texture& texture, const std::vector<Probe>& probes) {
  TextureTest test(0);
  test.add(texture, Wrap::kRepeat, probes);
  const auto fragments = test.stimulus.golden();
  const std::size_t zero = test.stimulus.index("normalize", "zero"), diffuse = test.stimulus.index("light", "diffuse");
  for (const FragmentValues& f : fragments)
    test.extreme.measure(f[zero][0] != 1 || f[diffuse][0] != 0 ? 1e9 : 0, "zero flag");
  return test.finish();
}

Extreme opposed_levels() {
  std::vector<std::vector<std::uint64_t>> levels{
      std::vector<std::uint64_t>(16, 0x20e0ff), std::vector<std::uint64_t>(4, 0xdf1f00), {0x20e0ff}};
  return zero_normals(texture_of(2, levels), {{0, 0, 16}, {kOne / 3, kOne / 5, 48}, {-5, 17, 16}});
}

Extreme checker() {
  std::vector<std::uint64_t> texels;
  for (int i = 0; i < 16; ++i) texels.push_back((i + i / 4) % 2 == 0 ? 0x20e0ff : 0xdf1f00);
  // Corners of texels: all four weights alike.
  return zero_normals(texture_of(2, {texels}),
                      {{0, 0, 0}, {kOne / 4, kOne / 2, 0}, {-kOne / 4, kOne, 0}, {kOne / 2, -kOne / 4, 0}});
}

// (127, 128) codes average to zero; the code itself cannot be zero with `range`.
Extreme zero_texel() {
  return zero_normals(texture_of(1, {{grey(127), grey(128), grey(127), grey(128)}}),
                      {{kOne / 2, 0, 0}, {0, 3, 0}, {kOne, kOne / 4, 0}});
}

// u = uq / q over all of q: half an LSB, and the relative error of the reciprocal, 2^-R.
Extreme perspective_range() {
  Extreme extreme;
  extreme.unit = "LSB of u";
  const Config config = stress_config_perspective();
  const double reach = std::ldexp(1.0, config.uv_integer_bits - 1);
  extreme.bound = 0.5 + reach * std::ldexp(1.0, config.uv_bits - config.reciprocal_bits);
  Stimulus stimulus(config);
  DrawState state;
  state.bump = state.textured = true;
  state.texture = stimulus.add_texture(random_texture(5, 6, 46));
  stimulus.add_draw(state);
  std::mt19937 random(46);
  std::vector<std::pair<double, double>> expected;
  const std::int64_t top = std::int64_t{1} << config.q_bits;
  const auto add = [&](std::int64_t q, double u) {
    const std::int64_t uq = std::llround(u * std::ldexp(double(q), config.uv_bits - config.q_bits));
    const double exact = double(uq) / (double(q) / double(top));
    if (std::abs(exact) >= std::ldexp(reach, config.uv_bits) - 16) return;
    TriangleWords words = stimulus.row(int(expected.size()) % 1024, int(expected.size()) / 1024);
    stimulus.set(words, Component::kU, uq);
    stimulus.set(words, Component::kV, -uq);
    stimulus.set(words, Component::kQ, q);
    stimulus.add(words);
    expected.push_back({exact, -exact});
  };
  for (int bit = 0; bit <= config.q_bits; ++bit)
    for (std::int64_t d : {-1, 0, 1})
      for (double u : {-7.9, -1.0, 0.0, 0.3, 7.9}) {
        const std::int64_t q = (std::int64_t{1} << bit) + d;
        if (q >= 1 && q < top) add(q, u);
      }
  for (int i = 0; i < 2000; ++i)
    add(1 + std::int64_t(random() % unsigned(top - 1)), -8 + 16 * std::ldexp(double(random()), -32));
  const auto fragments = stimulus.golden();
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    extreme.measure(std::abs(double(fragments[i][stimulus.index("perspective", "u")][0]) - expected[i].first),
                    fmt::format("u {}", expected[i].first));
    extreme.measure(std::abs(double(fragments[i][stimulus.index("perspective", "v")][0]) - expected[i].second),
                    fmt::format("v {}", expected[i].second));
  }
  extreme.stimuli.push_back(std::move(stimulus));
  return extreme;
}

// Levels of detail at and beyond both ends of s5.LB: level 0 below, the last level above, without wrapping.
Extreme divergence() {
  const Config config = stress_config_perspective();
  Extreme extreme;
  extreme.unit = "LSB of s1.V";
  extreme.bound = filter_bound(config, false);
  Stimulus stimulus(config);
  DrawState state;
  state.bump = state.textured = true;
  const Texture texture = random_texture(5, 6, 47);
  state.texture = stimulus.add_texture(texture);
  stimulus.add_draw(state);
  const std::int64_t end = std::int64_t{1} << (5 + config.lod_bits);
  const std::vector<std::int64_t> lods{-end, -end + 1, -33, -1, 0, 1, 31, 159, 160, 161, 511, 512, end - 1};
  for (std::size_t i = 0; i < lods.size(); ++i) {
    TriangleWords words = stimulus.row(int(i), 0);
    stimulus.set(words, Component::kU, kOne / 5);
    stimulus.set(words, Component::kV, kOne / 3);
    stimulus.set(words, Component::kQ, 3 << (config.q_bits - 2));
    stimulus.set(words, Component::kLod, lods[i]);
    stimulus.add(words);
  }
  const auto fragments = stimulus.golden();
  for (std::size_t i = 0; i < fragments.size(); ++i)
    for (std::size_t e = 0; e < 3; ++e) {
      const FragmentValues& f = fragments[i];
      const double expected =
          filtered(texture, Wrap::kRepeat, stimulus.real(f, "perspective", "u"), stimulus.real(f, "perspective", "v"),
                   std::ldexp(double(lods[i]), -config.lod_bits), e);
      extreme.measure(std::ldexp(std::abs(stimulus.real(f, "texture", "n", e) - expected), config.vector_bits),
                      fmt::format("lod {}", lods[i]));
    }
  extreme.stimuli.push_back(std::move(stimulus));
  return extreme;
}

}  // namespace

std::vector<ExtremeEntry> texture_extremes() {
  return {{21, "zero vector from the texture", "", zero_texel},
          {39, "u, v at -1 LSB, 0, the last texel, the size", "", wrap_borders},
          {40, "repeats to the ends of u", "", repeats},
          {41, "texture of 1 by 1, smallest level", "", smallest},
          {42, "weights sum to one: constant texture", "", constant},
          {43, "level of detail at whole numbers and past the end", "", lod_ends},
          {44, "two opposed levels: exact zero", "", opposed_levels},
          {45, "checker of opposed texels: exact zero", "", checker},
          {46, "1/w from 2^-Q to 1", "", perspective_range},
          {47, "level of detail past both ends", "", divergence}};
}

}  // namespace wrinkle

// Entries 21, 39 to 45 and 47: texture addresses and filters against a filter in real numbers.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "sim/stress/catalogue.h"
#include "tb/random_texels.h"

namespace wrinkle {
namespace {

// Texel words of the configuration: T bits a component, base colour where it has one.
Texture empty_texture(const Shape& config, int log2_size) {
  return {.log2_width = log2_size,
          .log2_height = log2_size,
          .components = config.texels,
          .component_bits = config.texel_bits};
}

Texture random_texture(const Config& config, int log2_size, int levels, unsigned seed) {
  std::mt19937_64 random(seed);
  Texture texture = empty_texture(config, log2_size);
  for (int level = 0; level < levels; ++level)
    texture.levels.push_back(random_texels(texture, texture.width(level) * texture.height(level), random));
  return texture;
}

// Texels given by their low words, the others being 0.
Texture texture_of(const Config& config, int log2_size, const std::vector<std::vector<std::uint64_t>>& levels) {
  Texture texture = empty_texture(config, log2_size);
  for (const auto& low_words : levels) {
    auto& words = texture.levels.emplace_back();
    for (const std::uint64_t word : low_words) {
      words.push_back(word);
      words.resize(words.size() + std::size_t(texture.texel_words()) - 1);
    }
  }
  return texture;
}

// The same code in all three components of the normal.
std::uint64_t grey(const Config& config, std::uint64_t code) {
  return code | code << config.texel_bits | code << (2 * config.texel_bits);
}

// A texel and the one that is its opposite under `range`, 2c - (2^T - 1).
std::uint64_t some_texel(const Config& config) {
  const std::uint64_t most = (std::uint64_t{1} << config.texel_bits) - 1;
  return most | (most * 7 / 8) << config.texel_bits | (most / 8) << (2 * config.texel_bits);
}
std::uint64_t opposed_texel(const Config& config) {
  return some_texel(config) ^ ((std::uint64_t{1} << (3 * config.texel_bits)) - 1);
}

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
    return double(texture.code(texture.levels[std::size_t(level)], at, int(component)));
  };
  const double fx = x - i, fy = y - j;
  return (1 - fy) * ((1 - fx) * code(i, j) + fx * code(i + 1, j)) +
         fy * ((1 - fx) * code(i, j + 1) + fx * code(i + 1, j + 1));
}

// The normal of the texel in real numbers, with the full scale of the hardware.
double filtered(const Texture& texture, Wrap wrap, double u, double v, double lod, std::size_t component) {
  const double level = std::clamp(lod, 0.0, double(texture.max_level()));
  const int a = int(std::floor(level)), b = std::min(a + 1, texture.max_level());
  const double f = level - a;
  const double code =
      (1 - f) * bilinear(texture, wrap, a, u, v, component) + f * bilinear(texture, wrap, b, u, v, component);
  return std::ldexp(2 * code + 1, -texture.component_bits) - 1;
}

// Half an LSB of rounding to s1.V, and 2^(1-B) of full scale where weights are rounded. docs/numerics.md, "texture".
double filter_bound(const Config& config, bool exact_weights) {
  return 0.5 + (exact_weights ? 0 : std::ldexp(1.0, config.vector_bits + 1 - config.weight_bits));
}

// One level of detail in LSB.
int lod_one(const Shape& config) { return 1 << config.lod_fraction_bits; }

struct Probe {
  std::int64_t u, v;  // LSB of u
  int lod;            // LSB of 4.LB
};

struct TextureTest {
  Extreme extreme;
  Stimulus stimulus;

  TextureTest(const Config& config, double bound) : stimulus(stress_affine(config)) {
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
      stimulus.set(words, "u", 0, probe.u);
      stimulus.set(words, "v", 0, probe.v);
      stimulus.set(words, "l", 2, vector_one(stimulus.config()));
      stimulus.set(words, "h", 2, vector_one(stimulus.config()));
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
        const double expected = filtered(
            stimulus.textures()[std::size_t(texture)], wrap, std::ldexp(double(probe.u), -config.uv_bits),
            std::ldexp(double(probe.v), -config.uv_bits), std::ldexp(probe.lod, -Shape(config).lod_fraction_bits), e);
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

Extreme wrap_borders(const Config& config) {
  const std::int64_t one = repeat_one(config);
  TextureTest test(config, filter_bound(config, false));
  const Texture texture = random_texture(config, 5, 6, 39);
  const std::int64_t texel = one / 32;
  std::vector<Probe> probes;
  for (std::int64_t border : {std::int64_t{0}, one - texel, one, -one, 2 * one, -texel, texel / 2, one - texel / 2})
    for (std::int64_t step : {-1, 0, 1})
      for (int lod : {0, lod_one(config), lod_one(config) * 5 / 2, 5 * lod_one(config)})
        probes.push_back({border + step, (border - step) / 2, lod});
  for (Wrap wrap : kWraps) test.add(texture, wrap, probes);
  return test.finish();
}

// Addresses use the low bits alone, so every repeat that the format of u holds gives the same texels as the one at
// zero.
Extreme repeats(const Config& config) {
  Extreme extreme;
  extreme.unit = "LSB of s1.V";
  const std::int64_t one = repeat_one(config), end = std::int64_t{1} << (config.uv_integer_bits - 1);
  TextureTest test(config, 0);
  std::vector<Probe> probes;
  std::mt19937 random(40);
  for (int i = 0; i < 20; ++i) {
    const std::int64_t u = random() % one, v = random() % one;
    for (std::int64_t k : {std::int64_t{0}, -end, end - 1, -end + 1})
      probes.push_back({u + k * one, v - (k + 1) * one, i % 3 * lod_one(config) * 3 / 2});
  }
  test.add(random_texture(config, 5, 6, 41), Wrap::kRepeat, probes);
  const auto fragments = test.stimulus.golden();
  const std::size_t n = test.stimulus.index("texture", "n");
  for (std::size_t i = 0; i < fragments.size(); ++i)
    for (std::size_t e = 0; e < 3; ++e)
      extreme.measure(double(std::abs(fragments[i][n][e] - fragments[i / 4 * 4][n][e])), fmt::format("probe {}", i));
  extreme.stimuli.push_back(std::move(test.stimulus));
  return extreme;
}

// 2^15 repeats fit no format (UI <= 10). Set-up takes whole repeats off, so the picture is that at zero.
Extreme far_repeats(const Config& config) {
  Extreme extreme;
  extreme.unit = "fragments";
  std::vector<FragmentValues> near;
  for (double shift : {0.0, 32768.0, -32768.0}) {
    Stimulus stimulus(config);
    DrawState state;
    state.bump = state.textured = true;
    state.texture = stimulus.add_texture(random_texture(config, 5, 6, 48));
    stimulus.add_draw(state);
    ScreenTriangle triangle = screen_triangle({{{100, 90}, {8000, 700}, {300, 7900}}}, {});
    const Vec2 uv[] = {{0.125, 0.25}, {1.5, 0.375}, {0.25, 1.75}};
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.v[i].N = triangle.v[i].L = triangle.v[i].H = {0, 0, 1};
      triangle.v[i].uv = {uv[i].x + shift, uv[i].y - shift};
    }
    stimulus.add(triangle, 32, 32);
    const auto fragments = stimulus.golden();
    if (shift == 0) near = fragments;
    extreme.measure(std::abs(double(fragments.size()) - double(near.size())), "number of fragments");
    for (std::size_t i = 0; i < std::min(fragments.size(), near.size()); ++i)
      extreme.measure(fragments[i] != near[i], fmt::format("fragment {}, {} repeats away", i, shift));
    extreme.stimuli.push_back(std::move(stimulus));
  }
  return extreme;
}

Extreme smallest(const Config& config) {
  TextureTest test(config, filter_bound(config, false));
  const std::int64_t one = repeat_one(config);
  const int level = lod_one(config);
  std::vector<Probe> probes;
  for (std::int64_t u : {-3 * one, -one / 3, std::int64_t{-1}, std::int64_t{0}, one / 2, one - 1, 3 * one + 7})
    for (int lod : {0, level - 1, level, 16 * level - 1}) probes.push_back({u, one - u, lod});
  for (Wrap wrap : kWraps) {
    test.add(random_texture(config, 0, 1, 41), wrap, probes);
    test.add(random_texture(config, 5, 6, 42), wrap,
             {{one / 7, one / 3, 5 * level}, {-one / 7, one / 3, 16 * level - 1}});
  }
  return test.finish();
}

// The weights sum to exactly one, so a constant texture comes out exactly, at every fraction.
Extreme constant(const Config& config) {
  TextureTest test(config, 0);
  const std::int64_t one = repeat_one(config);
  std::vector<Probe> probes;
  for (int i = 0; i < 300; ++i)
    probes.push_back({one / 32 * 5 + one * (i - 1) / 8192, one / 16 + i * 7, i % (5 * lod_one(config))});
  const std::uint64_t most = (std::uint64_t{1} << config.texel_bits) - 1;
  for (std::uint64_t code : {std::uint64_t{0}, std::uint64_t{1}, most / 2 + 1, most}) {
    std::vector<std::vector<std::uint64_t>> levels;
    for (int level = 0; level <= 5; ++level)
      levels.emplace_back(std::size_t(1) << (2 * (5 - level)), grey(config, code));
    test.add(texture_of(config, 5, levels), Wrap::kRepeat, probes);
  }
  return test.finish();
}

// u and v are on the weights' own grid at every level, so that only the rounding to s1.V is left.
Extreme lod_ends(const Config& config) {
  TextureTest test(config, filter_bound(config, true));
  const std::int64_t one = repeat_one(config);
  const int level = lod_one(config);
  std::vector<Probe> probes;
  for (int lod = 0; lod < 16 * level; ++lod)
    if (lod % level <= 1 || lod % level == level - 1) probes.push_back({one / 8 * 3, one / 8 * 5, lod});
  for (Wrap wrap : kWraps) test.add(random_texture(config, 5, 6, 43), wrap, probes);
  return test.finish();
}

// n is exactly zero at the fragment, so the flag is set, as in entry 19.
Extreme zero_normals(const Config& config, const Texture& texture, const std::vector<Probe>& probes) {
  TextureTest test(config, 0);
  test.add(texture, Wrap::kRepeat, probes);
  const auto fragments = test.stimulus.golden();
  const std::size_t zero = test.stimulus.index("normalize", "zero"), diffuse = test.stimulus.index("light", "diffuse");
  for (const FragmentValues& f : fragments)
    test.extreme.measure(f[zero][0] != 1 || f[diffuse][0] != 0 ? 1e9 : 0, "zero flag");
  return test.finish();
}

Extreme opposed_levels(const Config& config) {
  if (Shape(config).trilinear == 0) return {.unreachable = "one level at a time without trilinear filtering"};
  const std::uint64_t one_way = some_texel(config), other = opposed_texel(config);
  const std::int64_t one = repeat_one(config);
  const int half = lod_one(config) / 2;
  return zero_normals(
      config,
      texture_of(config, 2, {std::vector<std::uint64_t>(16, one_way), std::vector<std::uint64_t>(4, other), {one_way}}),
      {{0, 0, half}, {one / 3, one / 5, 3 * half}, {-5, 17, half}});
}

Extreme checker(const Config& config) {
  const std::int64_t one = repeat_one(config);
  std::vector<std::uint64_t> texels;
  for (int i = 0; i < 16; ++i) texels.push_back((i + i / 4) % 2 == 0 ? some_texel(config) : opposed_texel(config));
  // At the corners of texels all four weights are the same.
  return zero_normals(config, texture_of(config, 2, {texels}),
                      {{0, 0, 0}, {one / 4, one / 2, 0}, {-one / 4, one, 0}, {one / 2, -one / 4, 0}});
}

// The two codes beside the middle average to zero; no code is zero itself under `range`.
Extreme zero_texel(const Config& config) {
  const std::int64_t one = repeat_one(config);
  const std::uint64_t above = std::uint64_t{1} << (config.texel_bits - 1);
  const std::uint64_t a = grey(config, above - 1), b = grey(config, above);
  return zero_normals(config, texture_of(config, 1, {{a, b, a, b}}), {{one / 2, 0, 0}, {0, 3, 0}, {one, one / 4, 0}});
}

// Levels of detail at and beyond both ends of s5.LB: level 0 below, the last level above, without wrapping.
Extreme divergence(const Config& named) {
  const Config config = stress_perspective(named);
  Extreme extreme;
  extreme.unit = "LSB of s1.V";
  extreme.bound = filter_bound(config, false);
  Stimulus stimulus(config);
  DrawState state;
  state.bump = state.textured = true;
  const Texture texture = random_texture(config, 5, 6, 47);
  state.texture = stimulus.add_texture(texture);
  stimulus.add_draw(state);
  const std::int64_t one = repeat_one(config), level = lod_one(config), end = 32 * level;
  const std::vector<std::int64_t> lods{
      -end,      -end + 1,      -level - 1,     -1,         0,      1, level - 1, 5 * level - 1,
      5 * level, 5 * level + 1, 16 * level - 1, 16 * level, end - 1};
  for (std::size_t i = 0; i < lods.size(); ++i) {
    TriangleWords words = stimulus.row(int(i), 0);
    stimulus.set(words, "u", 0, one / 5);
    stimulus.set(words, "v", 0, one / 3);
    stimulus.set(words, "q", 0, 3 << (config.q_bits - 2));
    stimulus.set(words, "lod", 0, lods[i]);
    stimulus.add(words);
  }
  const auto fragments = stimulus.golden();
  for (std::size_t i = 0; i < fragments.size(); ++i)
    for (std::size_t e = 0; e < 3; ++e) {
      const FragmentValues& f = fragments[i];
      const double expected =
          filtered(texture, Wrap::kRepeat, stimulus.real(f, "perspective", "u"), stimulus.real(f, "perspective", "v"),
                   std::ldexp(double(lods[i]), -Shape(config).lod_fraction_bits), e);
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
          {40, "repeats +-2^15, through set-up", "", far_repeats},
          {41, "texture of 1 by 1, smallest level", "", smallest},
          {42, "weights sum to one: constant texture", "", constant},
          {43, "level of detail at whole numbers, past the end", "", lod_ends},
          {44, "two opposed levels: exact zero", "", opposed_levels},
          {45, "checker of opposed texels: exact zero", "", checker},
          {47, "level of detail past both ends", "", divergence}};
}

}  // namespace wrinkle

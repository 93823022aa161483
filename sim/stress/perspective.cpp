// Entry 46: the perspective division, from one LSB of 1/w to all of it.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <random>

#include "golden/vertex/camera.h"
#include "golden/vertex/scene.h"
#include "sim/stress/catalogue.h"

namespace wrinkle {
namespace {

Texture one_texel(const Shape& config) {
  Texture texture{.components = config.texels, .component_bits = config.texel_bits};
  texture.levels.emplace_back(std::size_t(texture.texel_words()));
  return texture;
}

// u = uq / q for every q. It is off by half an LSB and by the relative error of the reciprocal, 2^-R.
Extreme perspective_range(const Config& named) {
  Extreme extreme;
  extreme.unit = "LSB of u";
  const Config config = stress_perspective(named);
  const double reach = std::ldexp(1.0, config.uv_integer_bits - 1);
  extreme.bound = 0.5 + reach * std::ldexp(1.0, config.uv_bits - config.reciprocal_bits);
  Stimulus stimulus(config);
  DrawState state;
  state.bump = state.textured = true;
  state.texture = stimulus.add_texture(one_texel(config));
  stimulus.add_draw(state);
  std::mt19937 random(46);
  std::vector<std::pair<double, double>> expected;
  const std::int64_t top = std::int64_t{1} << config.q_bits;
  const auto add = [&](std::int64_t q, double u) {
    const std::int64_t uq = std::llround(u * std::ldexp(double(q), config.uv_bits - config.q_bits));
    const double exact = double(uq) / (double(q) / double(top));
    if (std::abs(exact) >= std::ldexp(reach, config.uv_bits) - extreme.bound - 1) return;
    TriangleWords words = stimulus.row(int(expected.size()) % 1024, int(expected.size()) / 1024);
    stimulus.set(words, "u", 0, uq);
    stimulus.set(words, "v", 0, -uq);
    stimulus.set(words, "q", 0, q);
    stimulus.add(words);
    expected.push_back({exact, -exact});
  };
  for (int bit = 0; bit <= config.q_bits; ++bit)
    for (std::int64_t d : {-1, 0, 1})
      for (double u : {-0.99 * reach, -1.0, 0.0, 0.3, 0.99 * reach}) {
        const std::int64_t q = (std::int64_t{1} << bit) + d;
        if (q >= 1 && q < top) add(q, u);
      }
  for (int i = 0; i < 2000; ++i)
    add(1 + std::int64_t(random() % unsigned(top - 1)), reach * (2 * std::ldexp(double(random()), -32) - 1));
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

Stimulus bump_mapped(const Config& config) {
  Stimulus stimulus(config);
  DrawState state;
  state.bump = state.textured = true;
  state.texture = stimulus.add_texture(one_texel(config));
  stimulus.add_draw(state);
  return stimulus;
}

constexpr int kSide = 64;

// Corners within the screen, u and v within (-1/2, 1/2): set-up takes nothing off.
ScreenTriangle random_triangle(std::mt19937& random) {
  const auto real = [&](double low, double high) { return low + (high - low) * std::ldexp(double(random()), -32); };
  ScreenTriangle triangle;
  for (ScreenVertex& v : triangle.v) {
    v.x = int(real(0, kSide * 256));
    v.y = int(real(0, kSide * 256));
    v.N = v.L = v.H = {0, 0, 1};
    v.uv = {real(-0.5, 0.5), real(-0.5, 0.5)};
  }
  return triangle;
}

// With the same 1/w at every corner the picture is that of the path without division, but for rounding: 1/w is at most
// 1 - 2^-Q, so u/w is rounded differently from u at the corners, in the steps, and by the division.
Extreme equal_w(const Config& named) {
  Extreme extreme;
  extreme.unit = "LSB of u";
  const Config divided = stress_perspective(named), affine = stress_affine(named);
  extreme.bound = 2 * (drift_bound(divided, 2 * kSide) + 0.5) + 0.5 +
                  0.5 * std::ldexp(1.0, divided.uv_bits - divided.reciprocal_bits);
  Stimulus one = bump_mapped(affine), other = bump_mapped(divided);
  std::mt19937 random(46);
  for (int i = 0; i < 60; ++i) {
    ScreenTriangle triangle = random_triangle(random);
    for (ScreenVertex& v : triangle.v) v.q = std::ldexp(1.0 + i, -30 + i);
    one.add(triangle, kSide, kSide);
    other.add(triangle, kSide, kSide);
  }
  const auto a = one.golden(), b = other.golden();
  extreme.measure(a.size() == b.size() ? 0 : 1e9, "number of fragments");
  for (const char* name : {"u", "v"})
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
      extreme.measure(
          std::abs(double(a[i][one.index("interpolate", name)][0] - b[i][other.index("perspective", name)][0])),
          fmt::format("{} of fragment {}", name, i));
  extreme.stimuli = {one, other};
  return extreme;
}

// w of the corners as 1 to 2^15. With q off by e_q and uq by e_u, their quotient is off by (e_u + |u| e_q) / (q - e_q).
Extreme ratio_of_w(const Config& named) {
  Extreme extreme;
  extreme.unit = "of the bound";
  extreme.bound = 1;
  const Config config = stress_perspective(named);
  const double uv_one = double(repeat_one(config)), q_one = std::ldexp(1.0, config.q_bits);
  const double e = drift_bound(config, 2 * kSide) + 0.5;  // and the rounding of the corner
  std::mt19937 random(15);
  Stimulus stimulus = bump_mapped(config);
  std::vector<ScreenTriangle> triangles;
  for (int i = 0; i < 60; ++i) {
    ScreenTriangle triangle = random_triangle(random);
    triangle.v[std::size_t(i % 3)].q = std::ldexp(1.0, -15);
    if (i % 2 == 0) triangle.v[std::size_t((i + 1) % 3)].q = std::ldexp(1.0, -15);
    stimulus.add(triangle, kSide, kSide);
    triangles.push_back(triangle);
  }
  stimulus.each_golden([&](const FragmentValues& f, std::uint32_t owner) {
    const auto& v = triangles[owner].v;
    const double x = 256 * double(f[stimulus.index("scan", "x")][0]) + 128;
    const double y = 256 * double(f[stimulus.index("scan", "y")][0]) + 128;
    const auto area = [&](std::size_t a, std::size_t b) {
      return (v[a].x - x) * (v[b].y - y) - (v[a].y - y) * (v[b].x - x);
    };
    const double weights[] = {area(1, 2), area(2, 0), area(0, 1)};
    double q = 0, uq = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double share = weights[i] / (weights[0] + weights[1] + weights[2]);
      q += share * v[i].q;
      uq += share * v[i].q * v[i].uv.x;
    }
    const double u = uq / q, e_q = (e + 1) / q_one;  // set-up scales q to 1 - 2^-Q: one LSB more
    const double got = stimulus.real(f, "perspective", "u");
    if (q <= 2 * e_q) return;
    const double bound = (e / uv_one + std::abs(u) * e_q + std::abs(uq) / q_one) / (q - e_q) +
                         std::ldexp(std::abs(got), -config.reciprocal_bits) + 0.5 / uv_one;
    extreme.measure(std::abs(got - u) / bound, fmt::format("triangle {}, 1/w {}", owner, q));
  });
  extreme.stimuli.push_back(std::move(stimulus));
  return extreme;
}

// Corners behind the eye are cut off before set-up, and set-up refuses what is not a positive number.
Extreme behind_the_eye(const Config& named) {
  Extreme extreme;
  extreme.unit = "triangles";
  const Config config = stress_perspective(named);
  Stimulus stimulus = bump_mapped(config);
  for (double q :
       {0.0, -0.0, -1.0, -1e-300, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    std::mt19937 random(3);
    ScreenTriangle triangle = random_triangle(random);
    triangle.v[1].q = q;
    bool refused = false;
    try {
      stimulus.add(triangle, kSide, kSide);
    } catch (const std::invalid_argument&) {
      refused = true;
    }
    extreme.measure(!refused, fmt::format("1/w = {}", q));
  }
  Scene scene;
  scene.width = scene.height = kSide;
  scene.camera.perspective = true;
  scene.camera.world_to_eye = look_at({0, 1, 0}, {0, 0.8, -1}, {0, 1, 0});
  Object object;
  // A floor that continues behind the eye.
  for (auto [x, z] : {std::pair{-9, 9}, {9, 9}, {9, -9}, {-9, -9}})
    object.mesh.vertices.push_back(
        {.P = {double(x), 0, double(z)}, .N = {0, 1, 0}, .T = {1, 0, 0}, .uv = {}, .parameter = {}});
  object.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.objects.push_back(object);
  const Frame frame = build_frame(config, scene);
  Stimulus floor(config);
  for (const Draw& draw : frame.draws) {
    floor.add_draw(draw.state);
    for (const ScreenTriangle& triangle : draw.triangles) {
      for (const ScreenVertex& v : triangle.v)
        extreme.measure(!(v.q > 0 && v.q <= 10.001), fmt::format("1/w = {}", v.q));
      floor.add(triangle, frame.width, frame.height);
    }
  }
  extreme.measure(floor.golden().empty(), "nothing drawn");
  extreme.stimuli.push_back(std::move(floor));
  return extreme;
}

}  // namespace

std::vector<ExtremeEntry> perspective_extremes() {
  return {{46, "1/w from 2^-Q to 1 - 2^-Q", "", perspective_range},
          {46, "w equal at the corners: as without division", "", equal_w},
          {46, "w of the corners as 1 to 2^15", "", ratio_of_w},
          {46, "w at and below zero: never gets to the datapath", "", behind_the_eye}};
}

}  // namespace wrinkle

#include "sim/random_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace wrinkle {
namespace {

using Generator = std::mt19937_64;

// Portable, unlike the distributions of the standard library: the same frame from every compiler.
std::int64_t between(Generator& random, std::int64_t low, std::int64_t high) {
  return low + std::int64_t(random() % std::uint64_t(high - low + 1));
}
double real(Generator& random, double low, double high) {
  return low + (high - low) * std::ldexp(double(random() >> 11), -53);
}
Vec3 direction(Generator& random) {
  Vec3 v;
  do v = {real(random, -1, 1), real(random, -1, 1), real(random, -1, 1)};
  while (dot(v, v) > 1);
  return v;
}

Texture random_texture(const Config& config, Generator& random) {
  Texture texture;
  texture.log2_width = int(between(random, 0, 6));
  texture.log2_height = int(between(random, 0, 6));
  texture.components = config.texel_components();
  texture.component_bits = config.texel_bits;
  const int bits = texture.components * texture.component_bits;
  const int levels = int(between(random, 0, std::max(texture.log2_width, texture.log2_height)));
  for (int level = 0; level <= levels; ++level) {
    auto& texels = texture.levels.emplace_back(std::size_t(texture.width(level)) * std::size_t(texture.height(level)));
    for (auto& texel : texels) texel = bits == 64 ? random() : random() & ((std::uint64_t{1} << bits) - 1);
  }
  return texture;
}

DrawState random_state(const Config& config, int textures, Generator& random) {
  DrawState state;
  state.bump = config.has_bump() && between(random, 0, 3) != 0;
  state.textured = config.has_texture() && (state.bump || between(random, 0, 1) != 0);
  state.shadow = between(random, 0, 1) != 0;
  state.wrap_u = Wrap(between(random, 0, 2));
  state.wrap_v = Wrap(between(random, 0, 2));
  state.texture = int(between(random, 0, textures - 1));
  for (Vec3* colour : {&state.material.ambient, &state.material.diffuse, &state.material.specular})
    *colour = {real(random, 0, 1), real(random, 0, 1), real(random, 0, 1)};
  const auto k = between(random, -1, config.specular_squarings);
  state.material.exponent = k < 0 ? 0 : 1 << k;
  return state;
}

// A point on the sub-pixel grid, up to half a screen off it; a quarter of them on pixel centres or corners.
std::array<std::int32_t, 2> random_point(const Config& config, const Frame& frame, Generator& random) {
  const std::int64_t one = std::int64_t{1} << config.subpixel_bits;
  std::int64_t x = between(random, -frame.width / 2, 3 * frame.width / 2) * one;
  std::int64_t y = between(random, -frame.height / 2, 3 * frame.height / 2) * one;
  const std::int64_t kind = between(random, 0, 7);
  if (kind == 0) return {std::int32_t(x), std::int32_t(y)};
  if (kind == 1) return {std::int32_t(x + one / 2), std::int32_t(y + one / 2)};
  return {std::int32_t(x + between(random, 0, one - 1)), std::int32_t(y + between(random, 0, one - 1))};
}

ScreenTriangle random_triangle(const Config& config, const Frame& frame, Generator& random) {
  ScreenTriangle triangle;
  const std::int64_t one = std::int64_t{1} << config.subpixel_bits;
  const std::int64_t kind = between(random, 0, 3);  // anywhere, small, tiny, sliver
  const std::int64_t reach = kind == 2 ? 2 * one : 24 * one;
  for (std::size_t i = 0; i < 3; ++i) {
    ScreenVertex& v = triangle.v[i];
    const auto point = random_point(config, frame, random);
    v.x = point[0];
    v.y = point[1];
    if (i > 0 && (kind == 1 || kind == 2)) {
      v.x = triangle.v[0].x + std::int32_t(between(random, -reach, reach));
      v.y = triangle.v[0].y + std::int32_t(between(random, -reach, reach));
    } else if (i == 2 && kind == 3) {
      v.x = triangle.v[1].x + std::int32_t(between(random, -one, one));
      v.y = triangle.v[1].y + std::int32_t(between(random, -one, one));
    }
    v.z = real(random, 0, 1);
    v.q = real(random, 0.05, 1);
    v.uv = {real(random, -0.9, 0.9), real(random, -0.9, 0.9)};
    v.N = direction(random);
    v.L = direction(random);
    v.H = direction(random);
  }
  return triangle;
}

// Twice the area on the screen is at most this: what the random choice of sizes is steered by.
double area(const Config& config, const Frame& frame, const ScreenTriangle& t) {
  const double one = std::ldexp(1.0, config.subpixel_bits);
  const auto x = [&](std::size_t i) { return std::clamp(t.v[i].x / one, 0.0, double(frame.width)); };
  const auto y = [&](std::size_t i) { return std::clamp(t.v[i].y / one, 0.0, double(frame.height)); };
  return std::abs((x(1) - x(0)) * (y(2) - y(0)) - (y(1) - y(0)) * (x(2) - x(0))) / 2;
}

}  // namespace

Frame random_frame(const Config& config, std::uint64_t seed, std::uint64_t fragments) {
  Generator random(seed);
  Frame frame;
  frame.name = fmt::format("random seed {}", seed);
  frame.width = int(between(random, 1, std::min(256, config.screen_size())));
  frame.height = int(between(random, 1, std::min(256, config.screen_size())));
  if (config.has_texture())
    for (int i = 0; i < 4; ++i) frame.textures.push_back(random_texture(config, random));
  double expected = 0;
  std::uint32_t id = 0;
  do {
    Draw& draw = frame.draws.emplace_back();
    draw.state = random_state(config, 4, random);
    for (std::int64_t n = between(random, 0, 40); n > 0; --n) {
      draw.triangles.push_back(random_triangle(config, frame, random));
      draw.triangles.back().id = id++;
      expected += area(config, frame, draw.triangles.back());
    }
  } while (expected < double(fragments) && id < 200000);
  return frame;
}

}  // namespace wrinkle

#include "tb/random_frame.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "golden/triangle/corners.h"
#include "tb/random_config.h"
#include "tb/random_texels.h"
#include "tb/stall.h"

namespace wrinkle {
namespace {

Vec3 random_vector(Random& random) {
  if (random.below(16) == 0) {
    const double sign = random.below(2) == 0 ? 1 : -1;
    switch (random.below(4)) {
      case 0:
        return {};
      case 1:
        return {sign, 0, 0};
      case 2:
        return {0, sign, 0};
      default:
        return {0, 0, sign};
    }
  }
  // Mostly towards the viewer, so that most pixels are lit.
  const auto coordinate = [&] { return 2 * random.real() - 1; };
  return normalize({coordinate(), coordinate(), coordinate() + (random.below(4) != 0 ? 1 : 0)});
}

Vec3 random_unit_vector(Random& random) {
  Vec3 v;
  do v = random_vector(random);
  while (v == Vec3{});
  return v;
}

Texture random_texture(const Shape& config, Random& random) {
  Texture texture;
  texture.log2_width = random.between(0, 7);
  texture.log2_height = random.between(0, 7);
  texture.components = config.texels;
  texture.component_bits = config.texel_bits;
  const int complete = std::max(texture.log2_width, texture.log2_height) + 1;
  texture.levels.resize(static_cast<std::size_t>(random.between(1, complete)));
  for (int level = 0; level <= texture.max_level(); ++level) {
    const int count = texture.width(level) * texture.height(level);
    texture.levels[static_cast<std::size_t>(level)] = random_texels(texture, count, [&] { return random.next(); });
  }
  return texture;
}

Vec3 random_colour(Random& random) { return {random.real(), random.real(), random.real()}; }

DrawState random_state(const Config& config, const Frame& frame, Random& random) {
  DrawState state;
  const bool texels = !frame.textures.empty();
  state.bump = Shape(config).bump_components != 0 && texels && random.below(4) != 0;
  state.textured = state.bump || (Shape(config).tints != 0 && texels && random.below(2) != 0);
  state.shadow = config.self_shadow != 0 && random.below(4) != 0;
  state.wrap_u = static_cast<Wrap>(random.below(3));
  state.wrap_v = static_cast<Wrap>(random.below(3));
  if (texels) state.texture = static_cast<int>(random.below(static_cast<std::uint32_t>(frame.textures.size())));
  state.material.ambient = 0.3 * random_colour(random);
  state.material.diffuse = random_colour(random);
  state.material.specular = random_colour(random);
  const int k = random.between(-1, config.specular_squarings);
  state.material.exponent = k < 0 ? 0 : 1 << k;
  if (Shape(config).has_light_planes == 0) {
    state.L = random_unit_vector(random);
    state.H = random_unit_vector(random);
  }
  return state;
}

// Corners in pixels.
using Outline = std::array<Vec2, 3>;

Outline around(Vec2 centre, double size, Random& random) {
  Outline outline;
  for (Vec2& corner : outline) corner = centre + size * Vec2{random.real() - 0.5, random.real() - 0.5};
  return outline;
}

Outline random_outline(const Frame& frame, Random& random) {
  const double w = frame.width, h = frame.height, larger = std::max(w, h);
  const Vec2 inside{w * random.real(), h * random.real()};
  switch (random.below(10)) {
    case 0:  // below a pixel
      return around(inside, 1.5, random);
    case 1:
    case 2:
      return around(inside, 8, random);
    case 3:
    case 4:
    case 5:
      return around(inside, 64, random);
    case 6: {  // a sliver in any direction
      const Vec2 along{2 * larger * (random.real() - 0.5), 2 * larger * (random.real() - 0.5)};
      const Vec2 width{2 * random.real() / 8, 2 * random.real() / 8};
      return {inside, inside + along, inside + 0.5 * along + width};
    }
    case 7: {  // off the screen, or only just on it
      const Vec2 outside{w * (2.8 * random.real() - 0.9), h * (2.8 * random.real() - 0.9)};
      return around(outside, 0.5 * larger * random.real(), random);
    }
    case 8:
      return around({0.5 * w, 0.5 * h}, larger, random);
    default:  // up to the guard band
      return around({0.5 * w, 0.5 * h}, 3 * larger, random);
  }
}

std::int32_t snap(const Config& config, double pixels) {
  const double grid = std::ldexp(1.0, config.subpixel_bits);
  const double screen = grid * config.screen_size();
  const double snapped = std::floor(pixels * grid);
  return static_cast<std::int32_t>(std::clamp(snapped, -screen, 2 * screen - 1));
}

// Texture coordinates that fit the format: within its range, and moved by whole repeats where the texture repeats.
Vec2 random_uv(const Shape& config, double scale, Vec2 offset, Random& random) {
  const auto margin = static_cast<double>(interpolation_margin(config, config.uv_width) + 2);
  const double bound = scale * (std::ldexp(1.0, config.uv_integer_bits - 1) - std::ldexp(margin, -config.uv_bits));
  return Vec2{bound * (2 * random.real() - 1), bound * (2 * random.real() - 1)} + offset;
}

ScreenTriangle random_triangle(const Config& config, const DrawState& state, const Outline& outline, Random& random) {
  ScreenTriangle triangle;
  const Shape shape(config);
  const double uv_scale = std::exp2(-8 * random.real());
  const auto offset = [&](Wrap wrap) { return wrap == Wrap::kClamp ? 0.0 : 2.0 * random.between(-64, 64); };
  const Vec2 uv_offset{offset(state.wrap_u), offset(state.wrap_v)};
  for (std::size_t i = 0; i < 3; ++i) {
    ScreenVertex& vertex = triangle.v[i];
    vertex.x = snap(config, outline[i].x);
    vertex.y = snap(config, outline[i].y);
    vertex.z = random.real();
    vertex.q = config.perspective != 0 ? std::exp2(-10 * random.real() * random.real()) : 1;
    vertex.uv = random_uv(config, uv_scale, uv_offset, random);
    vertex.N = random_vector(random);
    vertex.L = random_vector(random);
    vertex.H = random_vector(random);
    if (Shape(config).frame_prepared == 0) continue;
    // Mostly a normal perturbed by less than its length.
    vertex.frame[0] = random_vector(random);
    const double scale = std::exp2(-3 * random.real());
    vertex.frame[1] = scale * random_vector(random);
    vertex.frame[2] = scale * random_vector(random);
  }
  if (random.below(16) == 0) triangle.v[1].N = -triangle.v[0].N;
  return triangle;
}

// Pixels of the part on the screen of the box around it, halved: near enough to know when there are enough.
double estimated_fragments(const Frame& frame, const Outline& outline) {
  const auto [left, right] = std::minmax({outline[0].x, outline[1].x, outline[2].x});
  const auto [top, bottom] = std::minmax({outline[0].y, outline[1].y, outline[2].y});
  const double w = std::min<double>(right, frame.width) - std::max(left, 0.0);
  const double h = std::min<double>(bottom, frame.height) - std::max(top, 0.0);
  return 1 + 0.4 * std::max(w, 0.0) * std::max(h, 0.0);
}

}  // namespace

Frame random_frame(const Config& config, const RandomFrame& wish) {
  Random random(wish.seed);
  Frame frame;
  frame.name = "random " + std::to_string(wish.seed);
  frame.width = wish.width != 0 ? wish.width : config.screen_size();
  frame.height = wish.height != 0 ? wish.height : config.screen_size();
  if (Shape(config).textured != 0) {
    for (int i = 0; i < 4; ++i) frame.textures.push_back(random_texture(config, random));
  }
  std::uint32_t id = 0;
  for (int i = 0; i < wish.draws; ++i) {
    Draw draw;
    draw.state = random_state(config, frame, random);
    for (double left = wish.fragments / wish.draws; left > 0;) {
      Outline outline = random_outline(frame, random);
      // The budget goes to many triangles, not to one.
      for (int retry = 0; retry < 20 && estimated_fragments(frame, outline) > 1000 + left; ++retry) {
        outline = random_outline(frame, random);
      }
      draw.triangles.push_back(random_triangle(config, draw.state, outline, random));
      draw.triangles.back().id = id++;
      left -= estimated_fragments(frame, outline);
    }
    frame.draws.push_back(std::move(draw));
  }
  return frame;
}

Config random_config(std::uint64_t seed) {
  Random random(seed);
  return random_config([&](int low, int high) { return random.between(low, high); }, 10);
}

}  // namespace wrinkle

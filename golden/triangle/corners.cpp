#include "golden/triangle/corners.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>

namespace wrinkle {
namespace {

void check_guard_band(const Shape& config, std::int32_t coordinate) {
  const std::int64_t screen = std::int64_t{1} << (config.screen_bits + config.subpixel_bits);
  if (coordinate < -screen || coordinate >= 2 * screen) {
    throw std::invalid_argument("a vertex lies outside the guard band");
  }
}

// The whole repeats to take off so that [low, high] is centred on zero. Ties leave [0, 1] where it is.
double whole_repeats(Wrap wrap, double low, double high) {
  const double centre = (low + high) / 2;
  switch (wrap) {
    case Wrap::kRepeat:
      return std::ceil(centre - 0.5);
    case Wrap::kMirror:
      return 2 * std::ceil(centre / 2 - 0.5);
    case Wrap::kClamp:
      break;
  }
  return 0;
}

void reduce(const Shape& config, int wrap, const char* name, std::array<double, 3>& values) {
  if (!std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); })) {
    throw std::range_error(std::string("texture coordinate ") + name + " is not finite");
  }
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double repeats = whole_repeats(static_cast<Wrap>(wrap), *low, *high);
  const double bound = std::ldexp(1.0, config.uv_integer_bits - 1);
  const auto margin = interpolation_margin(config, config.uv_width);
  const double lowest = -bound + std::ldexp(static_cast<double>(margin), -config.uv_bits);
  const double highest = bound - std::ldexp(static_cast<double>(margin + 1), -config.uv_bits);
  if (*low - repeats < lowest || *high - repeats > highest) {
    throw std::range_error(
        std::string("texture coordinate ") + name + " spans " + std::to_string(*low) + " to " + std::to_string(*high) +
        " repeats over one triangle, which does not fit uv_integer_bits = " + std::to_string(config.uv_integer_bits));
  }
  for (double& value : values) value -= repeats;
}

double largest_q(const Corners& corners) {
  double largest = 0;
  for (const ScreenVertex* vertex : corners.v) {
    if (!(vertex->q > 0) || !std::isfinite(vertex->q)) throw std::invalid_argument("1/w is not positive and finite");
    largest = std::max(largest, vertex->q);
  }
  return largest;
}

constexpr double kSmallestVectorScale = 1.0 / 16;

std::array<Vec3, 3> scaled_by_q(const Shape& config, const Corners& corners, std::array<Vec3, 3> vectors,
                                int normalizer) {
  const bool any_length =
      normalizer != static_cast<int>(Normalizer::kNone) && normalizer != static_cast<int>(Normalizer::kNear);
  if (config.perspective == 0 || !any_length) return vectors;
  const double largest = largest_q(corners);
  for (std::size_t i = 0; i < 3; ++i) {
    vectors[i] = std::max(corners.v[i]->q / largest, kSmallestVectorScale) * vectors[i];
  }
  return vectors;
}

// By one power of two that brings the largest of the triangle into [1/2, 1), or checked against the block of the draw.
void scale_to_block(const Shape& config, std::vector<std::array<Vec3, 3>>& frame) {
  double largest = 0;
  for (const auto& vectors : frame) {
    for (const Vec3& v : vectors) {
      if (!std::isfinite(v.x + v.y + v.z)) throw std::invalid_argument("a vector in the place of N is not finite");
      largest = std::max({largest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    }
  }
  if (config.block_exponent == static_cast<int>(BlockExponent::kDraw)) {
    if (largest > 1) throw std::invalid_argument("a vector in the place of N exceeds the block of its draw");
    return;
  }
  if (largest == 0) return;
  int exponent = 0;
  std::frexp(largest, &exponent);
  for (auto& vectors : frame) {
    for (Vec3& v : vectors) v = {std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent), std::ldexp(v.z, -exponent)};
  }
}

}  // namespace

std::int64_t interpolation_margin(const Shape& config, int width) {
  return std::int64_t{1} << std::min(std::max(config.screen_bits - config.guard_bits, 0), width - 3);
}

double depth_in_format(const Shape& config, double z) {
  const auto margin = static_cast<double>(interpolation_margin(config, config.depth_bits));
  const double codes = std::ldexp(1.0, config.depth_bits);
  return (margin + std::clamp(z, 0.0, 1.0) * (codes - 1 - 2 * margin)) / codes;
}

Corners sort_corners(const Shape& config, const ScreenTriangle& triangle) {
  for (const ScreenVertex& vertex : triangle.v) {
    check_guard_band(config, vertex.x);
    check_guard_band(config, vertex.y);
  }
  Corners corners{{&triangle.v[0], &triangle.v[1], &triangle.v[2]}};
  std::sort(corners.v.begin(), corners.v.end(),
            [](const ScreenVertex* a, const ScreenVertex* b) { return std::tie(a->y, a->x) < std::tie(b->y, b->x); });
  const std::int64_t dx1 = corners.v[1]->x - corners.v[0]->x, dy1 = corners.v[1]->y - corners.v[0]->y;
  const std::int64_t dx2 = corners.v[2]->x - corners.v[0]->x, dy2 = corners.v[2]->y - corners.v[0]->y;
  corners.area = dx1 * dy2 - dx2 * dy1;
  return corners;
}

TextureCorners texture_corners(const Shape& config, const Corners& corners, const DrawWords& draw) {
  TextureCorners texture;
  for (std::size_t i = 0; i < 3; ++i) {
    texture.u[i] = corners.v[i]->uv.x;
    texture.v[i] = corners.v[i]->uv.y;
  }
  reduce(config, draw.wrap_u, "u", texture.u);
  reduce(config, draw.wrap_v, "v", texture.v);
  if (config.perspective == 0) return texture;

  const double one = std::ldexp(1.0, config.q_bits);
  const auto margin = static_cast<double>(interpolation_margin(config, config.q_bits));
  const double largest = largest_q(corners);
  for (std::size_t i = 0; i < 3; ++i) {
    // A q below the margin could be carried below zero; it is some 2^-Q of the largest, far beyond the resolution.
    texture.q[i] = std::max(corners.v[i]->q / largest * (1 - margin / one), margin / one);
  }
  return texture;
}

std::array<Vec3, 3> vector_corners(const Shape& config, const Corners& corners, Vec3 ScreenVertex::*member,
                                   int normalizer) {
  return scaled_by_q(config, corners, {corners.v[0]->*member, corners.v[1]->*member, corners.v[2]->*member},
                     normalizer);
}

std::vector<std::array<Vec3, 3>> frame_corners(const Shape& config, const Corners& corners, const DrawWords& draw) {
  std::vector<std::array<Vec3, 3>> frame(static_cast<std::size_t>(config.frame_vectors));
  if (frame.empty()) return frame;
  if (!draw.bump || config.frame_prepared == 0) {
    frame[0] = vector_corners(config, corners, &ScreenVertex::N, config.normalizer_n);
    return frame;
  }
  const auto formats = frame_vectors(config);
  for (std::size_t i = 0; i < frame.size(); ++i) {
    auto& v = frame[i];
    v = scaled_by_q(config, corners, {corners.v[0]->frame[i], corners.v[1]->frame[i], corners.v[2]->frame[i]},
                    config.normalizer_n);
    if (formats[i].is_held) v.fill(1.0 / 3 * (v[0] + v[1] + v[2]));
  }
  if (config.frame_unbounded != 0) scale_to_block(config, frame);
  return frame;
}

}  // namespace wrinkle

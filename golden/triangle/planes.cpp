#include "golden/triangle/planes.h"

#include <cmath>
#include <stdexcept>

#include "golden/triangle/exact_division.h"
#include "golden/triangle/level_of_detail.h"

namespace wrinkle {
namespace {

using Values = std::array<double, 3>;

// The residue of a modulo 2^bits in two's complement.
std::int64_t wrap(Wide a, int bits) {
  const int unused = 64 - bits;
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) << unused) >> unused;
}

// Nearest multiple of 2^-fraction_bits, ties away from zero: odd, so that a mirrored triangle has mirrored values.
std::int64_t to_fixed(double value, int fraction_bits) {
  return static_cast<std::int64_t>(std::round(std::ldexp(value, fraction_bits)));
}

// The numerators of a plane's gradient per sub-pixel, over the denominator |area|.
struct Slope {
  Wide x, y;
};
Slope slope(const Corners& corners, const std::array<std::int64_t, 3>& a) {
  const auto& v = corners.v;
  const Wide dx1 = v[1]->x - v[0]->x, dy1 = v[1]->y - v[0]->y;
  const Wide dx2 = v[2]->x - v[0]->x, dy2 = v[2]->y - v[0]->y;
  const Wide a1 = a[1] - a[0], a2 = a[2] - a[0];
  const Wide sign = corners.area < 0 ? -1 : 1;
  return {sign * (a1 * dy2 - a2 * dy1), sign * (a2 * dx1 - a1 * dx2)};
}

std::int64_t denominator(const Corners& corners) { return corners.area < 0 ? -corners.area : corners.area; }

// Corner values of the components, exact doubles of the format's scale.
class Attributes {
 public:
  Attributes(const Shape& config, const Corners& corners, const DrawWords& draw) : config_(config), corners_(corners) {
    const std::vector<std::array<Vec3, 3>> frame = frame_corners(config, corners, draw);
    const Component first = config.frame_vectors == 1 ? Component::kNx : Component::kAx;
    for (std::size_t i = 0; i < frame.size(); ++i) {
      if (config.frame_unbounded == 0) expect_unit_length(frame[i]);
      put(static_cast<Component>(at(first) + 3 * i), frame[i]);
    }
    if (config.has_light_planes) {
      vector(Component::kLx, &ScreenVertex::L, config.normalizer_l);
      if (config.glossy) vector(Component::kHx, &ScreenVertex::H, config.third_normalizer);
    }
    for (std::size_t i = 0; i < 3; ++i) values_[at(Component::kZ)][i] = depth_in_format(config, corners.v[i]->z);
    // What no texel is fetched for need not fit.
    if (draw.textured) {
      const TextureCorners texture = texture_corners(config, corners, draw);
      values_[at(Component::kU)] = texture.u;
      values_[at(Component::kV)] = texture.v;
      values_[at(Component::kQ)] = texture.q;
    } else {
      values_[at(Component::kQ)].fill(1 - std::ldexp(1.0, -config.q_bits));
    }
  }
  const Values& operator[](Component component) const { return values_[at(component)]; }

 private:
  static std::size_t at(Component component) { return static_cast<std::size_t>(component); }

  void vector(Component x, Vec3 ScreenVertex::*member, int normalizer) {
    const std::array<Vec3, 3> vectors = vector_corners(config_, corners_, member, normalizer);
    expect_unit_length(vectors);
    put(x, vectors);
  }

  static void expect_unit_length(const std::array<Vec3, 3>& vectors) {
    for (const Vec3& value : vectors) {
      if (!(length(value) < 1.5)) throw std::invalid_argument("a vector at a vertex is not of unit length");
    }
  }

  void put(Component x, const std::array<Vec3, 3>& vectors) {
    for (std::size_t i = 0; i < 3; ++i) {
      values_[at(x)][i] = vectors[i].x;
      values_[at(x) + 1][i] = vectors[i].y;
      values_[at(x) + 2][i] = vectors[i].z;
    }
  }

  const Shape& config_;
  const Corners& corners_;
  std::array<Values, kComponents> values_{};
};

// With perspective u, v become u*q, v*q of the rounded q, so that the quotient is u, v at the corners; and the level of
// detail is a plane through its values at the corners.
void make_perspective(const Shape& config, const Corners& corners, const DrawWords& draw, const Attributes& attributes,
                      Planes& planes) {
  const auto plane = [&](Component component) -> Planes::Plane& {
    return planes.planes[static_cast<std::size_t>(component)];
  };
  const int uv_bits = config.uv_bits + config.guard_bits, q_bits = config.q_bits + config.guard_bits;
  for (std::size_t i = 0; i < 3; ++i) {
    const double q = std::ldexp(static_cast<double>(plane(Component::kQ).corner[i]), -q_bits);
    plane(Component::kU).corner[i] = to_fixed(attributes[Component::kU][i] * q, uv_bits);
    plane(Component::kV).corner[i] = to_fixed(attributes[Component::kV][i] * q, uv_bits);
  }
  const TextureCorners texture{attributes[Component::kU], attributes[Component::kV], attributes[Component::kQ]};
  for (std::size_t i = 0; i < 3; ++i) {
    const double rho_squared = texel_rate_squared_at(config, corners, texture, draw, i);
    plane(Component::kLod).corner[i] =
        level_of_detail(rho_squared, config.lod_fraction_bits + config.guard_bits, -kFarthestLevel, kFarthestLevel);
  }
}

}  // namespace

Planes make_planes(const Shape& config, const Corners& corners, const DrawWords& draw) {
  const Attributes attributes(config, corners, draw);
  const std::vector<ComponentFormat> formats = component_formats(config);
  Planes planes;
  for (const ComponentFormat& format : formats) {
    const Values& values = attributes[format.component];
    Planes::Plane& plane = planes.planes[static_cast<std::size_t>(format.component)];
    for (std::size_t i = 0; i < 3; ++i) {
      plane.corner[i] = to_fixed(values[i], format.fraction_bits + (format.is_constant ? 0 : config.guard_bits));
    }
  }
  if (config.textured && draw.textured) {
    if (config.perspective != 0) {
      make_perspective(config, corners, draw, attributes, planes);
    } else {
      const TextureCorners texture{attributes[Component::kU], attributes[Component::kV], attributes[Component::kQ]};
      const double rho_squared = texel_rate_squared(config, corners, texture, draw);
      planes.lod = static_cast<int>(level_of_detail(rho_squared, config.lod_fraction_bits, 0, draw.max_level));
    }
  }
  for (const ComponentFormat& format : formats) {
    if (format.is_constant) continue;
    Planes::Plane& plane = planes.planes[static_cast<std::size_t>(format.component)];
    const Slope per_subpixel = slope(corners, plane.corner);
    const Wide one = Wide{1} << config.subpixel_bits;
    const int bits = format.width + config.guard_bits;
    plane.dx = wrap(round_divide(per_subpixel.x * one, denominator(corners)), bits);
    plane.dy = wrap(round_divide(per_subpixel.y * one, denominator(corners)), bits);
  }
  return planes;
}

std::array<PlaneWords, kComponents> anchor(const Shape& config, const Corners& corners, const Planes& planes,
                                           bool mirror, int y, const EdgeWords& start) {
  const std::int64_t one = std::int64_t{1} << config.subpixel_bits;
  const std::int64_t x = mirror ? -1 - start.w : start.w;
  const Wide to_x = x * one + one / 2 - corners.v[0]->x, to_y = y * one + one / 2 - corners.v[0]->y;
  std::array<PlaneWords, kComponents> words{};
  for (const ComponentFormat& format : component_formats(config)) {
    const auto index = static_cast<std::size_t>(format.component);
    const Planes::Plane& plane = planes.planes[index];
    if (format.is_constant) {
      words[index].value = wrap(plane.corner[0], format.width);
      continue;
    }
    const int bits = format.width + config.guard_bits;
    const Slope per_subpixel = slope(corners, plane.corner);
    const Wide rise = round_divide(per_subpixel.x * to_x + per_subpixel.y * to_y, denominator(corners));
    words[index].value = wrap(plane.corner[0] + rise + (Wide{1} << (config.guard_bits - 1)), bits);
    words[index].dw = wrap(mirror ? -Wide{plane.dx} : Wide{plane.dx}, bits);
    words[index].row = wrap(Wide{plane.dy} + Wide{start.step} * words[index].dw, bits);
  }
  return words;
}

}  // namespace wrinkle

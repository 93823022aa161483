#include "golden/triangle/planes.h"

#include <algorithm>
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

void expect_unit_length(const std::array<Vec3, 3>& vectors) {
  for (const Vec3& value : vectors) {
    if (!(length(value) < 1.5)) throw std::invalid_argument("a vector at a vertex is not of unit length");
  }
}

// What the planes are laid through, by the names of values.def: exact doubles of the format's scale. The level of
// detail is not here, since it follows from the others.
struct Attributes {
  Attributes(const Shape& config, const Corners& corners, const DrawWords& draw)
      : frame(frame_corners(config, corners, draw)) {
    if (config.frame_unbounded == 0) std::for_each(frame.begin(), frame.end(), expect_unit_length);
    const auto unit_vector = [&](Vec3 ScreenVertex::*member, int normalizer) {
      const std::array<Vec3, 3> vectors = vector_corners(config, corners, member, normalizer);
      expect_unit_length(vectors);
      return vectors;
    };
    if (config.has_light_planes) {
      l = unit_vector(&ScreenVertex::L, config.normalizer_l);
      if (config.glossy) h = unit_vector(&ScreenVertex::H, config.third_normalizer);
    }
    for (std::size_t i = 0; i < 3; ++i) z[i] = depth_in_format(config, corners.v[i]->z);
    // What no texel is fetched for need not fit.
    if (draw.textured) {
      const TextureCorners texture = texture_corners(config, corners, draw);
      u = texture.u, v = texture.v, q = texture.q;
    } else {
      q.fill(1 - std::ldexp(1.0, -config.q_bits));
    }
  }
  TextureCorners texture() const { return {u, v, q}; }

  std::vector<std::array<Vec3, 3>> frame;
  std::array<Vec3, 3> l{}, h{};
  Values u{}, v{}, q{}, lod{}, z{};
};

void append(const Values& values, std::vector<Values>& list) { list.push_back(values); }
void append(const std::array<Vec3, 3>& a, std::vector<Values>& list) {
  list.push_back({a[0].x, a[1].x, a[2].x});
  list.push_back({a[0].y, a[1].y, a[2].y});
  list.push_back({a[0].z, a[1].z, a[2].z});
}
void append(const std::vector<std::array<Vec3, 3>>& vectors, std::vector<Values>& list) {
  for (const std::array<Vec3, 3>& a : vectors) append(a, list);
}

// In the order of plane_formats().
std::vector<Values> in_packet_order(const Shape& c, const Attributes& attributes) {
  std::vector<Values> list;
  list.reserve(PlanePlaces(c).count);
#define WRINKLE_FRAME(stage, name, reader) append(attributes.name, list);
#define WRINKLE_PLANE(name, elements, width, fraction_bits, is_signed, present, reader) \
  if (present) append(attributes.name, list);
#define WRINKLE_LEVEL(name, width, fraction_bits, present, reader) \
  if ((present) && c.divides != 0) append(attributes.name, list);
#include "golden/values.def"
  return list;
}

// With perspective u, v become u*q, v*q of the rounded q, so that the quotient is u, v at the corners; and the level of
// detail is a plane through its values at the corners.
void make_perspective(const Shape& config, const Corners& corners, const DrawWords& draw, const Attributes& attributes,
                      std::vector<Planes::Plane>& planes) {
  const PlanePlaces at(config);
  const int uv_bits = config.uv_bits + config.guard_bits, q_bits = config.q_bits + config.guard_bits;
  const TextureCorners texture = attributes.texture();
  for (std::size_t i = 0; i < 3; ++i) {
    const double q = std::ldexp(static_cast<double>(planes[at.q].corner[i]), -q_bits);
    planes[at.u].corner[i] = to_fixed(attributes.u[i] * q, uv_bits);
    planes[at.v].corner[i] = to_fixed(attributes.v[i] * q, uv_bits);
    const double rho_squared = texel_rate_squared_at(config, corners, texture, draw, i);
    planes[at.lod].corner[i] =
        level_of_detail(rho_squared, config.lod_fraction_bits + config.guard_bits, -kFarthestLevel, kFarthestLevel);
  }
}

void add_gradients(const Shape& config, const Corners& corners, const PlaneFormat& format, Planes::Plane& plane) {
  const Slope per_subpixel = slope(corners, plane.corner);
  const Wide one = Wide{1} << config.subpixel_bits;
  const int bits = format.width + config.guard_bits;
  plane.dx = wrap(round_divide(per_subpixel.x * one, denominator(corners)), bits);
  plane.dy = wrap(round_divide(per_subpixel.y * one, denominator(corners)), bits);
}

}  // namespace

Planes make_planes(const Shape& config, const Corners& corners, const DrawWords& draw) {
  const Attributes attributes(config, corners, draw);
  const std::vector<Values> values = in_packet_order(config, attributes);
  const std::vector<PlaneFormat> formats = plane_formats(config);
  Planes planes{std::vector<Planes::Plane>(formats.size())};
  for (std::size_t p = 0; p < formats.size(); ++p) {
    const int bits = formats[p].fraction_bits + (formats[p].is_held ? 0 : config.guard_bits);
    for (std::size_t i = 0; i < 3; ++i) planes.planes[p].corner[i] = to_fixed(values[p][i], bits);
  }
  if (config.textured && draw.textured) {
    if (config.divides != 0) {
      make_perspective(config, corners, draw, attributes, planes.planes);
    } else {
      const double rho_squared = texel_rate_squared(config, corners, attributes.texture(), draw);
      planes.lod = static_cast<int>(level_of_detail(rho_squared, config.lod_fraction_bits, 0, draw.max_level));
    }
  }
  for (std::size_t p = 0; p < formats.size(); ++p)
    if (!formats[p].is_held) add_gradients(config, corners, formats[p], planes.planes[p]);
  return planes;
}

void anchor(const Shape& config, const Corners& corners, const Planes& planes, TriangleWords& piece) {
  const std::int64_t one = std::int64_t{1} << config.subpixel_bits;
  const std::int64_t x = piece.mirror ? -1 - piece.start.w : piece.start.w;
  const Wide to_x = x * one + one / 2 - corners.v[0]->x, to_y = piece.y * one + one / 2 - corners.v[0]->y;
  std::size_t index = 0;
  for_each_plane(config, [&](const PlaneFormat& format) {
    const Planes::Plane& plane = planes.planes[index];
    PlaneWords& words = piece.planes[index++];
    if (format.is_held) {
      words.value = wrap(plane.corner[0], format.width);
      return;
    }
    const int bits = format.width + config.guard_bits;
    const Slope per_subpixel = slope(corners, plane.corner);
    const Wide rise = round_divide(per_subpixel.x * to_x + per_subpixel.y * to_y, denominator(corners));
    words.value = wrap(plane.corner[0] + rise + (Wide{1} << (config.guard_bits - 1)), bits);
    words.dw = wrap(piece.mirror ? -Wide{plane.dx} : Wide{plane.dx}, bits);
    words.row = wrap(Wide{plane.dy} + Wide{piece.start.step} * words.dw, bits);
  });
}

}  // namespace wrinkle

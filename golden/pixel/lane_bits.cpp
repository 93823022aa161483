#include "golden/pixel/lane_bits.h"

#include <algorithm>

#include "golden/pixel/compact_geometry.h"
#include "golden/pixel/reciprocal.h"
#include "golden/pixel/rsqrt.h"
#include "golden/triangle/plane_list.h"

namespace wrinkle {
namespace {

// Widest operand of each stage; the derivations are those of docs/numerics.md.

// Accumulators are modular: no bit is lost to a sign.
int interpolate_bits(const Shape& c) {
  int width = 0;
  for_each_plane(c, [&](const PlaneFormat& format) { width = std::max(width, format.width); });
  return width + c.guard_bits;
}

int perspective_bits(const Shape& c) {
  if (!c.divides) return 0;
  const ReciprocalGeometry g{c.q_bits, c.reciprocal_bits};
  const int table = g.output_bits + kReciprocalGuard + 2 + g.offset_bits();
  const int doubled_product = c.uv_width + c.reciprocal_bits + 2;
  return std::max(table, doubled_product);
}

int texture_bits(const Shape& c) {
  if (!c.textured) return 0;
  const int scaled_coordinate = c.uv_width + c.coordinate_shift + 1;
  const int doubled_code = c.texel_bits + c.filter_fraction_bits + 2;
  return std::max({scaled_coordinate, doubled_code, c.bump_width});
}

// One unit, for vectors in s1.V.
int unit_bits_of(const Shape& c, int vector_bits) {
  const RsqrtGeometry& g = rsqrt_geometry(c.unit_bits);
  const int magnitude = vector_bits + 1;
  const int sum = std::max(2 * magnitude + 3, g.input_bits + 1);
  const int table = g.output_bits + g.guard_bits + 2 + g.offset_bits();
  const int product = magnitude + g.output_bits + 2;
  const int bypass = std::max(vector_bits, c.unit_bits) + 3;
  return std::max({sum, table, product, bypass});
}

bool has_compact_unit(const Shape& c) {
  const auto is_compact = [](int normalizer) { return normalizer >= static_cast<int>(Normalizer::kCompact); };
  return is_compact(c.normalizer_n) || is_compact(c.normalizer_l) || is_compact(c.normalizer_h);
}

// One unit of the kinds `compact`, `lite` and `near`, of which the first is the widest.
int compact_unit_bits_of(const Shape& c, int vector_bits) {
  const CompactGeometry g = compact_geometry(Normalizer::kCompact, c.unit_bits, vector_bits);
  const int sum = 2 * g.magnitude_bits + 3;
  const int table = g.rsqrt.output_bits + g.rsqrt.guard_bits + 3 + g.rsqrt.offset_bits();
  const int product = g.magnitude_bits + g.rsqrt.output_bits + 2;
  return std::max({sum, table, product});
}

// V of the unit with the widest input.
int widest_unit_input_bits(const Shape& c) {
  const int sum_of_two = c.is(Lighting::kPixelHalfangle) ? c.unit_bits + 1 : 0;
  return std::max({c.vector_bits, c.normal_input_bits, sum_of_two});
}

int normalize_bits(const Shape& c) {
  const int vector_bits = widest_unit_input_bits(c);
  return std::max(unit_bits_of(c, vector_bits), has_compact_unit(c) ? compact_unit_bits_of(c, vector_bits) : 0);
}

int light_bits(const Shape& c) {
  const auto magnitude = [&](int normalizer) {
    return c.unit_bits + (normalizer == static_cast<int>(Normalizer::kNone) ? 1 : 0);
  };
  const int other =
      c.glossy ? std::max(magnitude(c.normalizer_l), magnitude(c.normalizer_h)) : magnitude(c.normalizer_l);
  const int dot = magnitude(c.normalizer_n) + other + 3;
  const int shift = c.dot_bits + 5;
  // 2 (N.L) (N.E) - L.E, each product of two factors up to 2^F.
  const int reflected = c.is(Lighting::kReflection) ? dot + 2 : 0;
  // Dot product below 4 by scales below 4; the product of two scales.
  const int deferred = c.normalizes_after ? std::max(2 * c.dot_bits + 6, 2 * c.scale_bits + 3) : 0;
  return std::max({dot, reflected, shift, deferred, 2 * c.dot_bits + 2, 2 * c.power_bits + 2});
}

int output_bits(const Shape& c) {
  const int with_decal = c.colour_bits + c.dot_bits + c.texel_bits + 3;
  const int with_gloss = c.power_bits + c.texel_bits + 2;
  return std::max(
      {2 * c.colour_bits + c.power_bits + 3, c.decal != 0 ? with_decal : 0, c.gloss_map != 0 ? with_gloss : 0});
}

}  // namespace

int widest_operand_bits(const Shape& config) {
  return std::max({interpolate_bits(config), perspective_bits(config), texture_bits(config),
                   config.perturb_operand_bits, normalize_bits(config), light_bits(config), output_bits(config)});
}

int lane_bits(const Shape& config) {
  // Factors that the pixel stages multiply as halves of a lane: m, r, and intensities up to 1.
  int magnitude = widest_unit_input_bits(config) + 1, root = rsqrt_geometry(config.unit_bits).output_bits + 1;
  if (has_compact_unit(config)) {
    magnitude = std::max(magnitude, config.unit_bits + 1);
    root = std::max(root, compact_rsqrt_geometry(config.unit_bits).output_bits + 1);
  }
  const int intensity = config.power_bits + 1, colour = config.colour_bits + 1;
  const int deferred = config.normalizes_after ? config.dot_bits + 2 : 0;
  const bool halves_fit = std::max({magnitude, root, intensity, colour, deferred}) <= 15;
  return widest_operand_bits(config) <= 32 && halves_fit ? 32 : 64;
}

}  // namespace wrinkle

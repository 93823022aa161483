#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

#include "golden/triangle/packet.h"

namespace wrinkle {
namespace {

std::array<int, 3> to_codes(const Shape& config, Vec3 colour) {
  const auto code = [&](double channel) {
    return static_cast<int>(std::round(std::ldexp(std::clamp(channel, 0.0, 1.0), config.colour_bits)));
  };
  const Vec3 channels = to_channels(config, colour);
  return {code(channels.x), code(channels.y), code(channels.z)};
}

// A unit vector, each component the nearest of s1.F.
std::array<int, 3> to_unit_codes(const Shape& config, Vec3 v) {
  if (!(std::abs(length(v) - 1) < 1e-6)) throw std::invalid_argument("a constant light vector is not of unit length");
  const auto code = [&](double x) { return static_cast<int>(std::round(std::ldexp(x, config.unit_bits))); };
  return {code(v.x), code(v.y), code(v.z)};
}

}  // namespace

Vec3 to_channels(const Shape& config, Vec3 colour) {
  if (config.count == 3) return colour;
  return {0.2126 * colour.x + 0.7152 * colour.y + 0.0722 * colour.z, 0, 0};
}

DrawWords quantise(const Shape& config, const DrawState& state, const std::vector<Texture>& textures) {
  DrawWords draw;
  draw.bump = state.bump && config.bump_components != 0;
  draw.textured = draw.bump || (state.textured && config.tints != 0);
  draw.shadow = state.shadow && config.self_shadow != static_cast<int>(SelfShadow::kOff);
  if (draw.textured) {
    if (state.texture < 0 || static_cast<std::size_t>(state.texture) >= textures.size() || state.texture >= 1 << 12) {
      throw std::invalid_argument("a draw names a texture that is not there");
    }
    const Texture& texture = textures[static_cast<std::size_t>(state.texture)];
    draw.texture = state.texture;
    draw.wrap_u = static_cast<int>(state.wrap_u);
    draw.wrap_v = static_cast<int>(state.wrap_v);
    draw.log2_width = texture.log2_width;
    draw.log2_height = texture.log2_height;
    draw.max_level = texture.max_level();
  }
  const Material& material = state.material;
  if (material.exponent < 0 ||
      (material.exponent > 0 && !std::has_single_bit(static_cast<unsigned>(material.exponent)))) {
    throw std::invalid_argument("a specular exponent is neither 0 nor a power of two");
  }
  draw.exponent_zero = material.exponent == 0;
  if (!draw.exponent_zero) {
    draw.squarings = std::min(std::countr_zero(static_cast<unsigned>(material.exponent)), config.specular_squarings);
  }
  if (!config.has_light_planes) {
    draw.l = to_unit_codes(config, state.L);
    if (config.glossy) draw.h = to_unit_codes(config, state.H);
  }
  draw.ambient = to_codes(config, material.ambient);
  draw.diffuse = to_codes(config, material.diffuse);
  draw.specular = to_codes(config, material.specular);
  return draw;
}

}  // namespace wrinkle

#include "golden/triangle/level_of_detail.h"

#include <algorithm>
#include <cmath>

#include "golden/triangle/exact_division.h"

namespace wrinkle {
namespace {

// Squared length of the gradients of u and v times the size of the texture: the values are differences to corner 0.
double larger_rate_squared(const Shape& config, const Corners& corners, const std::array<Vec2, 3>& uv,
                           const DrawWords& draw) {
  const auto& v = corners.v;
  const double dx1 = v[1]->x - v[0]->x, dy1 = v[1]->y - v[0]->y;
  const double dx2 = v[2]->x - v[0]->x, dy2 = v[2]->y - v[0]->y;
  const double per_pixel = std::ldexp(1.0, config.subpixel_bits) / static_cast<double>(corners.area);
  const double width = std::ldexp(per_pixel, draw.log2_width), height = std::ldexp(per_pixel, draw.log2_height);
  const Vec2 d1 = uv[1] - uv[0], d2 = uv[2] - uv[0];
  const double ux = (d1.x * dy2 - d2.x * dy1) * width, uy = (d2.x * dx1 - d1.x * dx2) * width;
  const double vx = (d1.y * dy2 - d2.y * dy1) * height, vy = (d2.y * dx1 - d1.y * dx2) * height;
  return std::max(ux * ux + vx * vx, uy * uy + vy * vy);
}

}  // namespace

double texel_rate_squared(const Shape& config, const Corners& corners, const TextureCorners& texture,
                          const DrawWords& draw) {
  std::array<Vec2, 3> uv;
  for (std::size_t j = 0; j < 3; ++j) uv[j] = {texture.u[j], texture.v[j]};
  return larger_rate_squared(config, corners, uv, draw);
}

double texel_rate_squared_at(const Shape& config, const Corners& corners, const TextureCorners& texture,
                             const DrawWords& draw, std::size_t i) {
  // u = sum(u_j q_j b_j) / sum(q_j b_j) with barycentric b, so that du at corner i is sum((u_j - u_i) q_j / q_i db_j).
  std::array<Vec2, 3> uv;
  for (std::size_t j = 0; j < 3; ++j) {
    const double weight = texture.q[j] / texture.q[i];
    uv[j] = {(texture.u[j] - texture.u[i]) * weight, (texture.v[j] - texture.v[i]) * weight};
  }
  return larger_rate_squared(config, corners, uv, draw);
}

std::int64_t log2_fixed(double x, int fraction_bits) {
  int exponent = 0;
  // m in [1, 2) with 63 fraction bits. Each squaring shifts log2(m) left by one bit; its integer part is the next
  // digit.
  auto m = static_cast<std::uint64_t>(std::ldexp(std::frexp(x, &exponent), 64));
  std::int64_t result = exponent - 1;
  for (int i = 0; i < fraction_bits; ++i) {
    const unsigned __int128 square = static_cast<unsigned __int128>(m) * m;
    const bool digit = (square >> 127) != 0;
    m = static_cast<std::uint64_t>(square >> (digit ? 64 : 63));
    result = 2 * result + (digit ? 1 : 0);
  }
  return result;
}

std::int64_t level_of_detail(double rho_squared, int fraction_bits, int lowest, int highest) {
  const std::int64_t low = std::int64_t{lowest} * (std::int64_t{1} << fraction_bits);
  const std::int64_t high = std::int64_t{highest} * (std::int64_t{1} << fraction_bits);
  if (!(rho_squared > 0)) return low;
  if (!std::isfinite(rho_squared)) return high;
  // Half the logarithm of the square, and half an LSB to round.
  return std::clamp((log2_fixed(rho_squared, fraction_bits) + 1) >> 1, low, high);
}

}  // namespace wrinkle

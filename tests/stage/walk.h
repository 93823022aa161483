// Random triangles through set-up and the golden machine, for the tests of scan and interpolate.
#pragma once

#include <map>

#include "golden/exact/interpolate.h"
#include "golden/exact/scan.h"
#include "golden/triangle/packet.h"
#include "tests/stage/support.h"

namespace wrinkle {

inline ScreenTriangle random_triangle(const Config& config, Random& random, int size) {
  ScreenTriangle triangle;
  const int grid = size << config.subpixel_bits;
  const auto unit = [&] { return std::uniform_real_distribution<double>(-1, 1)(random); };
  const int spread = static_cast<int>(uniform(random, 0, 2));
  const int cx = static_cast<int>(uniform(random, 0, grid - 1)), cy = static_cast<int>(uniform(random, 0, grid - 1));
  for (ScreenVertex& v : triangle.v) {
    const int reach = spread == 0 ? grid : grid >> (2 * spread);
    v.x = std::clamp(cx + static_cast<int>(uniform(random, -reach, reach)), 0, grid - 1);
    v.y = std::clamp(cy + static_cast<int>(uniform(random, -reach, reach)), 0, grid - 1);
    v.z = (unit() + 1) / 2;
    v.q = 1.5 + unit();
    v.uv = {unit() / 2, unit() / 2};
    v.N = normalize({unit(), unit(), 1});
    v.L = normalize({unit(), unit(), 1});
    v.H = normalize({unit(), unit(), 1});
    for (Vec3& w : v.frame) w = 0.9 * normalize({unit(), unit(), unit()});
  }
  return triangle;
}

// The words of one draw of one triangle; empty where it covers no pixel.
inline std::vector<std::uint64_t> packets_of(const Config& config, const ScreenTriangle& triangle,
                                             const DrawState& state, const std::vector<Texture>& textures, int size) {
  std::vector<std::uint64_t> words;
  encode(config, quantise(config, state, textures), words);
  for (const TriangleWords& packet : set_up(config, triangle, state, textures, size, size))
    encode(config, packet, words);
  return words;
}

}  // namespace wrinkle

#include "golden/texel/normal_map.h"

#include <algorithm>
#include <utility>

#include "golden/texel/bump.h"
#include "golden/texel/height.h"

namespace wrinkle {
namespace {

// normal_of(u, v, f_u, f_v) at every sample.
template <class Normal>
NormalMap from_gradients(const Grid<double>& height, Wraps wraps, const Normal& normal_of) {
  const Grid<Vec2> slopes = gradients(height, wraps);
  NormalMap map(height.width, height.height);
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const Vec2 f = slopes.at(x, y);
      map.at(x, y) = normal_of((x + 0.5) / map.width, 1 - (y + 0.5) / map.height, f.x, f.y);
    }
  }
  return map;
}

template <class Normals>
MipChain mips_of_heights(Grid<double> height, const Normals& normals) {
  MipChain chain{normals(height)};
  while (height.width > 1 || height.height > 1) {
    height = halve(height);
    chain.push_back(normals(height));
  }
  return chain;
}

}  // namespace

NormalMap normal_map(const Grid<double>& height, const Surface& surface, Wraps wraps) {
  return from_gradients(height, wraps, [&](double u, double v, double fu, double fv) {
    const SurfacePoint s = surface.at(u, v);
    return tangent_space_normal(s.Pu, s.Pv, fu, fv);
  });
}

NormalMap normal_map(const Grid<double>& height, double k, Wraps wraps) {
  return from_gradients(height, wraps,
                        [&](double, double, double fu, double fv) { return square_patch_normal(k, fu, fv); });
}

NormalMap out_of_tangent_space(const NormalMap& map, const Surface& surface) {
  NormalMap result(map.width, map.height);
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const SurfacePoint s = surface.at((x + 0.5) / map.width, 1 - (y + 0.5) / map.height);
      const Vec3 T = normalize(s.Pu - dot(s.Pu, s.N) * s.N);
      const Vec3 n = map.at(x, y);
      result.at(x, y) = normalize(n.x * T + n.y * cross(s.N, T) + n.z * s.N);
    }
  }
  return result;
}

NormalMap normal_map_from_image(const Grid<Vec3>& image, double scale) {
  NormalMap map(image.width, image.height);
  std::transform(image.samples.begin(), image.samples.end(), map.samples.begin(), [&](Vec3 c) {
    const Vec3 n = 2 * c - Vec3{1, 1, 1};
    return scale == 1 ? n : normalize(Vec3{scale * n.x, scale * n.y, n.z});
  });
  return map;
}

MipChain colour_mips(Grid<Vec3> level0) {
  MipChain chain{std::move(level0)};
  while (chain.back().width > 1 || chain.back().height > 1) chain.push_back(halve(chain.back()));
  return chain;
}

MipChain normal_mips(NormalMap level0) {
  MipChain chain{std::move(level0)};
  while (chain.back().width > 1 || chain.back().height > 1) {
    NormalMap next = halve(chain.back());
    for (Vec3& n : next.samples) n = normalize(n);
    chain.push_back(std::move(next));
  }
  return chain;
}

MipChain normal_mips(const Grid<double>& height, const Surface& surface, Wraps wraps) {
  return mips_of_heights(height, [&](const Grid<double>& h) { return normal_map(h, surface, wraps); });
}

MipChain normal_mips(const Grid<double>& height, double k, Wraps wraps) {
  return mips_of_heights(height, [&](const Grid<double>& h) { return normal_map(h, k, wraps); });
}

}  // namespace wrinkle

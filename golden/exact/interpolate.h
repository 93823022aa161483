// Twin of the stage `interpolate`: every component at a pixel centre, from barycentric weights.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "golden/datapath/datapath.h"
#include "golden/exact/scan.h"
#include "golden/triangle/level_of_detail.h"
#include "golden/vector.h"

namespace wrinkle::exact {

// Weights of the three corners, from the exact integer half-planes: right for the thinnest sliver.
struct Weights {
  std::array<double, 3> b{};

  double of(const std::array<double, 3>& a) const { return b[0] * a[0] + b[1] * a[1] + b[2] * a[2]; }
  Vec3 of(const std::array<Vec3, 3>& a) const { return b[0] * a[0] + b[1] * a[1] + b[2] * a[2]; }
  Vec2 of(const std::array<Vec2, 3>& a) const { return b[0] * a[0] + b[1] * a[1] + b[2] * a[2]; }
};

class Barycentric {
 public:
  Barycentric(const Shape& config, const Corners& corners)
      : planes_(half_planes(corners, config.subpixel_bits)),
        per_area_(1 / std::abs(static_cast<double>(corners.area))) {}

  Weights at(int x, int y) const {
    Weights weights;
    for (std::size_t i = 0; i < 3; ++i) weights.b[i] = static_cast<double>(planes_[i].at(x, y)) * per_area_;
    return weights;
  }

 private:
  std::array<HalfPlane, 3> planes_;
  double per_area_;
};

// Interpolated components; u, v are u*q, v*q with `perspective`.
struct Interpolated {
  FrameVectors frame;
  Vec3 l, h;
  double u = 0, v = 0, q = 1, lod = 0, z = 0;
};

// The level of detail: log2(rho), computed from the square of rho and clamped to [lowest, highest].
inline double level(double rho_squared, double lowest, double highest) {
  return rho_squared > 0 ? std::clamp(std::log2(rho_squared) / 2, lowest, highest) : lowest;
}

// The corner values of one triangle.
class Attributes {
 public:
  Attributes(const Shape& config, const Corners& corners, const DrawWords& draw) {
    frame_ = frame_corners(config, corners, draw);
    l_ = vector_corners(config, corners, &ScreenVertex::L, config.normalizer_l);
    h_ = vector_corners(config, corners, &ScreenVertex::H, config.third_normalizer);
    for (std::size_t i = 0; i < 3; ++i) z_[i] = depth_in_format(config, corners.v[i]->z);
    if (!draw.textured) return;
    const TextureCorners texture = texture_corners(config, corners, draw);
    u_ = texture.u, v_ = texture.v, q_ = texture.q;
    if (config.perspective == 0) {
      lod_.fill(level(texel_rate_squared(config, corners, texture, draw), 0, draw.max_level));
      return;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      u_[i] *= q_[i], v_[i] *= q_[i];
      lod_[i] = level(texel_rate_squared_at(config, corners, texture, draw, i), -kFarthestLevel, kFarthestLevel);
    }
  }

  Interpolated at(const Weights& weights) const {
    FrameVectors frame{};
    for (std::size_t i = 0; i < frame_.size(); ++i) frame[i] = weights.of(frame_[i]);
    return {frame,          weights.of(l_), weights.of(h_),   weights.of(u_),
            weights.of(v_), weights.of(q_), weights.of(lod_), weights.of(z_)};
  }

 private:
  std::vector<std::array<Vec3, 3>> frame_;
  std::array<Vec3, 3> l_, h_;
  std::array<double, 3> u_{}, v_{}, q_{1, 1, 1}, lod_{}, z_{};
};

}  // namespace wrinkle::exact

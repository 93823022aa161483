// Twin of the stage `light`.
#pragma once

#include <algorithm>

#include "golden/config/config.h"
#include "golden/triangle/packet.h"
#include "golden/vector.h"

namespace wrinkle::exact {

struct Lit {
  double nl = 0, nh = 0, diffuse = 0, specular = 0;  // in [0, 1]
};

// The share of the light that the unperturbed surface lets through, by its cosine.
inline double self_shadow(const Shape& config, double cosine) {
  return config.self_shadow == static_cast<int>(SelfShadow::kHard) ? (cosine > 0 ? 1 : 0) : std::min(8 * cosine, 1.0);
}

// R.E of the reflection R = 2 (N.L) N - L of the light [Peercy97 section 4]; not clamped.
inline double reflected(Vec3 n, Vec3 l, Vec3 e) {
  const auto cosine = [](double x) { return std::clamp(x, -1.0, 1.0); };
  return dot(n, l) > 0 ? 2 * cosine(dot(n, l)) * cosine(dot(n, e)) - dot(l, e) : 0;
}

// N.L and N.H, or R.E; `h` is E with lighting = reflection.
inline void dots(const Shape& config, Vec3 n, Vec3 l, Vec3 h, Lit& lit) {
  lit.nl = std::clamp(dot(n, l), 0.0, 1.0);
  if (config.glossy != 0)
    lit.nh = std::clamp(config.is(Lighting::kReflection) ? reflected(n, l, h) : dot(n, h), 0.0, 1.0);
}

// All behind the dot products. `surface_cosine`: N.L of the unperturbed surface; in tangent space L.z.
inline void power(const Shape& config, const DrawWords& draw, double surface_cosine, Lit& lit) {
  const auto cosine = [](double x) { return std::clamp(x, 0.0, 1.0); };
  const double nl = cosine(lit.nl);
  lit.diffuse = nl;
  lit.specular = 0;
  if (config.glossy != 0) {
    lit.specular = draw.exponent_zero ? 1 : cosine(lit.nh);
    for (int i = 0; !draw.exponent_zero && i < draw.squarings; ++i) lit.specular *= lit.specular;
  }
  if (draw.shadow) {
    const double through = self_shadow(config, config.surface_is_z != 0 && draw.bump ? cosine(surface_cosine) : nl);
    lit.diffuse *= through;
    lit.specular *= nl > 0 ? through : 0;
  }
}

}  // namespace wrinkle::exact

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
inline double self_shadow(const Config& config, double cosine) {
  return config.self_shadow == static_cast<int>(SelfShadow::kHard) ? (cosine > 0 ? 1 : 0) : std::min(8 * cosine, 1.0);
}

// R.E of the reflection R = 2 (N.L) N - L of the light [Peercy97 section 4]; not clamped.
inline double reflected(Vec3 n, Vec3 l, Vec3 e) {
  const auto cosine = [](double x) { return std::clamp(x, -1.0, 1.0); };
  return dot(n, l) > 0 ? 2 * cosine(dot(n, l)) * cosine(dot(n, e)) - dot(l, e) : 0;
}

// `h` is E with lighting = reflection. `surface_cosine`: N.L of the unperturbed surface; in tangent space L.z.
inline Lit light(const Config& config, const DrawWords& draw, Vec3 n, Vec3 l, Vec3 h, double surface_cosine) {
  const auto cosine = [](double x) { return std::clamp(x, 0.0, 1.0); };
  Lit lit;
  lit.nl = cosine(dot(n, l));
  lit.diffuse = lit.nl;
  if (config.has_specular()) {
    lit.nh = cosine(config.is(Lighting::kReflection) ? reflected(n, l, h) : dot(n, h));
    lit.specular = draw.exponent_zero ? 1 : lit.nh;
    for (int i = 0; !draw.exponent_zero && i < draw.squarings; ++i) lit.specular *= lit.specular;
  }
  if (draw.shadow) {
    const double through =
        self_shadow(config, config.has_texture_normal() && draw.bump ? cosine(surface_cosine) : lit.nl);
    lit.diffuse *= through;
    lit.specular *= lit.nl > 0 ? through : 0;
  }
  return lit;
}

}  // namespace wrinkle::exact

// Twin of the stage `output`.
#pragma once

#include <algorithm>

#include "golden/exact/light.h"
#include "golden/triangle/packet.h"
#include "golden/vector.h"

namespace wrinkle::exact {

// Ambient, diffuse and specular colour of a draw in the configured channels.
struct Reflectance {
  Vec3 ambient, diffuse, specular;
};

inline Reflectance reflectance(const Shape& config, const Material& material) {
  return {to_channels(config, material.ambient), to_channels(config, material.diffuse),
          to_channels(config, material.specular)};
}

// One channel, in [0, 1].
inline double shade(double ambient, double diffuse, double specular, double decal, const Lit& lit) {
  return std::clamp((ambient + diffuse * lit.diffuse) * decal + specular * lit.specular, 0.0, 1.0);
}

inline Vec3 output(const Reflectance& r, Vec3 decal, double gloss, const Lit& lit) {
  return {shade(r.ambient.x, r.diffuse.x, gloss * r.specular.x, decal.x, lit),
          shade(r.ambient.y, r.diffuse.y, gloss * r.specular.y, decal.y, lit),
          shade(r.ambient.z, r.diffuse.z, gloss * r.specular.z, decal.z, lit)};
}

}  // namespace wrinkle::exact

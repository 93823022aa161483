#include "golden/vertex/shading.h"

#include "golden/vertex/camera.h"
#include "golden/vertex/tessellate.h"
#include "golden/vertex/transform.h"

namespace wrinkle {

TangentFrame tangent_frame(const Vertex& vertex, const Mat4& to_world) {
  const Vec3 N = normalize(transform_normal(to_world, vertex.N));
  const Vec3 T = perpendicular(N, transform_direction(to_world, vertex.T));
  const double sign = determinant3(to_world) < 0 ? -vertex.sign : vertex.sign;
  return {T, sign * cross(N, T), N};
}

Vec3 to_object_space(const Mat4& to_world, Vec3 v) {
  const Mat4& m = to_world;
  return normalize({m(0, 0) * v.x + m(1, 0) * v.y + m(2, 0) * v.z, m(0, 1) * v.x + m(1, 1) * v.y + m(2, 1) * v.z,
                    m(0, 2) * v.x + m(1, 2) * v.y + m(2, 2) * v.z});
}

Illumination::Illumination(const Scene& scene)
    : eye_at_infinity_(scene.viewer_at_infinity),
      light_at_infinity_(scene.light.at_infinity),
      eye_(scene.viewer_at_infinity ? viewer_direction(scene.camera) : eye_position(scene.camera)),
      light_(scene.light.at_infinity ? normalize(scene.light.position) : scene.light.position) {}

LightVectors Illumination::at(Vec3 P) const {
  const Vec3 L = light_at_infinity_ ? light_ : normalize(light_ - P);
  const Vec3 V = eye_at_infinity_ ? eye_ : normalize(eye_ - P);
  return {L, normalize(L + V), V};
}

}  // namespace wrinkle

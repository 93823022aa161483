#include "sim/scene/defaults.h"

#include <algorithm>
#include <numbers>
#include <string>

#include "golden/vertex/camera.h"
#include "golden/vertex/transform.h"

namespace wrinkle {
namespace {

// Copies of a mesh share nothing, so that many nodes may take more than their triangles do.
constexpr std::size_t kMaximumVertices = 3 * kMaximumTriangles;

Vec3 row(const Mat4& m, int r) { return {m(r, 0), m(r, 1), m(r, 2)}; }

}  // namespace

Bounds bounds_of(const std::vector<Object>& objects) {
  bool any = false;
  Bounds b{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}};
  for (const Object& object : objects) {
    for (const auto& triangle : object.mesh.triangles) {
      const Vec3 p[3] = {object.mesh.vertices[triangle[0]].P, object.mesh.vertices[triangle[1]].P,
                         object.mesh.vertices[triangle[2]].P};
      if (cross(p[1] - p[0], p[2] - p[0]) == Vec3{}) continue;
      for (const Vec3& local : p) {
        const Vec3 q = transform_point(object.to_world, local);
        if (!any) b = {q, q};
        any = true;
        b.low = {std::min(b.low.x, q.x), std::min(b.low.y, q.y), std::min(b.low.z, q.z)};
        b.high = {std::max(b.high.x, q.x), std::max(b.high.y, q.y), std::max(b.high.z, q.z)};
      }
    }
  }
  return b;
}

Camera framing_camera(const Bounds& bounds) {
  constexpr double kHalfAngle = 17.5 * std::numbers::pi / 180;
  const double radius = bounds.radius() > 0 ? bounds.radius() : 1;
  const double distance = radius / std::sin(kHalfAngle);
  Camera camera;
  camera.perspective = true;
  camera.half_height = std::tan(kHalfAngle);
  camera.world_to_eye = look_at(bounds.centre() + distance * normalize(Vec3{0.35, 0.3, 1}), bounds.centre(), {0, 1, 0});
  camera.near = distance - 1.01 * radius;
  camera.far = distance + 1.01 * radius;
  return camera;
}

Light default_light(const Camera& camera) {
  const Vec3 in_eye{-0.45, 0.55, 0.7};
  const Vec3 towards = in_eye.x * row(camera.world_to_eye, 0) + in_eye.y * row(camera.world_to_eye, 1) +
                       in_eye.z * row(camera.world_to_eye, 2);
  return {normalize(towards), true};
}

void check_size(const std::vector<Object>& objects, const Place& place) {
  if (objects.size() > kMaximumObjects) {
    throw InputError(place, std::to_string(objects.size()) + " objects", "at most " + std::to_string(kMaximumObjects));
  }
  std::size_t triangles = 0, vertices = 0;
  for (const Object& object : objects) {
    triangles += object.mesh.triangles.size();
    vertices += object.mesh.vertices.size();
  }
  if (triangles > kMaximumTriangles) {
    throw InputError(place, std::to_string(triangles) + " triangles", "at most " + std::to_string(kMaximumTriangles));
  }
  if (vertices > kMaximumVertices) {
    throw InputError(place, std::to_string(vertices) + " vertices", "at most " + std::to_string(kMaximumVertices));
  }
}

}  // namespace wrinkle

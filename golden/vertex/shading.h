// The vectors of a vertex: its tangent frame in world space, and L and H seen from it.
#pragma once

#include "golden/vector.h"
#include "golden/vertex/mesh.h"
#include "golden/vertex/scene.h"

namespace wrinkle {

// N of the vertex in the world, T made perpendicular to it (any perpendicular where T gives no direction), and
// B = sign * (N x T), the sign changed by a matrix that mirrors: B stays the image of B.
TangentFrame tangent_frame(const Vertex& vertex, const Mat4& to_world);

// v in the coordinates of the frame [Peercy97 eq. 7].
inline Vec3 to_tangent_space(const TangentFrame& frame, Vec3 v) {
  return {dot(v, frame.T), dot(v, frame.B), dot(v, frame.N)};
}

// A unit vector of the world in object space, for a matrix that turns, moves and scales all directions alike: the dot
// products with what it was turned with are the same.
Vec3 to_object_space(const Mat4& to_world, Vec3 v);

// Unit vectors in world space; zero where the light (or the viewer) is at P itself.
struct LightVectors {
  Vec3 L, H, E;
};

// The light and the viewer, each at a point or at infinity. E points to the viewer, H = normalize(L + E).
class Illumination {
 public:
  explicit Illumination(const Scene& scene);
  LightVectors at(Vec3 P) const;
  const Vec3& eye() const { return eye_; }      // position, or direction towards it
  const Vec3& light() const { return light_; }  // position, or direction towards it

 private:
  bool eye_at_infinity_, light_at_infinity_;
  Vec3 eye_, light_;
};

}  // namespace wrinkle

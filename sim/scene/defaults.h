// Cameras and lights for files that have none, and the limits of a scene.
#pragma once

#include <cstddef>

#include "golden/vertex/scene.h"
#include "sim/input_error.h"

namespace wrinkle {

inline constexpr std::size_t kMaximumTriangles = std::size_t{1} << 24;  // of a scene
inline constexpr std::size_t kMaximumObjects = 65536;
inline constexpr double kMaximumCoordinate = 1e12;

struct Bounds {
  Vec3 low, high;
  Vec3 centre() const { return 0.5 * (low + high); }
  double radius() const { return 0.5 * length(high - low); }
};
// Of what is drawn, the triangles that have an area, in world space; where there is none, a unit box.
Bounds bounds_of(const std::vector<Object>& objects);

// A perspective camera, 35 degrees high, that holds the whole scene, a little from the right and above the +z axis.
Camera framing_camera(const Bounds& bounds);

// A light at infinity over the viewer's left shoulder.
Light default_light(const Camera& camera);

// Throws when the scene has more objects or triangles than the limits above; `place` is the file.
void check_size(const std::vector<Object>& objects, const Place& place);

}  // namespace wrinkle

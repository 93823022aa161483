// From the world to the screen.
#pragma once

#include "golden/vector.h"
#include "golden/vertex/scene.h"

namespace wrinkle {

// World to eye for an eye at `eye` that looks at `target`; `up` is any direction that is not along the view.
Mat4 look_at(Vec3 eye, Vec3 target, Vec3 up);

Vec3 eye_position(const Camera& camera);
// Unit vector from the scene towards a viewer at infinity: the camera's +z.
Vec3 viewer_direction(const Camera& camera);

// A homogeneous point on the screen: pixel (x / w, y / w), y down, depth z / w in [0, 1] between the near and the far
// plane. w is the distance along the view for a perspective camera, 1 for an orthographic one. x, y, z and w are linear
// in the world: edges stay straight and may be clipped here.
struct ScreenPoint {
  double x = 0, y = 0, z = 0, w = 1;
};

// `width` and `height` in pixels; pixels are square.
class Projection {
 public:
  Projection(const Camera& camera, int width, int height);
  ScreenPoint operator()(Vec3 world) const;

 private:
  Mat4 world_to_eye_;
  bool perspective_;
  double scale_, centre_x_, centre_y_;  // pixels
  double near_, far_;
};

}  // namespace wrinkle

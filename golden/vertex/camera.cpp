#include "golden/vertex/camera.h"

#include "golden/vertex/tessellate.h"
#include "golden/vertex/transform.h"

namespace wrinkle {

Mat4 look_at(Vec3 eye, Vec3 target, Vec3 up) {
  const Vec3 z = normalize(eye - target);
  const Vec3 y = perpendicular(z, up);
  const Vec3 x = cross(y, z);
  Mat4 m;
  m(0, 0) = x.x, m(0, 1) = x.y, m(0, 2) = x.z, m(0, 3) = -dot(x, eye);
  m(1, 0) = y.x, m(1, 1) = y.y, m(1, 2) = y.z, m(1, 3) = -dot(y, eye);
  m(2, 0) = z.x, m(2, 1) = z.y, m(2, 2) = z.z, m(2, 3) = -dot(z, eye);
  return m;
}

Vec3 eye_position(const Camera& camera) { return transform_point(affine_inverse(camera.world_to_eye), {}); }

Vec3 viewer_direction(const Camera& camera) {
  const Mat4& m = camera.world_to_eye;
  return normalize({m(2, 0), m(2, 1), m(2, 2)});
}

Projection::Projection(const Camera& camera, int width, int height)
    : world_to_eye_(camera.world_to_eye),
      perspective_(camera.perspective),
      scale_(0.5 * height / camera.half_height),
      centre_x_(0.5 * width),
      centre_y_(0.5 * height),
      near_(camera.near),
      far_(camera.far) {}

ScreenPoint Projection::operator()(Vec3 world) const {
  const Vec3 eye = transform_point(world_to_eye_, world);
  const double distance = -eye.z;
  const double w = perspective_ ? distance : 1;
  const double depth = (distance - near_) / (far_ - near_) * (perspective_ ? far_ : 1);
  return {scale_ * eye.x + centre_x_ * w, centre_y_ * w - scale_ * eye.y, depth, w};
}

}  // namespace wrinkle

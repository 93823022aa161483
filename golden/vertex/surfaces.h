// Analytic surfaces with outward normals. Their parameters are right-handed as seen from outside: u to the right, v up.
#pragma once

#include <memory>
#include <vector>

#include "golden/vector.h"
#include "golden/vertex/surface.h"

namespace wrinkle {

// P = origin + u side_u + v side_v.
class Rectangle : public Surface {
 public:
  Rectangle(Vec3 origin, Vec3 side_u, Vec3 side_v) : origin_(origin), side_u_(side_u), side_v_(side_v) {}
  SurfacePoint at(double u, double v) const override;

 private:
  Vec3 origin_, side_u_, side_v_;
};

// About the y axis; u eastwards from +z, v from the south pole to the north pole.
class Sphere : public Surface {
 public:
  explicit Sphere(double radius) : radius_(radius) {}
  SurfacePoint at(double u, double v) const override;

 private:
  double radius_;
};

// About the y axis; u eastwards from +z, v around the tube from its outermost line upwards.
class Torus : public Surface {
 public:
  // The circle of radius `major` is the centre of a tube of radius `minor`.
  Torus(double major, double minor) : major_(major), minor_(minor) {}
  SurfacePoint at(double u, double v) const override;

 private:
  double major_, minor_;
};

// About the y axis; u eastwards from +z, v along the profile, whose points are (radius, height), listed from below
// (so that the normal points outwards). The profile is a uniform Catmull-Rom spline through its points, at least two.
class Revolution : public Surface {
 public:
  explicit Revolution(std::vector<Vec2> profile);
  SurfacePoint at(double u, double v) const override;

 private:
  struct ProfilePoint {
    Vec2 p, derivative;
  };
  ProfilePoint profile(double v) const;

  std::vector<Vec2> points_;
};

// `surface` under an affine transform: P by the matrix, Pu and Pv by its linear part. N stays on the outer side, so a
// mirroring matrix makes N opposite to Pu x Pv. Returns `surface` itself for the identity.
std::shared_ptr<const Surface> transformed(std::shared_ptr<const Surface> surface, const Mat4& matrix);

// The back of `surface`: the same points and derivatives, N opposite.
std::shared_ptr<const Surface> reversed(std::shared_ptr<const Surface> surface);

// Square root of the mean of |Pu x Pv|: the k of [Peercy97 eq. 8-11] that suits the surface as a whole.
double mean_scale(const Surface& surface);

}  // namespace wrinkle

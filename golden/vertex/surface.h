// Surfaces with analytic derivatives: what Eq. 3-6 and the ideal picture are computed from.
#pragma once

#include "golden/vector.h"

namespace wrinkle {

// A point of P(u, v) and its partial derivatives; u, v in [0, 1] over one copy of the texture.
struct SurfacePoint {
  Vec3 P, Pu, Pv;
  // Pu x Pv, not normalized; at a pole, where it vanishes, `N` holds the limit.
  Vec3 N;  // unit
};

// The frame in which the normals of a texture are given, at a point of a surface: in world space, and perpendicular
// where it is not interpolated.
struct TangentFrame {
  Vec3 T, B, N;
};

class Surface {
 public:
  virtual ~Surface() = default;
  virtual SurfacePoint at(double u, double v) const = 0;
};

}  // namespace wrinkle

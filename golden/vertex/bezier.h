// Bicubic Bezier patches, among them the paper's.
#pragma once

#include <array>
#include <memory>

#include "golden/vertex/surface.h"

namespace wrinkle {

// Control points by rows: point 4 i + j weighs with the i-th cubic of v and the j-th of u.
using ControlPoints = std::array<Vec3, 16>;

// P(u, v) = sum b_i(v) b_j(u) p_ij. Two patches that share a border's control points, in either direction, share its
// points bit for bit at parameters k / 2^n. Where Pu x Pv vanishes (an edge drawn together to a pole, or Pu parallel
// to Pv) `N` is the limit from within the patch.
class BezierPatch : public Surface {
 public:
  explicit BezierPatch(const ControlPoints& points);
  SurfacePoint at(double u, double v) const override;

 private:
  Vec3 limit_normal(double u, double v) const;

  ControlPoints points_;
  double scale_;  // extent of the control net, what "vanishes" is measured by
};

// The highly stretched patch of [Peercy97 section 3], by its description and the look of its figures: a curved sheet
// that covers two thirds of [-1, 1]^2, seen from +z without a fold. |Pu| / |Pv| runs from below 1/2 to above 5/2, the
// angle between them from below 55 to above 95 degrees.
std::shared_ptr<const Surface> stretched_patch();

}  // namespace wrinkle

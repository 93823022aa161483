#include "golden/vertex/bezier.h"

#include <algorithm>

namespace wrinkle {
namespace {

using Weights = std::array<double, 4>;

Weights bernstein(double t) {
  const double s = 1 - t;
  return {s * s * s, 3 * s * s * t, 3 * s * (t * t), t * t * t};
}

Weights bernstein_derivative(double t) {
  const double s = 1 - t;
  return {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t};
}

// The ends and the middle are summed apart, so that a curve read backwards has the same points.
Vec3 blend(const Weights& w, Vec3 a, Vec3 b, Vec3 c, Vec3 d) { return (w[0] * a + w[3] * d) + (w[1] * b + w[2] * c); }

Vec3 evaluate(const ControlPoints& p, const Weights& wu, const Weights& wv) {
  std::array<Vec3, 4> row;
  for (std::size_t i = 0; i < 4; ++i) row[i] = blend(wu, p[4 * i], p[4 * i + 1], p[4 * i + 2], p[4 * i + 3]);
  return blend(wv, row[0], row[1], row[2], row[3]);
}

double extent(const ControlPoints& points) {
  double largest = 0;
  for (const Vec3& p : points) largest = std::max(largest, length(p - points[0]));
  return largest;
}

}  // namespace

BezierPatch::BezierPatch(const ControlPoints& points) : points_(points), scale_(extent(points)) {}

SurfacePoint BezierPatch::at(double u, double v) const {
  const Weights bu = bernstein(u), bv = bernstein(v);
  SurfacePoint s;
  s.P = evaluate(points_, bu, bv);
  s.Pu = evaluate(points_, bernstein_derivative(u), bv);
  s.Pv = evaluate(points_, bu, bernstein_derivative(v));
  const Vec3 area = cross(s.Pu, s.Pv);
  s.N = length(area) > 1e-7 * scale_ * scale_ ? normalize(area) : limit_normal(u, v);
  return s;
}

// Steps from the degenerate point into the patch, across the edge that is drawn together, and extrapolates the unit
// normal linearly back from two steps: the error is of the order of the step squared. On a fold, where the sides have
// opposite normals, that of one side; (0, 0, 1) for a patch without area.
Vec3 BezierPatch::limit_normal(double u, double v) const {
  constexpr double kStep = 1.0 / 4096;
  const double small = 1e-6 * scale_;
  const bool u_collapsed = length(evaluate(points_, bernstein_derivative(u), bernstein(v))) < small;
  const bool v_collapsed = length(evaluate(points_, bernstein(u), bernstein_derivative(v))) < small;
  const double du = u < 0.5 ? kStep : -kStep, dv = v < 0.5 ? kStep : -kStep;
  const auto normal = [&](Vec2 p) {
    return normalize(cross(evaluate(points_, bernstein_derivative(p.x), bernstein(p.y)),
                           evaluate(points_, bernstein(p.x), bernstein_derivative(p.y))));
  };
  const Vec2 across = u_collapsed == v_collapsed ? Vec2{du, dv} : u_collapsed ? Vec2{0, dv} : Vec2{du, 0};
  for (const Vec2 step : {across, Vec2{du, 0}, Vec2{0, dv}}) {
    const Vec2 at{u, v};
    const Vec3 limit = normalize(2 * normal(at + step) - normal(at + 2.0 * step));
    if (length(limit) > 0) return limit;
  }
  return {0, 0, 1};
}

std::shared_ptr<const Surface> stretched_patch() {
  static const ControlPoints kPoints{{
      {-0.93, -0.93, -0.10},
      {-0.60, -0.98, 0.01},
      {-0.06, -0.87, -0.01},
      {0.62, -0.62, -0.14},
      {-0.88, -0.14, 0.01},
      {-0.46, -0.09, 0.12},
      {0.08, 0.02, 0.12},
      {0.88, 0.14, -0.01},
      {-0.77, 0.41, -0.01},
      {-0.35, 0.45, 0.12},
      {0.19, 0.56, 0.12},
      {0.99, 0.68, 0.01},
      {-0.62, 0.62, -0.14},
      {-0.33, 0.79, -0.01},
      {0.21, 0.90, 0.01},
      {0.93, 0.93, -0.10},
  }};
  return std::make_shared<BezierPatch>(kPoints);
}

}  // namespace wrinkle

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
// normal linearly back from two steps: the error is of the order of the step squared.
Vec3 BezierPatch::limit_normal(double u, double v) const {
  const auto normal = [&](double step) {
    const auto inwards = [&](double t) { return t < 0.5 ? t + step : t - step; };
    const Weights bu = bernstein(u), bv = bernstein(v);
    const double small = 1e-6 * scale_;
    const bool u_collapsed = length(evaluate(points_, bernstein_derivative(u), bv)) < small;
    const bool v_collapsed = length(evaluate(points_, bu, bernstein_derivative(v))) < small;
    const double nu = u_collapsed && !v_collapsed ? u : inwards(u);
    const double nv = v_collapsed && !u_collapsed ? v : inwards(v);
    return normalize(cross(evaluate(points_, bernstein_derivative(nu), bernstein(nv)),
                           evaluate(points_, bernstein(nu), bernstein_derivative(nv))));
  };
  constexpr double kStep = 1.0 / 4096;
  return normalize(2 * normal(kStep) - normal(2 * kStep));
}

std::shared_ptr<const Surface> stretched_patch() {
  static const ControlPoints kPoints{{
      {-0.95, -0.62, -0.10},
      {-0.72, -0.98, 0.30},
      {0.05, -0.90, 0.45},
      {0.58, -0.97, -0.20},
      {-0.98, -0.30, 0.15},
      {-0.25, -0.42, 0.75},
      {0.45, -0.62, 0.55},
      {0.90, -0.55, 0.10},
      {-0.90, 0.10, 0.05},
      {-0.40, 0.28, 0.50},
      {0.28, 0.05, 0.70},
      {0.97, 0.05, 0.25},
      {-0.60, 0.95, -0.25},
      {-0.05, 0.92, 0.25},
      {0.62, 0.98, 0.40},
      {0.95, 0.62, -0.05},
  }};
  return std::make_shared<BezierPatch>(kPoints);
}

}  // namespace wrinkle

#include "golden/vertex/surfaces.h"

#include <algorithm>
#include <cassert>
#include <numbers>
#include <utility>

#include "golden/vertex/transform.h"

namespace wrinkle {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

struct Angle {
  double sine, cosine;
};

// A whole turn is no turn, bit for bit: closed surfaces close.
Angle turn(double t) {
  const double wrapped = t >= 1 ? t - 1 : t;
  return {std::sin(kTurn * wrapped), std::cos(kTurn * wrapped)};
}

// A point of the profile (radius, height), turned about the y axis.
SurfacePoint revolve(double u, Vec2 profile, Vec2 derivative, Vec2 unit_normal) {
  const Angle a = turn(u);
  const auto place = [&](Vec2 p) { return Vec3{p.x * a.sine, p.y, p.x * a.cosine}; };
  return {place(profile), kTurn * profile.x * Vec3{a.cosine, 0, -a.sine}, place(derivative), place(unit_normal)};
}

class Transformed : public Surface {
 public:
  Transformed(std::shared_ptr<const Surface> surface, const Mat4& matrix)
      : surface_(std::move(surface)), matrix_(matrix) {}
  SurfacePoint at(double u, double v) const override {
    const SurfacePoint s = surface_->at(u, v);
    return {transform_point(matrix_, s.P), transform_direction(matrix_, s.Pu), transform_direction(matrix_, s.Pv),
            normalize(transform_normal(matrix_, s.N))};
  }

 private:
  std::shared_ptr<const Surface> surface_;
  Mat4 matrix_;
};

class Reversed : public Surface {
 public:
  explicit Reversed(std::shared_ptr<const Surface> surface) : surface_(std::move(surface)) {}
  SurfacePoint at(double u, double v) const override {
    SurfacePoint s = surface_->at(u, v);
    s.N = -s.N;
    return s;
  }

 private:
  std::shared_ptr<const Surface> surface_;
};

}  // namespace

SurfacePoint Rectangle::at(double u, double v) const {
  return {origin_ + u * side_u_ + v * side_v_, side_u_, side_v_, normalize(cross(side_u_, side_v_))};
}

SurfacePoint Sphere::at(double u, double v) const {
  const double latitude = std::numbers::pi * (v - 0.5);
  const bool pole = v <= 0 || v >= 1;  // cos(pi/2) is not quite 0 in floating point
  const Vec2 n{pole ? 0 : std::cos(latitude), std::sin(latitude)};
  return revolve(u, radius_ * n, std::numbers::pi * radius_ * Vec2{-n.y, n.x}, n);
}

SurfacePoint Torus::at(double u, double v) const {
  const Angle a = turn(v);
  const Vec2 n{a.cosine, a.sine};
  return revolve(u, Vec2{major_, 0} + minor_ * n, kTurn * minor_ * Vec2{-n.y, n.x}, n);
}

Revolution::Revolution(std::vector<Vec2> profile) : points_(std::move(profile)) { assert(points_.size() >= 2); }

SurfacePoint Revolution::at(double u, double v) const {
  const ProfilePoint p = profile(v);
  const double l = std::hypot(p.derivative.x, p.derivative.y);
  // The normal is right of the profile's direction; at a standstill it points away from the axis.
  const Vec2 n = l > 0 ? (1 / l) * Vec2{p.derivative.y, -p.derivative.x} : Vec2{1, 0};
  return revolve(u, p.p, p.derivative, n);
}

Revolution::ProfilePoint Revolution::profile(double v) const {
  const int spans = static_cast<int>(points_.size()) - 1;
  const int span = std::clamp(static_cast<int>(std::floor(v * spans)), 0, spans - 1);
  const double t = v * spans - span;
  // Beyond the ends the profile goes on straight.
  const auto point = [&](int i) {
    if (i < 0) return 2.0 * points_.front() - points_[1];
    if (i > spans) return 2.0 * points_.back() - points_[points_.size() - 2];
    return points_[static_cast<std::size_t>(i)];
  };
  const Vec2 a = point(span - 1), b = point(span), c = point(span + 1), d = point(span + 2);
  const Vec2 k1 = 0.5 * (c - a), k2 = a - 2.5 * b + 2.0 * c - 0.5 * d, k3 = 1.5 * (b - c) + 0.5 * (d - a);
  return {b + t * (k1 + t * (k2 + t * k3)), spans * (k1 + t * (2.0 * k2 + 3 * t * k3))};
}

std::shared_ptr<const Surface> transformed(std::shared_ptr<const Surface> surface, const Mat4& matrix) {
  if (!surface || is_identity(matrix)) return surface;
  return std::make_shared<Transformed>(std::move(surface), matrix);
}

std::shared_ptr<const Surface> reversed(std::shared_ptr<const Surface> surface) {
  return std::make_shared<Reversed>(std::move(surface));
}

double mean_scale(const Surface& surface) {
  constexpr int kSamples = 32;
  double sum = 0;
  for (int j = 0; j < kSamples; ++j) {
    for (int i = 0; i < kSamples; ++i) {
      const SurfacePoint s = surface.at((i + 0.5) / kSamples, (j + 0.5) / kSamples);
      sum += length(cross(s.Pu, s.Pv));
    }
  }
  return std::sqrt(sum / (kSamples * kSamples));
}

}  // namespace wrinkle

#include "sim/scene/polygon.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace wrinkle {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;
constexpr std::uint32_t kNone = ~std::uint32_t{0};

// The corners on the plane that the polygon lies in on the average (Newell's normal), counter-clockwise, within a unit
// square.
std::vector<Vec2> flattened(std::span<const Vec3> corners) {
  Vec3 low = corners[0], high = corners[0];
  for (const Vec3& p : corners) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double extent = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  const double scale = extent > 0 ? 1 / extent : 1;
  std::vector<Vec3> points;
  for (const Vec3& p : corners) points.push_back(scale * (p - low));
  Vec3 normal;
  for (std::size_t i = 0; i < points.size(); ++i) {
    normal = normal + cross(points[i], points[(i + 1) % points.size()]);
  }
  // Leaving out the largest component of the normal keeps the plane's coordinates as they are written.
  const Vec3 size{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
  std::vector<Vec2> flat;
  for (const Vec3& p : points) {
    if (size.z >= size.x && size.z >= size.y) {
      flat.push_back(normal.z >= 0 ? Vec2{p.x, p.y} : Vec2{p.y, p.x});
    } else if (size.x >= size.y) {
      flat.push_back(normal.x >= 0 ? Vec2{p.y, p.z} : Vec2{p.z, p.y});
    } else {
      flat.push_back(normal.y >= 0 ? Vec2{p.z, p.x} : Vec2{p.x, p.z});
    }
  }
  return flat;
}

// Cuts ears off the polygon [Meisters75] until a triangle is left. Only corners that are not convex can lie in an ear;
// a grid finds those near by.
class EarCutter {
 public:
  explicit EarCutter(std::span<const Vec3> corners)
      : points_(flattened(corners)),
        count_(static_cast<std::uint32_t>(corners.size())),
        side_(std::max(1, static_cast<int>(std::sqrt(static_cast<double>(corners.size()) / 4)))),
        cells_(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_)) {
    for (std::uint32_t i = 0; i < count_; ++i) {
      next_.push_back((i + 1) % count_);
      previous_.push_back((i + count_ - 1) % count_);
    }
    for (std::uint32_t i = 0; i < count_; ++i) list_if_not_convex(i);
  }

  Triangles run() {
    std::uint32_t at = 0, left = count_, tried = 0;
    int strictness = 2;
    while (left > 3) {
      if (is_ear(at, strictness)) {
        at = cut(at);
        --left;
        tried = 0;
        strictness = 2;
      } else {
        at = next_[at];
        // A whole round without an ear: corners that only touch are let through, then corners in line, then anything.
        if (++tried > left) {
          tried = 0;
          --strictness;
        }
      }
    }
    triangles_.push_back({previous_[at], at, next_[at]});
    return std::move(triangles_);
  }

 private:
  // 1 to the left, -1 to the right, 0 in line but for rounding.
  static int side_of(Vec2 a, Vec2 b, Vec2 c) {
    constexpr double kRounding = 1e-14;  // of a unit square
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    return area > kRounding ? 1 : area < -kRounding ? -1 : 0;
  }
  int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return side_of(points_[a], points_[b], points_[c]);
  }
  int column(double x) const { return std::clamp(static_cast<int>(x * side_), 0, side_ - 1); }
  std::size_t cell(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(side_) + static_cast<std::size_t>(x);
  }
  void list_if_not_convex(std::uint32_t i) {
    if (turn(previous_[i], i, next_[i]) <= 0) cells_[cell_of(points_[i])].push_back(i);
  }
  std::size_t cell_of(Vec2 p) const { return cell(column(p.x), column(p.y)); }

  bool is_ear(std::uint32_t b, int strictness) const {
    const std::uint32_t a = previous_[b], c = next_[b];
    const int turned = turn(a, b, c);
    // There and back again covers nothing, and would be in the way of what does.
    if (strictness < 0 || points_[a] == points_[c] || points_[a] == points_[b] || points_[b] == points_[c]) return true;
    if (turned < 0 || (turned == 0 && strictness > 0)) return false;
    const Vec2 A = points_[a], B = points_[b], C = points_[c];
    const int x0 = column(std::min({A.x, B.x, C.x})), x1 = column(std::max({A.x, B.x, C.x}));
    const int y0 = column(std::min({A.y, B.y, C.y})), y1 = column(std::max({A.y, B.y, C.y}));
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        for (const std::uint32_t p : cells_[cell(x, y)]) {
          if (next_[p] != kNone && p != a && p != b && p != c && blocks(p, a, b, c, strictness)) return false;
        }
      }
    }
    return true;
  }

  // Whether the outline at corner `p` stands in the way of cutting a, b, c off. A corner on the border of the ear does
  // where the outline goes on into it; on the new edge also by itself, while there are better ears.
  bool blocks(std::uint32_t p, std::uint32_t a, std::uint32_t b, std::uint32_t c, int strictness) const {
    const int ab = turn(a, b, p), bc = turn(b, c, p), ca = turn(c, a, p);
    if (ab < 0 || bc < 0 || ca < 0) return false;
    if (ab > 0 && bc > 0 && ca > 0) return true;
    const auto goes = [&](auto inside) { return inside(next_[p]) || inside(previous_[p]); };
    if (ab == 0 && bc == 0) {  // at b: into the angle there
      return goes([&](std::uint32_t q) { return turn(a, b, q) > 0 && turn(b, c, q) > 0; });
    }
    if ((ab == 0 && ca == 0) || (bc == 0 && ca == 0)) return false;  // at a or c: what follows would be met inside
    if (ab == 0) return goes([&](std::uint32_t q) { return turn(a, b, q) > 0; });
    if (bc == 0) return goes([&](std::uint32_t q) { return turn(b, c, q) > 0; });
    return strictness > 1 || goes([&](std::uint32_t q) { return turn(c, a, q) > 0; });
  }

  // Returns where to go on: one corner further than the next, which makes for rounder triangles.
  std::uint32_t cut(std::uint32_t b) {
    const std::uint32_t a = previous_[b], c = next_[b];
    triangles_.push_back({a, b, c});
    next_[a] = c;
    previous_[c] = a;
    next_[b] = kNone;
    // An ear leaves convex corners convex; the end of a slit does not.
    if (turn(a, b, c) <= 0) list_if_not_convex(a), list_if_not_convex(c);
    return next_[c];
  }

  std::vector<Vec2> points_;
  std::uint32_t count_;
  int side_;                                       // cells along each side of the unit square
  std::vector<std::vector<std::uint32_t>> cells_;  // corners that are not convex
  std::vector<std::uint32_t> next_, previous_;     // next_ is kNone for what was cut off
  Triangles triangles_;
};

bool is_convex(const std::vector<Vec2>& points) {
  // Turning left throughout, and once round: as many corners as the x direction changes its sign twice.
  const std::size_t n = points.size();
  int changes = 0;
  double last = 0;
  for (std::size_t i = 0; i < 2 * n; ++i) {
    const Vec2 a = points[i % n], b = points[(i + 1) % n], c = points[(i + 2) % n];
    if (i < n && (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x) <= 0) return false;
    const double dx = b.x - a.x;
    if (i >= n && dx != 0 && last != 0 && (dx > 0) != (last > 0)) ++changes;
    if (dx != 0) last = dx;
  }
  return changes <= 2;
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec3> corners) {
  if (corners.size() < 3) return {};
  if (corners.size() == 3) return {{0, 1, 2}};
  if (!is_convex(flattened(corners))) return EarCutter(corners).run();
  if (corners.size() == 4) {  // by the shorter diagonal
    const Vec3 p = corners[2] - corners[0], q = corners[3] - corners[1];
    if (dot(p, p) < dot(q, q)) return {{0, 1, 2}, {0, 2, 3}};
    return {{0, 1, 3}, {1, 2, 3}};
  }
  Triangles fan;
  for (std::uint32_t i = 1; i + 1 < corners.size(); ++i) fan.push_back({0, i, i + 1});
  return fan;
}

}  // namespace wrinkle

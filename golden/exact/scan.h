// Twin of the stage `scan`: the pixels of a triangle from its three half-planes. The hardware walks chains of edges;
// that both agree is a test of either.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "golden/triangle/corners.h"
#include "golden/triangle/exact_division.h"

namespace wrinkle::exact {

// The side from `a` to `b` of a triangle wound clockwise on the screen (y down). A point is inside where
// (b - a) x (p - a) > 0, or = 0 on a left or top side. In sub-pixels squared.
struct HalfPlane {
  std::int64_t x = 0, y = 0;  // change per pixel
  std::int64_t origin = 0;    // at the centre of pixel (0, 0)

  static HalfPlane between(const ScreenVertex& a, const ScreenVertex& b, int subpixel_bits) {
    const std::int64_t one = std::int64_t{1} << subpixel_bits;
    const std::int64_t dx = std::int64_t{b.x} - a.x, dy = std::int64_t{b.y} - a.y;
    return {-dy * one, dx * one, dx * (one / 2 - a.y) - dy * (one / 2 - a.x)};
  }
  std::int64_t at(int px, int py) const { return origin + px * x + py * y; }
  // The least value that is inside.
  std::int64_t threshold() const { return x > 0 || (x == 0 && y > 0) ? 0 : 1; }
};

// Half-plane i lies opposite corner i and has the value |area| there.
inline std::array<HalfPlane, 3> half_planes(const Corners& corners, int subpixel_bits) {
  const auto& [a, b, c] = corners.v;
  std::array<HalfPlane, 3> planes{HalfPlane::between(*b, *c, subpixel_bits), HalfPlane::between(*c, *a, subpixel_bits),
                                  HalfPlane::between(*a, *b, subpixel_bits)};
  if (corners.area < 0) {
    planes = {HalfPlane::between(*c, *b, subpixel_bits), HalfPlane::between(*a, *c, subpixel_bits),
              HalfPlane::between(*b, *a, subpixel_bits)};
  }
  return planes;
}

// Calls span(y, first x, end x) for every row of [0, width) x [0, height) that has pixels.
template <class Span>
void scan(const Shape& config, const Corners& corners, int width, int height, Span&& span) {
  if (corners.area == 0) return;
  const std::array<HalfPlane, 3> planes = half_planes(corners, config.subpixel_bits);
  const int top = std::max(corners.v[0]->y >> config.subpixel_bits, 0);
  const int bottom = std::min((corners.v[2]->y >> config.subpixel_bits) + 1, height);
  for (int y = top; y < bottom; ++y) {
    std::int64_t first = 0, end = width;
    for (const HalfPlane& plane : planes) {
      const std::int64_t lacking = plane.threshold() - plane.at(0, y);
      if (plane.x > 0) first = std::max(first, ceil_divide(lacking, plane.x));
      if (plane.x < 0) end = std::min(end, floor_divide(-lacking, -plane.x) + 1);
      if (plane.x == 0 && lacking > 0) end = 0;
    }
    if (first < end) span(y, static_cast<int>(first), static_cast<int>(end));
  }
}

}  // namespace wrinkle::exact

// Planes of packets, and the exact ones to hold against them.
#pragma once

#include <stdexcept>
#include <string_view>

#include "golden/triangle/exact_division.h"
#include "tests/host/packet_walker.h"

namespace wrinkle::test {

// The position of a plane in plane_formats().
inline std::size_t place_of(const Shape& config, std::string_view name, std::size_t element = 0) {
  std::size_t place = 0;
  for (const PlaneFormat& format : plane_formats(config)) {
    if (format.is(name, element)) return place;
    ++place;
  }
  throw std::logic_error("the configuration has no such plane");
}

inline DrawWords bumped(int log2_width = 6, int log2_height = 6) {
  DrawWords draw;
  draw.bump = draw.textured = true;
  draw.log2_width = log2_width, draw.log2_height = log2_height;
  draw.max_level = std::max(log2_width, log2_height);
  return draw;
}

// The output of an interpolator: the accumulator without its guard bits, modulo 2^width.
inline std::int64_t code(const Config& config, const PlaneFormat& format, std::int64_t accumulator) {
  const int unused = 64 - format.width;
  const auto top = static_cast<std::uint64_t>(accumulator >> config.guard_bits) << unused;
  return format.is_signed ? static_cast<std::int64_t>(top) >> unused : static_cast<std::int64_t>(top >> unused);
}

// The plane through three corner values, exactly: twice the area times its value at the centre of a pixel.
struct Rational {
  Wide numerator, denominator;
  double value() const {  // correct to the rounding of one division, the whole part apart
    const Wide whole = floor_divide(numerator, denominator);
    return static_cast<double>(whole) +
           static_cast<double>(numerator - whole * denominator) / static_cast<double>(denominator);
  }
};
inline Rational plane_at(const Config& config, const ScreenTriangle& t, const std::array<std::int64_t, 3>& corner,
                         int x, int y) {
  const std::int64_t one = 1 << config.subpixel_bits;
  const Wide px = x * one + one / 2, py = y * one + one / 2;
  const auto area = [](Wide ax, Wide ay, Wide bx, Wide by, Wide cx, Wide cy) {
    return (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
  };
  const auto& v = t.v;
  const Wide whole = area(v[0].x, v[0].y, v[1].x, v[1].y, v[2].x, v[2].y);
  const Wide sum = area(px, py, v[1].x, v[1].y, v[2].x, v[2].y) * corner[0] +
                   area(v[0].x, v[0].y, px, py, v[2].x, v[2].y) * corner[1] +
                   area(v[0].x, v[0].y, v[1].x, v[1].y, px, py) * corner[2];
  return whole < 0 ? Rational{-sum, -whole} : Rational{sum, whole};
}

}  // namespace wrinkle::test

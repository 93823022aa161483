// Fragments of the float64 twins in columns, as golden has them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "golden/exact/exact.h"
#include "golden/vector.h"

namespace wrinkle::exact {

// So few that the half dozen batches that a replay compares stay in the second-level cache.
inline constexpr int kColumnLength = 64;

using Numbers = std::array<double, kColumnLength>;

// The values of one name, each element in an array of its own.
template <class T>
struct Column;

template <>
struct Column<double> {
  std::array<Numbers, 1> element;

  double operator[](std::size_t i) const { return element[0][i]; }
  void set(std::size_t i, double value) { element[0][i] = value; }
};

template <>
struct Column<Vec3> {
  std::array<Numbers, 3> element;

  Vec3 operator[](std::size_t i) const { return {element[0][i], element[1][i], element[2][i]}; }
  void set(std::size_t i, Vec3 value) { element[0][i] = value.x, element[1][i] = value.y, element[2][i] = value.z; }
};

template <>
struct Column<BumpComponents> {
  std::array<Numbers, kMaxBumpComponents> element;

  BumpComponents operator[](std::size_t i) const {
    BumpComponents value;
    for (std::size_t k = 0; k < value.size(); ++k) value[k] = element[k][i];
    return value;
  }
  void set(std::size_t i, const BumpComponents& value) {
    for (std::size_t k = 0; k < value.size(); ++k) element[k][i] = value[k];
  }
};

template <>
struct Column<FrameVectors> {
  std::array<Numbers, 3 * kMaxFrameVectors> element;

  FrameVectors operator[](std::size_t i) const {
    FrameVectors value;
    for (std::size_t k = 0; k < value.size(); ++k)
      value[k] = {element[3 * k][i], element[3 * k + 1][i], element[3 * k + 2][i]};
    return value;
  }
  void set(std::size_t i, const FrameVectors& value) {
    for (std::size_t k = 0; k < value.size(); ++k)
      element[3 * k][i] = value[k].x, element[3 * k + 1][i] = value[k].y, element[3 * k + 2][i] = value[k].z;
  }
};

// Never spans two draws.
struct Fragments {
  int count = 0;
  std::uint32_t draw = 0;
  std::array<std::int32_t, kColumnLength> x, y;
  std::array<std::uint32_t, kColumnLength> triangle;  // ScreenTriangle::id
#define WRINKLE_EXACT(type, name, initial, wire) Column<type> name;
#include "golden/exact/fragment.def"
#undef WRINKLE_EXACT

  // Every value of the fragments [first, end) as fragment.def has it.
  void clear(std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
#define WRINKLE_EXACT(type, name, initial, wire) name.set(i, initial);
#include "golden/exact/fragment.def"
#undef WRINKLE_EXACT
    }
  }

  ExactFragment fragment(std::size_t i) const {
    ExactFragment f;
    f.x = x[i], f.y = y[i];
    f.triangle = triangle[i];
    f.draw = draw;
#define WRINKLE_EXACT(type, name, initial, wire) f.name = name[i];
#include "golden/exact/fragment.def"
#undef WRINKLE_EXACT
    return f;
  }
};

}  // namespace wrinkle::exact

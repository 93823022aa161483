// The planes of a configuration, from golden/values.def and the vectors that its datapath has in the place of N.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "golden/config/values.h"

namespace wrinkle {

// One number that is interpolated: an element of a value of `interpolate`.
struct PlaneFormat {
  std::string_view name;  // of the value
  std::size_t element;
  int width;          // without guard bits
  int fraction_bits;  // of the output
  bool is_signed;
  bool is_held;  // over a triangle: `value` alone is sent, without guard bits, rounded by set-up

  bool is(std::string_view value, std::size_t k) const { return name == value && element == k; }
};

// Calls visit(format) of every plane in packet order. The level of detail is a plane with a division only; where it is
// held it has a field of its own, TriangleWords::lod.
template <class Visit>
void for_each_plane(const Shape& c, Visit&& visit) {
  const auto each_element = [&](int elements, PlaneFormat format) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(elements); ++k) {
      format.element = k;
      visit(format);
    }
  };
  const auto each_vector = [&] {
    for (const FrameVector& v : frame_vectors(c))
      if (v.width != 0) each_element(3, {v.name, 0, v.width, v.fraction_bits, true, v.is_held});
  };
#define WRINKLE_FRAME(stage, name, reader) each_vector();
#define WRINKLE_PLANE(name, elements, width, fraction_bits, is_signed, present, reader) \
  if (present) each_element(elements, {#name, 0, width, fraction_bits, is_signed, false});
#define WRINKLE_LEVEL(name, width, fraction_bits, present, reader) \
  if ((present) && c.divides != 0) each_element(1, {#name, 0, width, fraction_bits, true, false});
#include "golden/values.def"
}

// The position in plane_formats() of the first plane of each value; the vectors in the place of N are `frame`. That of
// a value that the configuration lacks is the position of the next.
struct PlanePlaces {
  explicit PlanePlaces(const Shape& c) {
#define WRINKLE_FRAME(stage, name, reader) \
  name = count;                            \
  count += 3 * static_cast<std::size_t>(c.frame_vectors);
#define WRINKLE_PLANE(name, elements, width, fraction_bits, is_signed, present, reader) \
  name = count;                                                                         \
  if (present) count += elements;
#define WRINKLE_LEVEL(name, width, fraction_bits, present, reader) \
  name = count;                                                    \
  if ((present) && c.divides != 0) ++count;
#include "golden/values.def"
  }
#define WRINKLE_FRAME(stage, name, reader) std::size_t name = 0;
#define WRINKLE_PLANE(name, elements, width, fraction_bits, is_signed, present, reader) std::size_t name = 0;
#define WRINKLE_LEVEL(name, width, fraction_bits, present, reader) std::size_t name = 0;
#include "golden/values.def"
  std::size_t count = 0;
};

inline std::vector<PlaneFormat> plane_formats(const Shape& c) {
  std::vector<PlaneFormat> formats;
  formats.reserve(PlanePlaces(c).count);
  for_each_plane(c, [&](const PlaneFormat& format) { formats.push_back(format); });
  return formats;
}

}  // namespace wrinkle

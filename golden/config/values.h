// The values of golden/values.def for a configuration.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "golden/config/config.h"

namespace wrinkle {

// Elements of the largest value: the components of a bump map.
inline constexpr int kMaxElements = 9;

// Vectors in the place of N, at most: as many as properties.def has formats of.
inline constexpr std::size_t kMaxFrameVectors = 3;

struct FrameVector {
  std::string_view name;
  int width, fraction_bits;
  bool is_held;
};
// Those of a datapath; the first `frame_vectors` of them are there.
std::array<FrameVector, kMaxFrameVectors> frame_vectors(const Shape& config);

// Where a value comes from: a plane, a field held over a triangle, components of a texel, or a computation.
enum class ValueKind { plane, held, texel, wire };

struct Value {
  std::string_view stage, name;
  int elements, width, fraction_bits;
  bool is_signed;
  ValueKind kind;
  std::string_view wire;  // of wrinkle_core, on which it lies from `lowest_bit` on, element 0 first
  int lowest_bit, first_element;
};
// Those that the configuration has, in pipeline order.
std::vector<Value> values(const Shape& config);

}  // namespace wrinkle

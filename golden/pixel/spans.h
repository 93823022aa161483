// Spans: what scan hands to interpolate. A span is a run of pixels of one row that lies in one batch.
#pragma once

#include <array>
#include <cstdint>

#include "golden/pixel/pixel.h"

namespace wrinkle {

// Planes padded to a whole number of vectors; where there is no Pu x Pv the first of them are enough.
inline constexpr std::size_t kPlanes = 24;
inline constexpr std::size_t kPlanesWithoutCross = 16;
static_assert(kPlanesWithoutCross >= static_cast<std::size_t>(Component::kAx));
static_assert(kPlanes >= static_cast<std::size_t>(kComponents));

// By Component. Accumulators are left-aligned in Int: the low (bits of Int - width - G) bits are 0.
template <class Int>
using Planes = std::array<Int, kPlanes>;

template <class Int>
struct Span {
  int first = 0, count = 0;  // fragments of the batch
  int w = 0, y = 0;          // walk coordinate of the first pixel
  bool mirror = false;
  bool last = false;  // its last pixel is the last of the packet
  std::uint32_t packet = 0;
  std::int32_t lod = 0;
  alignas(64) Planes<Int> value;  // at the first pixel
  alignas(64) Planes<Int> dw;
};

// The spans of one batch, in the order of its fragments.
template <class Int>
struct Spans {
  int count = 0;
  std::array<Span<Int>, kBatch> span;
};

}  // namespace wrinkle

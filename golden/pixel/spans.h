// Spans: what scan hands to interpolate. A span is a run of pixels of one row that lies in one batch.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "golden/pixel/pixel.h"

namespace wrinkle {

// One number for every plane of a configuration, in packet order, is padded to blocks of so many: loops over a block
// become vectors.
inline constexpr std::size_t kPlaneBlock = 8;
inline std::size_t padded_planes(std::size_t planes) { return (planes + kPlaneBlock - 1) / kPlaneBlock * kPlaneBlock; }

struct Span {
  int first = 0, count = 0;  // fragments of the batch
  int w = 0, y = 0;          // walk coordinate of the first pixel
  bool mirror = false;
  bool last = false;  // its last pixel is the last of the packet
  std::uint32_t packet = 0;
  std::int32_t lod = 0;
};

// The spans of one batch, in the order of its fragments.
template <class Int>
struct Spans {
  // Without planes it is for the stages behind `interpolate` alone.
  explicit Spans(std::size_t planes = 0) : stride(padded_planes(planes)), value(kBatch * stride), dw(kBatch * stride) {}

  int count = 0;
  std::array<Span, kBatch> span;
  // Plane p of span s at its first pixel, and its step, are the numbers s * stride + p. They are left-aligned in Int:
  // the low (bits of Int - width - G) bits are 0.
  std::size_t stride;
  std::vector<Int> value, dw;
};

}  // namespace wrinkle

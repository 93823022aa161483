// The fetch of the texture stage: one scalar loop for every instance. Loads of 64 bits bring a texel and its neighbour;
// gather instructions are slower on the machines of today.
#pragma once

#include <array>
#include <cstdint>

#include "golden/pixel/pixel.h"

namespace wrinkle {

// Per fragment: where its upper left texel lies, the distance of the row below, and the weights of the sample.
template <class Int>
struct TexelAddresses {
  using Column = typename Batch<Int>::Column;
  alignas(64) Column position, stride, weight_u, weight_v;
};

// Rows y and y + 1 of each sample, of texels x (low half) and x + 1.
struct TexelRows {
  using Column = std::array<std::uint64_t, kBatch + kBatchPadding>;
  alignas(64) Column upper, lower;
};

template <class Int>
void fetch(const std::uint32_t* texels, const TexelAddresses<Int>& addresses, int count, TexelRows& rows);

}  // namespace wrinkle

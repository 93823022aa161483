// The fetch of the texture stage: one scalar loop for every instance. One load of 128 bits brings all four texels;
// gather instructions are slower on the machines of today.
#pragma once

#include <array>
#include <cstdint>

#include "golden/pixel/pixel.h"

namespace wrinkle {

// Per fragment: where its upper left texel lies, and the weights of the sample.
template <class Int>
struct TexelAddresses {
  Column<Int> position, weight_u, weight_v;
};

// The four texels of each sample: upper left, lower left, upper right, lower right.
struct TexelQuads {
  alignas(64) std::array<std::uint32_t, 4 * (kBatch + kBatchPadding)> texels;
};

template <class Int>
void fetch(const std::uint32_t* texels, const TexelAddresses<Int>& addresses, int count, TexelQuads& quads);

}  // namespace wrinkle

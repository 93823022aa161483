// The lane that the pixel stages need; the derivations are those of docs/numerics.md.
#pragma once

#include "golden/config/config.h"

namespace wrinkle {

// Bits of the widest intermediate of the pixel stages, sign included. The configuration must be legal.
int widest_operand_bits(const Shape& config);
// Bits of the lane that the golden model takes: 32 or 64.
int lane_bits(const Shape& config);

}  // namespace wrinkle

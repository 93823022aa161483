// The reciprocal square root of the compact normalizers: a table of linear segments as in rsqrt.h, with an
// interpolation that leaves out what the truncated squares and products after it would hide. The Verilog twin is
// rtl/unit/wrinkle_compact_rsqrt.v; its parameters come from rtl/unit/wrinkle_compact_normalizer.v, which repeats the
// table of golden/pixel/compact_geometry.h.
//
//   T       SB + 1 bits, in [2^(SB-1), 2^(SB+1)): the leading bits of a real t in [T, T + 1) 2^-(SB+1), so t is in
//           [1/4, 1)
//   r       u1.RB, approximates 1/sqrt(t), in [1, 2 - 2^-RB]: the leading bit is always set
//
// Look-up, all in integers, n = SB - 1 - k:
//
//   half  = T[SB]                            0: t in [1/4, 1/2)    1: t in [1/2, 1)
//   x     = half ? T >> 1 : T                SB bits, the leading one set: both halves keep SB - 1 bits below it
//   index = {half, x[SB-2 : n]}              2 * 2^k segments
//   dx    = 2^n - 1 - x[n-1 : 0]             from the far end of the segment, so that nothing is subtracted
//   r     = ((base[index] << n) + slope[index] * dx) >> (n + g)
//
// where the product leaves out the dots slope[j] dx[i] with i + j < c: they are worth less than what the table is off.
//
// Table, i = {half, j}:
//
//   root(x) = 2^(RB+g) / sqrt(t of the middle of what x stands for), rounded to nearest
//           = (isqrt(2^(2 (RB+g) + SB + 4 - half) / (2 x + 1)) + 1) >> 1    integer division, integer square root; 63
//           bits
//   x0      = 2^(SB-1) + j 2^n
//   r0, rm, r1 = root(x0), root(x0 + 2^(n-1)), root(x0 + 2^n)
//   slope[i] = r0 - r1
//   base[i]  = r1 + round(slope / 2^n) - ((r0 + r1 + 2 - 2 rm) >> 2) + 2^(g-1) + b
//
// held down so that r stays below 2. A chord lies above the curve by at most the sagitta (r0 + r1) / 2 - rm; half of it
// is taken off, which levels the error. 2^(g-1) turns the final floor into rounding; b makes up for the dots left out.
// With n = 0 the table is direct: slope 0, base root(x0).
#pragma once

#include <cstdint>
#include <vector>

#include "golden/pixel/rsqrt.h"

namespace wrinkle {

struct CompactRsqrtGeometry {
  int input_bits;                                                              // SB + 1
  int output_bits;                                                             // RB
  int segment_bits;                                                            // k: 2^k segments in each half
  int guard_bits;                                                              // g, of base and slope below r
  int bias;                                                                    // b
  int dropped_columns;                                                         // c
  constexpr int offset_bits() const { return input_bits - 2 - segment_bits; }  // n
};

// 2 * 2^k segments, by index: value = (base << n) + slope * dx.
std::vector<Segment> compact_rsqrt_table(const CompactRsqrtGeometry& geometry);

// r of one T in [2^(SB-1), 2^(SB+1)).
std::int64_t compact_rsqrt(const CompactRsqrtGeometry& geometry, const std::vector<Segment>& table, std::int64_t t);

}  // namespace wrinkle

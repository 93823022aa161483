// The reciprocal of the perspective division: a table of linear segments. The Verilog twin is
// rtl/unit/wrinkle_reciprocal.v.
//
//   m       Q bits, in [2^(Q-1), 2^Q), exact
//   r       u1.R, approximates 2^Q / m, in [1, 2 - 2^-R]
//
// Look-up, s = min(ceil(R/2), Q - 1), n = Q - 1 - s, g = 2:
//
//   index = m[Q-2 : n]                       2^s segments
//   dx    = m[n-1 : 0]                       0 where n = 0
//   r     = min(((base[index] << n) - slope[index] * dx) >> (n + g), 2^(R+1) - 1)
//
// Table:
//
//   root(x) = 2^(R+g+Q) / (x / 2), rounded to nearest
//           = ((2^(R+g+Q+2) / x) + 1) >> 1                  integer division; 49 bits
//   m0 = 2^(Q-1) + (j << n)
//   r0, rm, r1 = root(2 m0), root(2 m0 + 2^n), root(2 m0 + 2 * 2^n)
//   slope[j] = r0 - r1
//   base[j]  = r0 - (n > 0 ? (r0 + r1 - 2 rm + 2) >> 2 : 0) + 2^(g-1)
//
// Error: |r 2^-R - 2^Q / m| <= 2^-R, for every m [tests/stage/tables_test.cpp, every m of every legal R and Q]. The
// bound is met at m = 2^(Q-1), where 2 is clamped.
#pragma once

#include <cstdint>
#include <vector>

#include "golden/pixel/rsqrt.h"

namespace wrinkle {

inline constexpr int kReciprocalGuard = 2;  // g

// What the two widths decide.
struct ReciprocalGeometry {
  int input_bits;   // Q, 8 to 24
  int output_bits;  // R, 8 to 20
  constexpr int segment_bits() const {
    const int s = (output_bits + 1) / 2;
    return s < input_bits - 1 ? s : input_bits - 1;
  }
  constexpr int offset_bits() const { return input_bits - 1 - segment_bits(); }  // n
};

// 2^s segments, by index.
std::vector<Segment> reciprocal_table(const ReciprocalGeometry& geometry);

// r of one m in [2^(Q-1), 2^Q).
std::int64_t reciprocal(const ReciprocalGeometry& geometry, const std::vector<Segment>& table, std::int64_t m);

}  // namespace wrinkle

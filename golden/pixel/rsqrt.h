// The reciprocal square root of the normalizer: a table of linear segments, small enough for logic, accurate enough
// that the normalized vector is faithful. The Verilog twin is rtl/unit/wrinkle_rsqrt.v; its localparams are
// kRsqrtGeometry.
//
//   T       SB bits, in [2^(SB-2), 2^SB): the leading bits of a real t in [T, T + 1) 2^-SB, so t is in [1/4, 1)
//   r       u1.RB, approximates 1/sqrt(t), in [1, 2 - 2^-RB]: the leading bit is always set
//
// Look-up, all in integers, n = SB - 1 - k:
//
//   half  = T[SB-1]                          0: t in [1/4, 1/2)    1: t in [1/2, 1)
//   x     = half ? T : T << 1                the segments of the two halves are then alike; x[SB-1] is 1
//   index = {half, x[SB-2 : n]}              2 * 2^k segments
//   dx    = x[n-1 : 0]
//   r     = min(((base[index] << n) - slope[index] * dx) >> (n + g), 2^(RB+1) - 1)
//
// Table, i = {half, j}:
//
//   root(T) = 2^(RB+g) / sqrt((T + 1/2) 2^-SB), rounded to nearest
//           = (isqrt(2^(2 (RB+g) + SB + 3) / (2 T + 1)) + 1) >> 1           integer division, integer square root; 63
//           bits
//   step    = 2^(SB - 2 - k + half)          T0 = 2^(SB - 2 + half) + j * step
//   r0, rm, r1 = root(T0), root(T0 + step / 2), root(T0 + step)
//   slope[i] = r0 - r1
//   base[i]  = r0 - ((r0 + r1 - 2 rm + 2) >> 2) + 2^(g-1)
//
// A chord lies above the curve by at most the sagitta (r0 + r1) / 2 - rm; half of it is taken off, which levels the
// error. 2^(g-1) turns the final floor into rounding. T + 1/2 is the middle of what T stands for.
//
// Proof of faithfulness [tests/stage/tables_test.cpp, exact integers]: a component before rounding is |n_i| r sqrt(t)
// with |n_i| <= 1, and r depends on T alone. So rho = 2^F max over T, t of |r sqrt(t) - 1| bounds the error of every
// vector of every length and width, in ulp; it is below 1/2 for every F, hence the rounded result is off by less than 1
// ulp, and a vector along an axis, where |n_i| = 1, gives exactly 2^F.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace wrinkle {

struct RsqrtGeometry {
  int unit_bits;                                                               // F
  int input_bits;                                                              // SB
  int output_bits;                                                             // RB
  int segment_bits;                                                            // k: 2^k segments in each half
  int guard_bits;                                                              // g, of base and slope below r
  constexpr int offset_bits() const { return input_bits - 1 - segment_bits; }  // n
};

// The cheapest faithful geometry of every F, found by search over SB, RB, k, g; cost = full adders of the interpolation
// and of the three output products + table bits. The last column is rho, proven.
inline constexpr std::array<RsqrtGeometry, 11> kRsqrtGeometry{{
    // F  SB  RB  k  g      rho
    {6, 8, 7, 3, 1},     // .4235
    {7, 9, 8, 3, 1},     // .4448
    {8, 10, 9, 4, 1},    // .4357
    {9, 12, 10, 4, 1},   // .4584
    {10, 13, 11, 4, 1},  // .4969
    {11, 14, 12, 5, 1},  // .4887
    {12, 15, 13, 5, 2},  // .4577
    {13, 16, 14, 6, 1},  // .4943
    {14, 17, 15, 6, 2},  // .4489
    {15, 19, 17, 6, 2},  // .4943
    {16, 19, 17, 7, 2},  // .4705
}};

// unit_bits in [6, 16].
constexpr const RsqrtGeometry& rsqrt_geometry(int unit_bits) {
  return kRsqrtGeometry[static_cast<std::size_t>(unit_bits - 6)];
}

// One linear segment of a table: value = (base << n) - slope * dx.
struct Segment {
  std::int32_t base = 0, slope = 0;
};

// 2 * 2^k segments, by index.
std::vector<Segment> rsqrt_table(const RsqrtGeometry& geometry);

// r of one T in [2^(SB-2), 2^SB).
std::int64_t rsqrt(const RsqrtGeometry& geometry, const std::vector<Segment>& table, std::int64_t t);

// Largest integer whose square is at most x.
std::uint64_t isqrt(std::uint64_t x);

}  // namespace wrinkle

// Widths and cuts of the normalizers `compact`, `lite` and `near`, by kind, F and V;
// rtl/unit/wrinkle_compact_normalizer.v has the same as localparams.
//
//   m    magnitude, P = max(V, F) + 1 bits: |v| with zeros below where V < F
//   S    sum of squares in 2 P + 2 bits; each m^2 without the square of its low A bits, and a constant for their mean
//   r    1/sqrt(S) from compact_rsqrt.h
//   n    m r >> Q, Q = RB + P - F: m taken two bits at a time, each row (two bits of m) * r without its part in the
//        columns below `product_cut`; a constant rounds and makes up for the mean of what is left out
//
// The proof that these cuts leave every component within 1 ulp, for every F and V, is tests/stage/tables_test.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "golden/config/config.h"
#include "golden/pixel/compact_rsqrt.h"

namespace wrinkle {

struct CompactGeometry {
  Normalizer kind;
  int unit_bits;       // F
  int magnitude_bits;  // P
  int padding;         // zeros below |v|
  CompactRsqrtGeometry rsqrt;
  int square_bits;  // leading bits of m that are squared: P, fewer with `lite`
  int square_cut;   // A
  std::int64_t square_constant;
  int product_cut;
  std::int64_t product_constant;  // with the half that rounds
  constexpr int product_shift() const { return rsqrt.output_bits + magnitude_bits - unit_bits; }  // Q
};

// The cheapest faithful geometry of every F found by search, at V = F.
struct CompactCuts {
  CompactRsqrtGeometry rsqrt;
  int square_cut, product_cut;
};
inline constexpr std::array<CompactCuts, 11> kCompactCuts{{
    // SB+1 RB  k  g  b  c      A  product_cut
    {{9, 8, 3, 2, 1, 4}, 1, 5},     // F = 6
    {{10, 9, 3, 2, 0, 5}, 2, 7},    // 7
    {{11, 10, 4, 2, 0, 4}, 2, 8},   // 8
    {{12, 11, 4, 1, 1, 5}, 3, 7},   // 9
    {{14, 12, 4, 1, 0, 6}, 3, 8},   // 10
    {{15, 13, 5, 1, 1, 7}, 4, 9},   // 11
    {{16, 14, 5, 1, 0, 7}, 4, 9},   // 12
    {{17, 15, 6, 2, 1, 8}, 4, 12},  // 13
    {{18, 16, 6, 1, 0, 8}, 5, 11},  // 14
    {{19, 17, 7, 1, 1, 9}, 5, 12},  // 15
    {{20, 18, 7, 1, 1, 9}, 6, 11},  // 16
}};

// `lite`: 64 roots of the leading bits of a sum of squares of 7 bits. Only the length is off by that.
inline constexpr CompactRsqrtGeometry kLiteRsqrt{7, 7, 5, 0, 0, 0};
inline constexpr int kLiteSquareBits = 7;
inline constexpr std::int64_t kLiteSquareConstant = 96;

// Each bit of V above F moves the cut up by one; more rows then leave something out.
constexpr int product_cut(int at_equal_widths, int wider) {
  return at_equal_widths + wider - (wider > 0 ? 1 : 0) - (wider > 7 ? 1 : 0) - (wider > 11 ? 1 : 0);
}

// Vectors in s1.V, V = `vector_bits`. Not for `none` and `faithful`.
constexpr CompactGeometry compact_geometry(Normalizer kind, int unit_bits, int vector_bits) {
  CompactGeometry g{};
  g.kind = kind;
  g.unit_bits = unit_bits;
  g.padding = std::max(unit_bits - vector_bits, 0);
  g.magnitude_bits = vector_bits + 1 + g.padding;
  if (kind == Normalizer::kLite) {
    g.rsqrt = kLiteRsqrt;
    g.square_bits = kLiteSquareBits;
    g.square_constant = kLiteSquareConstant;
  } else {
    const CompactCuts& c = kCompactCuts[static_cast<std::size_t>(unit_bits - 6)];
    const int wider = std::max(vector_bits - unit_bits, 0);
    g.rsqrt = c.rsqrt;
    g.square_bits = g.magnitude_bits;
    g.square_cut = c.square_cut + wider;
    g.product_cut = product_cut(c.product_cut, wider);
    // Half of the most that is left out, rounded to the lowest column that is kept.
    const std::int64_t low = (std::int64_t{1} << g.square_cut) - 1, unit = std::int64_t{2} << g.square_cut;
    g.square_constant = (3 * low * low + unit) / (2 * unit) * unit;
    const std::int64_t one = std::int64_t{1} << g.product_cut;
    for (int i = 0; i < g.product_cut; i += 2) g.product_constant += one - (std::int64_t{1} << i);
    g.product_constant = (g.product_constant + one) / (2 * one) * one;
  }
  g.product_constant += std::int64_t{1} << (g.product_shift() - 1);
  return g;
}

// The table that both `compact` and `near` look up at this F.
constexpr const CompactRsqrtGeometry& compact_rsqrt_geometry(int unit_bits) {
  return kCompactCuts[static_cast<std::size_t>(unit_bits - 6)].rsqrt;
}

}  // namespace wrinkle

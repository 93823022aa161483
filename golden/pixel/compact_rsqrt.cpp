#include "golden/pixel/compact_rsqrt.h"

#include <algorithm>

namespace wrinkle {
namespace {

std::int64_t root(const CompactRsqrtGeometry& g, std::int64_t x, int half) {
  const int exponent = 2 * (g.output_bits + g.guard_bits) + g.input_bits + 3 - half;
  const auto quotient = (std::uint64_t{1} << exponent) / static_cast<std::uint64_t>(2 * x + 1);
  return static_cast<std::int64_t>((isqrt(quotient) + 1) >> 1);
}

// The segment from x0 on.
Segment segment(const CompactRsqrtGeometry& g, std::int64_t x0, int half) {
  const int n = g.offset_bits();
  const std::int64_t width = std::int64_t{1} << n, r0 = root(g, x0, half);
  std::int64_t base = r0, slope = 0;
  if (n > 0) {
    const std::int64_t rm = root(g, x0 + width / 2, half), r1 = root(g, x0 + width, half);
    const std::int64_t rounding = g.guard_bits > 0 ? std::int64_t{1} << (g.guard_bits - 1) : 0;
    slope = r0 - r1;
    base = r1 + ((slope + width / 2) >> n) - ((r0 + r1 + 2 - 2 * rm) >> 2) + rounding + g.bias;
  }
  const std::int64_t largest = (std::int64_t{2} << (g.output_bits + g.guard_bits + n)) - 1;
  base = std::min(base, (largest - slope * (width - 1)) >> n);
  return {static_cast<std::int32_t>(base), static_cast<std::int32_t>(slope)};
}

}  // namespace

std::vector<Segment> compact_rsqrt_table(const CompactRsqrtGeometry& g) {
  std::vector<Segment> table;
  for (int half = 0; half < 2; ++half)
    for (std::int64_t j = 0; j < std::int64_t{1} << g.segment_bits; ++j)
      table.push_back(segment(g, (std::int64_t{1} << (g.input_bits - 2)) + (j << g.offset_bits()), half));
  return table;
}

std::int64_t compact_rsqrt(const CompactRsqrtGeometry& g, const std::vector<Segment>& table, std::int64_t t) {
  const int n = g.offset_bits();
  const std::int64_t half = t >> (g.input_bits - 1), x = t >> half;
  const std::int64_t index = (half << g.segment_bits) | ((x >> n) & ((1 << g.segment_bits) - 1));
  const std::int64_t dx = ~x & ((std::int64_t{1} << n) - 1), kept = -(std::int64_t{1} << g.dropped_columns);
  const Segment& s = table[static_cast<std::size_t>(index)];
  std::int64_t line = std::int64_t{s.base} << n;
  for (int i = 0; i < n; ++i) line += ((dx & (1 << i)) * s.slope) & kept;
  return line >> (n + g.guard_bits);
}

}  // namespace wrinkle

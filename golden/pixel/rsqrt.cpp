#include "golden/pixel/rsqrt.h"

#include <algorithm>

namespace wrinkle {

std::uint64_t isqrt(std::uint64_t x) {
  std::uint64_t root = 0;
  for (int bit = 62; bit >= 0; bit -= 2) {
    const std::uint64_t trial = root + (std::uint64_t{1} << bit);
    root >>= 1;
    if (x >= trial) {
      x -= trial;
      root += std::uint64_t{1} << bit;
    }
  }
  return root;
}

namespace {

std::int64_t root(const RsqrtGeometry& g, std::int64_t t) {
  const int exponent = 2 * (g.output_bits + g.guard_bits) + g.input_bits + 3;
  const auto quotient = (std::uint64_t{1} << exponent) / static_cast<std::uint64_t>(2 * t + 1);
  return static_cast<std::int64_t>((isqrt(quotient) + 1) >> 1);
}

}  // namespace

std::vector<Segment> rsqrt_table(const RsqrtGeometry& g) {
  std::vector<Segment> table;
  for (int half = 0; half < 2; ++half) {
    const std::int64_t step = std::int64_t{1} << (g.input_bits - 2 - g.segment_bits + half);
    for (int j = 0; j < 1 << g.segment_bits; ++j) {
      const std::int64_t t0 = (std::int64_t{1} << (g.input_bits - 2 + half)) + j * step;
      const std::int64_t r0 = root(g, t0), rm = root(g, t0 + step / 2), r1 = root(g, t0 + step);
      const std::int64_t base = r0 - ((r0 + r1 - 2 * rm + 2) >> 2) + (1 << (g.guard_bits - 1));
      table.push_back({static_cast<std::int32_t>(base), static_cast<std::int32_t>(r0 - r1)});
    }
  }
  return table;
}

std::int64_t rsqrt(const RsqrtGeometry& g, const std::vector<Segment>& table, std::int64_t t) {
  const int n = g.offset_bits();
  const std::int64_t half = t >> (g.input_bits - 1);
  const std::int64_t x = half != 0 ? t : t << 1;
  const std::int64_t index = (half << g.segment_bits) | ((x >> n) & ((1 << g.segment_bits) - 1));
  const std::int64_t dx = x & ((1 << n) - 1);
  const Segment& s = table[static_cast<std::size_t>(index)];
  const std::int64_t r = ((std::int64_t{s.base} << n) - s.slope * dx) >> (n + g.guard_bits);
  return std::min(r, (std::int64_t{2} << g.output_bits) - 1);
}

}  // namespace wrinkle

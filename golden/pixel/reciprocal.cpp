#include "golden/pixel/reciprocal.h"

#include <algorithm>

namespace wrinkle {

std::vector<Segment> reciprocal_table(const ReciprocalGeometry& g) {
  const int n = g.offset_bits();
  const std::int64_t numerator = std::int64_t{1} << (g.output_bits + kReciprocalGuard + g.input_bits + 2);
  const auto root = [&](std::int64_t x) { return (numerator / x + 1) >> 1; };
  std::vector<Segment> table;
  for (std::int64_t j = 0; j < std::int64_t{1} << g.segment_bits(); ++j) {
    const std::int64_t m0 = (std::int64_t{1} << (g.input_bits - 1)) + (j << n);
    const std::int64_t width = std::int64_t{1} << n;
    const std::int64_t r0 = root(2 * m0), rm = root(2 * m0 + width), r1 = root(2 * m0 + 2 * width);
    const std::int64_t sagitta = n > 0 ? (r0 + r1 - 2 * rm + 2) >> 2 : 0;
    const std::int64_t base = r0 - sagitta + (1 << (kReciprocalGuard - 1));
    table.push_back({static_cast<std::int32_t>(base), static_cast<std::int32_t>(r0 - r1)});
  }
  return table;
}

std::int64_t reciprocal(const ReciprocalGeometry& g, const std::vector<Segment>& table, std::int64_t m) {
  const int n = g.offset_bits();
  const std::int64_t index = (m >> n) & ((1 << g.segment_bits()) - 1);
  const std::int64_t dx = m & ((1 << n) - 1);
  const Segment& s = table[static_cast<std::size_t>(index)];
  const std::int64_t r = ((std::int64_t{s.base} << n) - s.slope * dx) >> (n + kReciprocalGuard);
  return std::min(r, (std::int64_t{2} << g.output_bits) - 1);
}

}  // namespace wrinkle

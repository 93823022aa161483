// Division of integers that rounds towards -infinity, +infinity or to nearest, for any sign of the dividend.
#pragma once

#include <cstdint>

namespace wrinkle {

using Wide = __int128;

// b > 0. Products of the set-up seldom need more than 64 bits, and their division is several times faster.
constexpr std::int64_t floor_divide(std::int64_t a, std::int64_t b) { return a / b - (a % b < 0 ? 1 : 0); }
constexpr std::int64_t ceil_divide(std::int64_t a, std::int64_t b) { return a / b + (a % b > 0 ? 1 : 0); }
constexpr Wide floor_divide(Wide a, Wide b) {
  if (a == static_cast<std::int64_t>(a) && b == static_cast<std::int64_t>(b)) {
    return floor_divide(static_cast<std::int64_t>(a), static_cast<std::int64_t>(b));
  }
  return a / b - (a % b < 0 ? 1 : 0);
}
// a / b, ties towards +infinity.
constexpr Wide round_divide(Wide a, Wide b) { return floor_divide(2 * a + b, 2 * b); }

}  // namespace wrinkle

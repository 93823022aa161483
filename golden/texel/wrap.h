// What lies beyond the border of a texture.
#pragma once

#include <algorithm>
#include <cstdint>

namespace wrinkle {

enum class Wrap : std::uint8_t { kRepeat = 0, kClamp = 1, kMirror = 2 };

// Along u and along v.
struct Wraps {
  Wrap u = Wrap::kRepeat, v = Wrap::kRepeat;
};

// The sample of `size` that stands for sample `i`, which may lie outside.
inline int wrapped(int i, int size, Wrap wrap) {
  if (wrap == Wrap::kClamp) return std::clamp(i, 0, size - 1);
  const int period = wrap == Wrap::kMirror ? 2 * size : size;
  const int r = i % period;
  const int within = r < 0 ? r + period : r;
  return within < size ? within : period - 1 - within;
}

}  // namespace wrinkle

// A rectangle of samples, row 0 at the top of the image.
#pragma once

#include <cstddef>
#include <vector>

#include "golden/texel/wrap.h"

namespace wrinkle {

template <class T>
struct Grid {
  int width = 0, height = 0;
  std::vector<T> samples;

  Grid() = default;
  Grid(int w, int h, T value = {})
      : width(w), height(h), samples(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), value) {}

  T& at(int x, int y) { return samples[index(x, y)]; }
  const T& at(int x, int y) const { return samples[index(x, y)]; }
  // The sample at a position that may lie outside.
  const T& at(int x, int y, Wraps wraps) const { return at(wrapped(x, width, wraps.u), wrapped(y, height, wraps.v)); }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

}  // namespace wrinkle

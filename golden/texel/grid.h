// A rectangle of samples, row 0 at the top of the image.
#pragma once

#include <cstddef>
#include <vector>

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
  // The sample at a position outside, as if the grid were repeated without end.
  const T& repeat(int x, int y) const { return at(wrap(x, width), wrap(y, height)); }

 private:
  static int wrap(int i, int n) {
    const int r = i % n;
    return r < 0 ? r + n : r;
  }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

}  // namespace wrinkle

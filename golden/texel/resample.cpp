#include <algorithm>
#include <bit>
#include <cmath>

#include "golden/texel/normal_map.h"

namespace wrinkle {
namespace {

// What one sample of the result is made of along one axis: `weights` of consecutive samples from `first` on.
struct Span {
  int first = 0;
  std::vector<double> weights;
};

Span bilinear_span(int i, int from, int to) {
  const double position = (i + 0.5) * from / to - 0.5;
  const double base = std::floor(position);
  return {static_cast<int>(base), {1 - (position - base), position - base}};
}

Span area_span(int i, int from, int to) {
  const double begin = static_cast<double>(i) * from / to, end = static_cast<double>(i + 1) * from / to;
  Span span{static_cast<int>(std::floor(begin)), {}};
  for (int k = span.first; k < end; ++k) {
    span.weights.push_back((std::min<double>(k + 1, end) - std::max<double>(k, begin)) / (end - begin));
  }
  return span;
}

Span span_of(int i, int from, int to) { return to >= from ? bilinear_span(i, from, to) : area_span(i, from, to); }

template <class T>
Grid<T> resample_rows(const Grid<T>& grid, int width, Wraps wraps) {
  Grid<T> result(width, grid.height);
  for (int x = 0; x < width; ++x) {
    const Span span = span_of(x, grid.width, width);
    for (int y = 0; y < grid.height; ++y) {
      T sum{};
      for (std::size_t k = 0; k < span.weights.size(); ++k) {
        sum = sum + span.weights[k] * grid.at(span.first + static_cast<int>(k), y, wraps);
      }
      result.at(x, y) = sum;
    }
  }
  return result;
}

template <class T>
Grid<T> resample_columns(const Grid<T>& grid, int height, Wraps wraps) {
  Grid<T> result(grid.width, height);
  for (int y = 0; y < height; ++y) {
    const Span span = span_of(y, grid.height, height);
    for (int x = 0; x < grid.width; ++x) {
      T sum{};
      for (std::size_t k = 0; k < span.weights.size(); ++k) {
        sum = sum + span.weights[k] * grid.at(x, span.first + static_cast<int>(k), wraps);
      }
      result.at(x, y) = sum;
    }
  }
  return result;
}

int power_of_two(int size) {
  return std::min(static_cast<int>(std::bit_ceil(static_cast<unsigned>(size))), 1 << kMaxLog2Size);
}

}  // namespace

template <class T>
Grid<T> resample(const Grid<T>& grid, int width, int height, Wraps wraps) {
  if (width == grid.width && height == grid.height) return grid;
  if (width == grid.width) return resample_columns(grid, height, wraps);
  if (height == grid.height) return resample_rows(grid, width, wraps);
  return resample_columns(resample_rows(grid, width, wraps), height, wraps);
}

template <class T>
Grid<T> resample_to_power_of_two(const Grid<T>& grid, Wraps wraps) {
  return resample(grid, power_of_two(grid.width), power_of_two(grid.height), wraps);
}

template <class T>
Grid<T> halve(const Grid<T>& grid) {
  const int sx = grid.width > 1 ? 2 : 1, sy = grid.height > 1 ? 2 : 1;
  Grid<T> result(grid.width / sx, grid.height / sy);
  for (int y = 0; y < result.height; ++y) {
    for (int x = 0; x < result.width; ++x) {
      const T& a = grid.at(sx * x, sy * y);
      const T& b = grid.at(sx * x + sx - 1, sy * y);
      const T& c = grid.at(sx * x, sy * y + sy - 1);
      const T& d = grid.at(sx * x + sx - 1, sy * y + sy - 1);
      result.at(x, y) = 0.25 * ((a + b) + (c + d));
    }
  }
  return result;
}

template Grid<double> resample(const Grid<double>&, int, int, Wraps);
template Grid<Vec3> resample(const Grid<Vec3>&, int, int, Wraps);
template Grid<double> resample_to_power_of_two(const Grid<double>&, Wraps);
template Grid<Vec3> resample_to_power_of_two(const Grid<Vec3>&, Wraps);
template Grid<double> halve(const Grid<double>&);
template Grid<Vec3> halve(const Grid<Vec3>&);

}  // namespace wrinkle

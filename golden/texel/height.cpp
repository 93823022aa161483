#include "golden/texel/height.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace wrinkle {
namespace {

constexpr int kReach = 3;  // seven samples
using Kernel = std::array<double, 2 * kReach + 1>;

double gaussian(int i) { return std::exp(-0.5 * i * i); }

// Weights of a mean: they add up to 1.
Kernel smoothing_kernel() {
  Kernel kernel{};
  double sum = 0;
  for (int i = -kReach; i <= kReach; ++i) sum += gaussian(i);
  for (int i = -kReach; i <= kReach; ++i) kernel[static_cast<std::size_t>(i + kReach)] = gaussian(i) / sum;
  return kernel;
}

// Weights of a derivative: of the samples of f(i) = i they make 1.
Kernel derivative_kernel() {
  Kernel kernel{};
  double sum = 0;
  for (int i = -kReach; i <= kReach; ++i) sum += i * i * gaussian(i);
  for (int i = -kReach; i <= kReach; ++i) kernel[static_cast<std::size_t>(i + kReach)] = i * gaussian(i) / sum;
  return kernel;
}

// What stands at sample `i` of a line of `size`, which may lie outside. Where the texture is clamped the line goes on
// turned about its last sample, so that a slope goes on as it is.
template <class Line>
double beyond(const Line& line, int i, int size, Wrap wrap) {
  if (i >= 0 && i < size) return line(i);
  if (wrap != Wrap::kClamp) return line(wrapped(i, size, wrap));
  const int border = i < 0 ? 0 : size - 1;
  return 2 * line(border) - line(std::clamp(2 * border - i, 0, size - 1));
}

Grid<double> convolve_rows(const Grid<double>& grid, const Kernel& kernel, Wraps wraps) {
  Grid<double> result(grid.width, grid.height);
  for (int y = 0; y < grid.height; ++y) {
    const auto row = [&](int x) { return grid.at(x, y); };
    for (int x = 0; x < grid.width; ++x) {
      for (int i = -kReach; i <= kReach; ++i) {
        result.at(x, y) += kernel[static_cast<std::size_t>(i + kReach)] * beyond(row, x + i, grid.width, wraps.u);
      }
    }
  }
  return result;
}

Grid<double> convolve_columns(const Grid<double>& grid, const Kernel& kernel, Wraps wraps) {
  Grid<double> result(grid.width, grid.height);
  for (int y = 0; y < grid.height; ++y) {
    for (int i = -kReach; i <= kReach; ++i) {
      const double weight = kernel[static_cast<std::size_t>(i + kReach)];
      for (int x = 0; x < grid.width; ++x) {
        const auto column = [&](int j) { return grid.at(x, j); };
        result.at(x, y) += weight * beyond(column, y + i, grid.height, wraps.v);
      }
    }
  }
  return result;
}

// 1 on the raised vanes, 0 elsewhere; x, y from the centre of the unit square.
double vane(double x, double y) {
  constexpr double kHub = 0.06, kRim = 0.45, kTwist = 1.2;
  constexpr int kVanes = 12;
  const double r = std::hypot(x, y);
  if (r < kHub || r > kRim) return 0;
  const double turn = (std::atan2(y, x) + kTwist * (r / kRim)) / (2 * std::numbers::pi);
  const double within = kVanes / 2 * turn;
  return within - std::floor(within) < 0.5 ? 1 : 0;
}

}  // namespace

Grid<Vec2> gradients(const Grid<double>& height, Wraps wraps) {
  static const Kernel kSmoothing = smoothing_kernel(), kDerivative = derivative_kernel();
  const Grid<double> by_x = convolve_columns(convolve_rows(height, kDerivative, wraps), kSmoothing, wraps);
  const Grid<double> by_y = convolve_columns(convolve_rows(height, kSmoothing, wraps), kDerivative, wraps);
  Grid<Vec2> result(height.width, height.height);
  for (std::size_t i = 0; i < result.samples.size(); ++i) {
    result.samples[i] = {height.width * by_x.samples[i], -height.height * by_y.samples[i]};
  }
  return result;
}

Vec2 SampledHeightField::gradient(double u, double v) const {
  const double x = u * gradients_.width - 0.5, y = (1 - v) * gradients_.height - 0.5;
  const double x0 = std::floor(x), y0 = std::floor(y), fx = x - x0, fy = y - y0;
  const int ix = static_cast<int>(x0), iy = static_cast<int>(y0);
  const auto row = [&](int j) {
    return (1 - fx) * gradients_.at(ix, j, wraps_) + fx * gradients_.at(ix + 1, j, wraps_);
  };
  return (1 - fy) * row(iy) + fy * row(iy + 1);
}

Grid<double> pinwheel(int size, double amplitude) {
  constexpr int kSub = 4;  // 4 x 4 samples a texel
  Grid<double> height(size, size);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      double sum = 0;
      for (int j = 0; j < kSub; ++j) {
        for (int i = 0; i < kSub; ++i) {
          sum += vane((x + (i + 0.5) / kSub) / size - 0.5, 0.5 - (y + (j + 0.5) / kSub) / size);
        }
      }
      height.at(x, y) = amplitude * sum / (kSub * kSub);
    }
  }
  return height;
}

}  // namespace wrinkle

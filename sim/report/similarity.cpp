#include "sim/report/similarity.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace wrinkle {
namespace {

using Plane = std::vector<double>;

constexpr int kRadius = 5;
constexpr double kSigma = 1.5;

std::array<double, 2 * kRadius + 1> gaussian() {
  std::array<double, 2 * kRadius + 1> weights{};
  double sum = 0;
  for (int i = -kRadius; i <= kRadius; ++i)
    sum += weights[std::size_t(i + kRadius)] = std::exp(-i * i / (2 * kSigma * kSigma));
  for (double& weight : weights) weight /= sum;
  return weights;
}

// Blurs along rows or along columns. Beyond the border the picture continues with its outermost pixel.
Plane blur_axis(const Plane& in, int width, int height, bool along_rows) {
  static const auto weights = gaussian();
  Plane out(in.size());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      double sum = 0;
      for (int i = -kRadius; i <= kRadius; ++i) {
        const int xi = along_rows ? std::clamp(x + i, 0, width - 1) : x;
        const int yi = along_rows ? y : std::clamp(y + i, 0, height - 1);
        sum += weights[std::size_t(i + kRadius)] * in[std::size_t(yi) * std::size_t(width) + std::size_t(xi)];
      }
      out[std::size_t(y) * std::size_t(width) + std::size_t(x)] = sum;
    }
  }
  return out;
}

Plane blur(const Plane& in, const Picture& like) {
  return blur_axis(blur_axis(in, like.width, like.height, true), like.width, like.height, false);
}

Plane luminance(const Picture& picture) {
  Plane plane(std::size_t(picture.width) * std::size_t(picture.height));
  const std::size_t n = picture.channels.size();
  for (std::size_t i = 0; i < plane.size(); ++i) {
    const float* pixel = &picture.data[n * i];
    plane[i] =
        n < 3 ? double(pixel[0]) : .2126 * double(pixel[0]) + .7152 * double(pixel[1]) + .0722 * double(pixel[2]);
  }
  return plane;
}

Plane product(const Plane& a, const Plane& b) {
  Plane out(a.size());
  std::transform(a.begin(), a.end(), b.begin(), out.begin(), std::multiplies<>());
  return out;
}

}  // namespace

double structural_similarity(const Picture& a, const Picture& b, const std::vector<std::uint8_t>& mask) {
  constexpr double kC1 = .01 * .01, kC2 = .03 * .03;
  const Plane x = luminance(a), y = luminance(b);
  const Plane mean_x = blur(x, a), mean_y = blur(y, a);
  const Plane xx = blur(product(x, x), a), yy = blur(product(y, y), a), xy = blur(product(x, y), a);
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (!mask[i]) continue;
    const double mx = mean_x[i], my = mean_y[i];
    const double luminances = (2 * mx * my + kC1) / (mx * mx + my * my + kC1);
    const double structures = (2 * (xy[i] - mx * my) + kC2) / (xx[i] - mx * mx + yy[i] - my * my + kC2);
    sum += luminances * structures;
    ++count;
  }
  return count > 0 ? sum / double(count) : 1;
}

double error_percentile(const Picture& a, const Picture& b, const std::vector<std::uint8_t>& mask, double rank) {
  std::vector<double> errors;
  const std::size_t n = a.channels.size();
  for (std::size_t i = 0; i < mask.size(); ++i) {
    for (std::size_t c = 0; mask[i] && c < n; ++c)
      errors.push_back(std::abs(double(a.data[n * i + c]) - double(b.data[n * i + c])));
  }
  if (errors.empty()) return 0;
  const auto at = errors.begin() + std::ptrdiff_t(rank * double(errors.size() - 1));
  std::nth_element(errors.begin(), at, errors.end());
  return *at;
}

}  // namespace wrinkle

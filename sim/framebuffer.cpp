#include "sim/framebuffer.h"

#include <algorithm>
#include <utility>

namespace wrinkle {

Framebuffer::Framebuffer(int width, int height, std::array<double, 3> background, bool depth_test,
                         std::vector<std::string> aov_channels)
    : width_(width), height_(height), depth_test_(depth_test), aov_channels_(std::move(aov_channels)) {
  const std::size_t pixels = std::size_t(width) * std::size_t(height);
  colour_.assign(pixels, background);
  depth_.assign(pixels, std::numeric_limits<double>::infinity());
  aov_.assign(pixels * aov_channels_.size(), 0);
  covered_.assign(pixels, 0);
}

void Framebuffer::add(const Sample& sample) {
  if (sample.x < 0 || sample.x >= width_ || sample.y < 0 || sample.y >= height_) {
    ++outside_;
    return;
  }
  const std::size_t at = std::size_t(sample.y) * std::size_t(width_) + std::size_t(sample.x);
  if (depth_test_ && sample.z >= depth_[at]) return;
  depth_[at] = sample.z;
  colour_[at] = sample.colour;
  covered_[at] = 1;
  std::copy(sample.aov.begin(), sample.aov.end(), aov_.begin() + std::ptrdiff_t(at * aov_channels_.size()));
}

Picture Framebuffer::colour() const {
  Picture image(width_, height_, {"R", "G", "B"});
  for (std::size_t i = 0; i < colour_.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) image.data[3 * i + c] = float(colour_[i][c]);
  return image;
}

Picture Framebuffer::all_channels() const {
  std::vector<std::string> names{"R", "G", "B"};
  names.insert(names.end(), aov_channels_.begin(), aov_channels_.end());
  Picture image(width_, height_, std::move(names));
  const std::size_t stride = 3 + aov_channels_.size();
  for (std::size_t i = 0; i < colour_.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) image.data[stride * i + c] = float(colour_[i][c]);
    for (std::size_t c = 0; c < aov_channels_.size(); ++c)
      image.data[stride * i + 3 + c] = float(aov_[i * aov_channels_.size() + c]);
  }
  return image;
}

}  // namespace wrinkle

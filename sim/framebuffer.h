// Fragments of any engine end here: there is a depth test, a colour, and the intermediate values that were asked for.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "sim/picture.h"

namespace wrinkle {

// A fragment as all engines give it. A double holds fixed-point values exactly.
struct Sample {
  std::int32_t x = 0, y = 0;
  double z = 0;                    // [0, 1), near to far
  std::array<double, 3> colour{};  // [0, 1]; a grey engine repeats its one channel
  std::uint32_t triangle = 0;      // ScreenTriangle::id
  std::span<const double> aov;     // one number per channel asked for
};

class Framebuffer {
 public:
  // `aov_channels` are the names of the numbers each Sample brings. Without depth test the last fragment wins.
  Framebuffer(int width, int height, std::array<double, 3> background, bool depth_test,
              std::vector<std::string> aov_channels = {});

  void add(const Sample& sample);

  // R, G, B in [0, 1].
  Picture colour() const;
  // R, G, B, then the intermediates; 0 where nothing was drawn.
  Picture all_channels() const;
  // 1 where a fragment was drawn.
  const std::vector<std::uint8_t>& covered() const { return covered_; }
  // How many fragments lay outside the picture. A correct engine has none.
  std::uint64_t outside() const { return outside_; }

 private:
  int width_, height_;
  bool depth_test_;
  std::vector<std::string> aov_channels_;
  std::vector<std::array<double, 3>> colour_;
  std::vector<double> depth_;
  std::vector<double> aov_;
  std::vector<std::uint8_t> covered_;
  std::uint64_t outside_ = 0;
};

}  // namespace wrinkle

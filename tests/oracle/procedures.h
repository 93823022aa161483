// Pictures of N.L and N.H as every procedure with a known answer needs them.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "golden/exact/exact.h"
#include "golden/pixel/pixel.h"
#include "golden/triangle/packet.h"
#include "golden/vertex/scene.h"
#include "sim/config_file.h"

namespace wrinkle {

inline std::filesystem::path asset(const std::string& name) {
  return std::filesystem::path(WRINKLE_SHARED_DIR) / "assets" / name;
}

#define WRINKLE_NEEDS_ASSET(name) \
  if (!std::filesystem::exists(asset(name))) GTEST_SKIP() << "needs " << asset(name) << ", which is not here"

// N.L and N.H, not clamped, of the nearest fragment of every pixel; `triangle` is its number plus 1, or 0.
struct DotPicture {
  int width, height;
  std::vector<double> nl, nh;
  std::vector<std::uint32_t> triangle;

  DotPicture(int w, int h) : width(w), height(h), nl(size()), nh(size()), triangle(size()), depth_(size(), kFar) {}
  std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }

  void add(int x, int y, double z, std::uint32_t id, Vec3 n, Vec3 l, Vec3 h) {
    const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    if (z >= depth_[i]) return;
    depth_[i] = z, triangle[i] = id + 1, nl[i] = dot(n, l), nh[i] = dot(n, h);
  }

 private:
  static constexpr double kFar = std::numeric_limits<double>::max();
  std::vector<double> depth_;
};

inline DotPicture draw_exact_dots(const Config& config, const Frame& frame) {
  DotPicture picture(frame.width, frame.height);
  draw_exact(config, frame, [&](const ExactFragment& f) { picture.add(f.x, f.y, f.z, f.triangle, f.n, f.l, f.h); });
  return picture;
}

inline DotPicture draw_golden_dots(const Config& config, const Frame& frame) {
  DotPicture picture(frame.width, frame.height);
  const PacketStream stream = build_packets(config, frame);
  const double one = 1 << config.unit_bits;
  const auto add = [&](const auto& b) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(b.count); ++i) {
      const auto unit = [&](const auto& columns) {
        return Vec3{static_cast<double>(columns[0][i]) / one, static_cast<double>(columns[1][i]) / one,
                    static_cast<double>(columns[2][i]) / one};
      };
      picture.add(static_cast<int>(b.scan_x[0][i]), static_cast<int>(b.scan_y[0][i]),
                  static_cast<double>(b.interpolate_z[0][i]), stream.packet_triangle[b.packet[i]], unit(b.normalize_n),
                  unit(b.normalize_l), unit(b.normalize_h));
    }
  };
  Golden golden(config, frame.textures);
  golden.draw(stream.words, {add, add});
  return picture;
}

}  // namespace wrinkle

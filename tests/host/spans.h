// Coverage as rows of pixels, from packets and from half-planes.
#pragma once

#include <gtest/gtest.h>

#include <utility>

#include "golden/exact/scan.h"
#include "tests/host/packet_walker.h"

namespace wrinkle::test {

struct Span {
  int y, first, end;
  auto operator<=>(const Span&) const = default;
};
using Spans = std::vector<Span>;
using Pixel = std::pair<int, int>;  // y, x

// The rows of pixels that the packets of a triangle cover; fails when one comes twice, off the screen, or when a packet
// begins or ends with an empty row.
inline Spans spans(const Config& config, const ScreenTriangle& t, int width, int height) {
  Spans all;
  for (TriangleWords packet : set_up(config, t, DrawWords{}, width, height)) {
    std::vector<std::uint64_t> words;
    encode(config, packet, words);
    packet = decode_triangle(config, words);
    const std::size_t before = all.size();
    test::walk_rows(packet, [&](int y, int first, int end) { all.push_back({y, first, end}); });
    if (all.size() == before) {
      ADD_FAILURE() << "a packet without pixels";
      continue;
    }
    EXPECT_EQ(all[before].y, packet.y);
    EXPECT_EQ(all.back().y, packet.y + packet.rows - 1);
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_TRUE(all[i].first >= 0 && all[i].end <= width && all[i].y >= 0 && all[i].y < height);
    EXPECT_TRUE(i == 0 || all[i - 1].y < all[i].y);
  }
  return all;
}

inline Spans exact_spans(const Config& config, const ScreenTriangle& t, int width, int height) {
  Spans all;
  exact::scan(config, sort_corners(config, t), width, height, [&](int y, int first, int end) {
    all.push_back({y, first, end});
  });
  return all;
}

inline std::size_t area(const Spans& all) {
  std::size_t sum = 0;
  for (const Span& span : all) sum += static_cast<std::size_t>(span.end - span.first);
  return sum;
}

inline std::vector<Pixel> to_pixels(const Spans& all) {
  std::vector<Pixel> result;
  for (const Span& span : all) {
    for (int x = span.first; x < span.end; ++x) result.emplace_back(span.y, x);
  }
  return result;
}

inline std::vector<Pixel> pixels(const Config& config, const ScreenTriangle& t, int width, int height) {
  return to_pixels(spans(config, t, width, height));
}

inline Config config_for(int screen_bits, int subpixel_bits = 8) {
  Config config;
  config.screen_bits = screen_bits;
  config.subpixel_bits = subpixel_bits;
  return config;
}

inline Point random_point(Random& random, const Config& config, int kind) {
  const std::int64_t one = 1 << config.subpixel_bits, size = one << config.screen_bits;
  const auto any = [&](std::int64_t low, std::int64_t high, std::int64_t grid) {
    return static_cast<int>(random.integer(low, high) / grid * grid);
  };
  switch (kind) {
    case 0:  // the screen
      return {any(0, size, 1), any(0, size, 1)};
    case 1:  // the whole guard band
      return {any(-size, 2 * size - 1, 1), any(-size, 2 * size - 1, 1)};
    case 2:  // half-pixel grid, so that centres lie on corners and edges
      return {any(0, size, one / 2), any(0, size, one / 2)};
    default:  // just about the left side
      return {any(-4 * one, 4 * one, 1), any(0, size, 1)};
  }
}

}  // namespace wrinkle::test

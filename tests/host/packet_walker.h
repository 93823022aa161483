// What the tests of set-up share: triangles, random configurations, and a reader of packets that is written from
// docs/formats.md and docs/architecture.md alone.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "golden/triangle/packet.h"
#include "tb/random_config.h"

namespace wrinkle::test {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  std::int64_t integer(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  double real(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(engine_() >> 11), -53);
  }
  Vec3 unit_vector() {
    for (;;) {
      const Vec3 v{real(-1, 1), real(-1, 1), real(-1, 1)};
      if (length(v) > 0.1 && length(v) < 1) return normalize(v);
    }
  }
  Config config() {
    return random_config([this](int low, int high) { return integer(low, high); });
  }

 private:
  std::mt19937_64 engine_;
};

// Widths written out, for tests that name bits: the standard ones of a Config may move.
inline Config fixed_widths() {
  Config config;
  config.screen_bits = 10, config.subpixel_bits = 8, config.guard_bits = 10, config.vector_bits = 10;
  config.uv_integer_bits = 4, config.uv_bits = 18, config.q_bits = 18, config.reciprocal_bits = 18;
  config.lod_bits = 5, config.colour_bits = 8, config.depth_bits = 20, config.specular_squarings = 5;
  return config;
}

struct Point {
  int x, y;  // sub-pixels
};

inline ScreenTriangle triangle(Point a, Point b, Point c) {
  ScreenTriangle result;
  const Point points[3] = {a, b, c};
  for (std::size_t i = 0; i < 3; ++i) {
    ScreenVertex& vertex = result.v[i];
    vertex.x = points[i].x, vertex.y = points[i].y;
    vertex.N = vertex.L = vertex.H = vertex.frame[0] = {0, 0, 1};
  }
  return result;
}

inline void randomize_attributes(Random& random, ScreenTriangle& triangle) {
  for (ScreenVertex& vertex : triangle.v) {
    vertex.z = random.real(0, 1);
    vertex.q = random.real(0.1, 3);
    vertex.uv = {random.real(-0.3, 0.5), random.real(-0.4, 0.45)};
    vertex.N = random.unit_vector(), vertex.L = random.unit_vector(), vertex.H = random.unit_vector();
    vertex.frame[0] = 0.7 * vertex.N, vertex.frame[1] = 0.3 * vertex.L, vertex.frame[2] = 0.5 * vertex.H;
  }
}

inline std::vector<Texture> one_texture(int log2_width, int log2_height) {
  Texture texture;
  texture.log2_width = log2_width, texture.log2_height = log2_height;
  texture.levels.resize(static_cast<std::size_t>(std::max(log2_width, log2_height)) + 1);
  return {texture};
}

// A pixel as the hardware visits it, with the raw accumulators (guard bits included, modulo 2^(width + G)).
struct Visit {
  int x, y;
  int steps;                              // pixels stepped from the anchor of the packet
  std::vector<std::int64_t> accumulator;  // of every plane, in packet order
};

struct EdgeWalk {
  EdgeWords words;
  void step() {
    words.remainder += words.remainder_step;
    words.w += words.step;
    if (words.remainder >= 0) words.remainder -= words.denominator, ++words.w;
  }
};

// Calls row(y, first x, end x) for every row of a packet that has pixels.
template <class F>
void walk_rows(const TriangleWords& t, F&& row) {
  EdgeWalk start{t.start}, end{t.end0};
  for (int i = 0; i < t.rows; ++i) {
    if (i == t.rows_end0) end.words = t.end1;
    const int low = static_cast<int>(start.words.w), high = static_cast<int>(end.words.w);
    if (low < high) row(t.y + i, t.mirror ? -high : low, t.mirror ? -low : high);
    start.step();
    end.step();
  }
}

// Steps through a packet row by row as the row engine does, planes down the start edge and along the rows, and calls
// visit(Visit).
template <class F>
void walk(const TriangleWords& t, F&& visit) {
  EdgeWalk start{t.start}, end{t.end0};
  std::vector<std::int64_t> row;
  for (const PlaneWords& plane : t.planes) row.push_back(plane.value);
  for (int i = 0; i < t.rows; ++i) {
    if (i == t.rows_end0) end.words = t.end1;
    std::vector<std::int64_t> value = row;
    for (std::int64_t w = start.words.w; w < end.words.w; ++w) {
      const int x = static_cast<int>(t.mirror ? -1 - w : w);
      visit(Visit{x, t.y + i, static_cast<int>(std::abs(w - t.start.w)) + i, value});
      for (std::size_t k = 0; k < value.size(); ++k) value[k] += t.planes[k].dw;
    }
    const bool carry = start.words.remainder + start.words.remainder_step >= 0;
    for (std::size_t k = 0; k < row.size(); ++k) row[k] += t.planes[k].row + (carry ? t.planes[k].dw : 0);
    start.step();
    end.step();
  }
}

}  // namespace wrinkle::test

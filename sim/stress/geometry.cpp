// Entries 1 to 12: coverage against the rule itself, evaluated at every pixel centre with exact edge functions.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "golden/vertex/scene.h"
#include "sim/stress/catalogue.h"

namespace wrinkle {
namespace {

using Corner = std::array<std::int32_t, 2>;
using Corners = std::array<Corner, 3>;
using Pixel = std::pair<int, int>;  // y, x

// E > 0 inside, for corners in clockwise order as seen on a screen with y down.
std::int64_t edge(Corner a, Corner b, std::int64_t x, std::int64_t y) {
  return (std::int64_t{b[0]} - a[0]) * (y - a[1]) - (std::int64_t{b[1]} - a[1]) * (x - a[0]);
}

bool covers(const Corners& t, std::int64_t x, std::int64_t y) {
  const std::int64_t area = edge(t[0], t[1], t[2][0], t[2][1]);
  if (area == 0) return false;
  const Corners c = area > 0 ? t : Corners{t[0], t[2], t[1]};
  for (std::size_t i = 0; i < 3; ++i) {
    const Corner a = c[i], b = c[(i + 1) % 3];
    const std::int64_t e = edge(a, b, x, y);
    const bool top_left = b[1] < a[1] || (b[1] == a[1] && b[0] > a[0]);
    if (e < 0 || (e == 0 && !top_left)) return false;
  }
  return true;
}

struct Screen {
  int width, height;
};

std::set<Pixel> expected_pixels(const Config& config, const Corners& triangle, Screen screen) {
  std::set<Pixel> pixels;
  const std::int64_t one = std::int64_t{1} << config.subpixel_bits;
  for (int y = 0; y < screen.height; ++y)
    for (int x = 0; x < screen.width; ++x)
      if (covers(triangle, x * one + one / 2, y * one + one / 2)) pixels.insert({y, x});
  return pixels;
}

ScreenVertex plain() {
  ScreenVertex vertex;
  vertex.N = vertex.L = vertex.H = {0, 0, 1};
  vertex.z = 0.5;
  return vertex;
}

std::string text(const Corners& t) {
  return fmt::format("({},{}) ({},{}) ({},{})", t[0][0], t[0][1], t[1][0], t[1][1], t[2][0], t[2][1]);
}

// Draws the triangles, compares each with the rule; returns how often each pixel was drawn by all of them.
std::map<Pixel, int> measure_coverage(Extreme& extreme, const Config& config, const std::vector<Corners>& triangles,
                                      Screen screen) {
  Stimulus stimulus(config);
  stimulus.add_draw({});
  for (const Corners& t : triangles) stimulus.add(screen_triangle(t, plain()), screen.width, screen.height);
  std::vector<std::uint32_t> owners;
  const std::vector<FragmentValues> fragments = stimulus.golden(owners);
  const std::size_t x = stimulus.index("scan", "x"), y = stimulus.index("scan", "y");

  std::vector<std::set<Pixel>> drawn(triangles.size());
  std::vector<int> twice(triangles.size());
  std::map<Pixel, int> total;
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    const Pixel pixel{int(fragments[i][y][0]), int(fragments[i][x][0])};
    ++total[pixel];
    twice[owners[i]] += !drawn[owners[i]].insert(pixel).second;
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    int wrong = twice[i];
    const std::set<Pixel> expected = expected_pixels(config, triangles[i], screen);
    for (const Pixel& p : expected) wrong += drawn[i].count(p) == 0;
    for (const Pixel& p : drawn[i]) wrong += expected.count(p) == 0;
    extreme.measure(wrong, text(triangles[i]));
  }
  extreme.stimuli.push_back(std::move(stimulus));
  return total;
}

Extreme coverage_of(const Config& config, const std::vector<Corners>& triangles, Screen screen) {
  Extreme extreme;
  measure_coverage(extreme, config, triangles, screen);
  return extreme;
}

// A triangle that covers pixels. It follows those that cover none, and shows that the pipeline does not hang.
constexpr Corners kAfter{{{256, 256}, {2560, 300}, {700, 2000}}};

Extreme zero_area(const Config& config) {
  std::vector<Corners> triangles{{{{0, 0}, {2560, 2560}, {5120, 5120}}},
                                 {{{128, 128}, {128, 5000}, {128, 900}}},
                                 {{{128, 128}, {5000, 128}, {900, 128}}},
                                 {{{1, 2}, {301, 602}, {151, 302}}}};
  triangles.push_back(kAfter);
  return coverage_of(config, triangles, {32, 32});
}

Extreme coincident(const Config& config) {
  return coverage_of(config,
                     {{{{300, 300}, {300, 300}, {900, 700}}},
                      {{{300, 300}, {900, 700}, {300, 300}}},
                      {{{384, 384}, {384, 384}, {384, 384}}},
                      kAfter},
                     {32, 32});
}

Extreme slivers(const Config& config) {
  constexpr int kLength = 4096 * 256;
  return coverage_of(stress_wide(config),
                     {{{{0, 127}, {kLength, 127}, {kLength, 128}}},
                      {{{0, 128}, {kLength, 128}, {kLength, 129}}},
                      {{{0, 127}, {kLength, 128}, {0, 128}}},
                      {{{0, 0}, {kLength, 2047}, {kLength, 2048}}},
                      {{{0, 2048}, {kLength, 0}, {kLength, 1}}},
                      {{{0, 128}, {kLength, 129}, {kLength / 2, 128}}}},
                     {4096, 8});
}

Extreme one_centre(const Config& config) {
  std::vector<Corners> triangles;
  for (int dx = -2; dx <= 2; ++dx)
    for (int dy = -2; dy <= 2; ++dy) {
      const int x = 640 + dx, y = 640 + dy;  // centre of pixel (2, 2)
      triangles.push_back({{{x - 3, y - 2}, {x + 3, y - 2}, {x, y + 3}}});
      triangles.push_back({{{x, y}, {x + 1, y}, {x, y + 1}}});
      triangles.push_back({{{x + 20, y}, {x + 50, y}, {x + 20, y + 40}}});
    }
  return coverage_of(config, triangles, {8, 8});
}

// A closed fan around a point on a pixel centre draws every pixel of the disc exactly once.
Extreme on_centres(const Config& config) {
  Extreme extreme;
  const std::vector<Corner> ring{{640, -896}, {2176, 128},  {2688, 640}, {2176, 2176},
                                 {640, 2688}, {-384, 2176}, {-896, 640}, {128, 128}};
  for (Corner hub : {Corner{640, 640}, Corner{896, 640}, Corner{1152, 1152}}) {
    std::vector<Corners> fan;
    for (std::size_t i = 0; i < ring.size(); ++i) fan.push_back({hub, ring[i], ring[(i + 1) % ring.size()]});
    const auto total = measure_coverage(extreme, config, fan, {12, 12});
    int not_once = 0;
    for (const auto& [pixel, count] : total) not_once += count != 1;
    extreme.measure(not_once, fmt::format("fan about ({},{})", hub[0], hub[1]));
  }
  return extreme;
}

// The gradients of this triangle are as steep as they can be; it is the value at its one pixel that counts.
Extreme minimal_area(const Config& config) {
  Extreme extreme;
  extreme.unit = "LSB of s1.V";
  extreme.bound = drift_bound(config, 1);
  for (const Corners& t :
       {Corners{{{128, 128}, {129, 128}, {128, 129}}}, Corners{{{127, 128}, {128, 128}, {128, 129}}},
        Corners{{{128, 127}, {129, 128}, {128, 128}}}, Corners{{{383, 640}, {384, 639}, {385, 641}}}}) {
    Stimulus stimulus(config);
    stimulus.add_draw({});
    ScreenTriangle triangle = screen_triangle(t, plain());
    triangle.v[0].N = {1, 0, 0};
    triangle.v[1].N = {-1, 0, 0};
    triangle.v[2].N = {0, 1, 0};
    stimulus.add(triangle, 16, 16);
    const double area = double(edge(t[0], t[1], t[2][0], t[2][1]));
    for (const FragmentValues& f : stimulus.golden()) {
      const std::int64_t x = f[stimulus.index("scan", "x")][0] * 256 + 128;
      const std::int64_t y = f[stimulus.index("scan", "y")][0] * 256 + 128;
      const double a = double(edge(t[1], t[2], x, y)) / area, b = double(edge(t[2], t[0], x, y)) / area;
      const double one = 1 << config.vector_bits;
      extreme.measure(std::abs(stimulus.real(f, "interpolate", "n", 0) - (a - b)) * one, text(t));
      extreme.measure(std::abs(stimulus.real(f, "interpolate", "n", 1) - (1 - a - b)) * one, text(t));
    }
    extreme.stimuli.push_back(std::move(stimulus));
  }
  return extreme;
}

Extreme guard_band(const Config& config) {
  constexpr int kFar = 2 * 4096 * 256 - 1, kBelow = 12 * 256;
  return coverage_of(stress_wide(config),
                     {{{{-kFar / 2, -kFar / 2}, {kFar, -kFar / 2}, {-kFar / 2, kFar}}},
                      {{{kFar, kFar}, {-kFar / 2, kFar}, {kFar, -kFar / 2}}},
                      {{{-kFar / 2, 3}, {kFar, 1}, {kFar, kBelow}}},
                      {{{-kFar / 2, -kBelow}, {kFar, 1}, {-kFar / 2, 2 * kBelow + 5}}}},
                     {4096, 8});
}

Extreme off_screen(const Config& config) {
  std::vector<Corners> triangles;
  for (int dx : {-1, 0, 1})
    for (int dy : {-1, 0, 1}) {
      if (dx == 0 && dy == 0) continue;
      const int x = dx * 16 * 256, y = dy * 16 * 256;
      triangles.push_back({{{x, y}, {x + 4096, y}, {x, y + 4096}}});
      triangles.push_back({{{x + 4096, y + 4096}, {x + 4096, y}, {x, y + 4096}}});
    }
  triangles.push_back(kAfter);
  return coverage_of(config, triangles, {16, 16});
}

// A square many screens wide goes through the clipper and covers the screen exactly once.
Extreme straddling(const Config& config) {
  Extreme extreme;
  for (double size : {3.0, 40.0, 3000.0, 1e6})
    for (double shift : {0.0, 0.37}) {
      Scene scene;
      scene.width = scene.height = 24;
      scene.camera.world_to_eye(2, 3) = -1;
      Object object;
      for (auto [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        object.mesh.vertices.push_back({.P = {size * (x + 0.5 * shift), size * (y - shift / 4), 0},
                                        .N = {0, 0, 1},
                                        .T = {1, 0, 0},
                                        .uv = {},
                                        .parameter = {}});
      object.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
      scene.objects.push_back(object);
      const Frame frame = build_frame(config, scene);
      Stimulus stimulus(config);
      for (const Draw& draw : frame.draws) {
        stimulus.add_draw(draw.state);
        for (const ScreenTriangle& t : draw.triangles) stimulus.add(t, frame.width, frame.height);
      }
      std::map<Pixel, int> total;
      for (const FragmentValues& f : stimulus.golden())
        ++total[{int(f[stimulus.index("scan", "y")][0]), int(f[stimulus.index("scan", "x")][0])}];
      int wrong = 24 * 24 - int(total.size());
      for (const auto& [pixel, count] : total) wrong += count != 1;
      extreme.measure(wrong, fmt::format("square of {} screens", size));
      extreme.stimuli.push_back(std::move(stimulus));
    }
  return extreme;
}

// Both windings draw the same fragments, value for value.
Extreme windings(const Config& config) {
  Extreme extreme;
  extreme.unit = "fragments";
  std::mt19937 random(10);
  std::uniform_int_distribution<int> at(-1000, 9000);
  Stimulus one(config), other(config);
  one.add_draw({});
  other.add_draw({});
  for (int i = 0; i < 40; ++i) {
    ScreenTriangle t =
        screen_triangle({{{at(random), at(random)}, {at(random), at(random)}, {at(random), at(random)}}}, plain());
    t.v[1].N = {1, 0, 0};
    t.v[2].N = {0, -1, 0};
    one.add(t, 32, 32);
    std::swap(t.v[1], t.v[2]);
    other.add(t, 32, 32);
  }
  const auto a = one.golden(), b = other.golden();
  extreme.measure(std::abs(double(a.size()) - double(b.size())), "number of fragments");
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    extreme.measure(a[i] != b[i], fmt::format("fragment {}", i));
  extreme.stimuli = {one, other};
  return extreme;
}

Extreme span_lengths(const Config& config) {
  std::vector<Corners> triangles;
  for (int length : {1, 2, 4095, 4096}) {
    triangles.push_back({{{0, 0}, {length * 256, 0}, {0, 512}}});
    triangles.push_back({{{(4096 - length) * 256, 0}, {4096 * 256, 0}, {4096 * 256, 512}}});
  }
  return coverage_of(stress_wide(config), triangles, {4096, 2});
}

Extreme image_sizes(const Config& config) {
  Extreme extreme;
  for (Screen screen : {Screen{1, 1}, Screen{1, 4096}, Screen{4096, 1}, Screen{4096, 3}, Screen{3, 4096}}) {
    const int w = screen.width * 256, h = screen.height * 256;
    measure_coverage(extreme, stress_wide(config), {{{{0, 0}, {w, 0}, {w, h}}}, {{{0, 0}, {w, h}, {0, h}}}}, screen);
  }
  return extreme;
}

// There are 16.8 million fragments. Each is compared with the rule as it comes; they are never all held in memory.
Extreme largest_image(const Config& config) {
  constexpr int kSize = 4096, kEnd = kSize * 256;
  const Corners halves[] = {{{{0, 0}, {kEnd, 0}, {kEnd, kEnd}}}, {{{0, 0}, {kEnd, kEnd}, {0, kEnd}}}};
  Extreme extreme;
  Stimulus stimulus(stress_wide(config));
  stimulus.add_draw({});
  for (const Corners& t : halves) stimulus.add(screen_triangle(t, plain()), kSize, kSize);
  const std::size_t x_value = stimulus.index("scan", "x"), y_value = stimulus.index("scan", "y");
  std::vector<bool> drawn(std::size_t(kSize) * kSize);
  double wrong = 0;
  stimulus.each_golden([&](const FragmentValues& f, std::uint32_t owner) {
    const std::int64_t x = f[x_value][0], y = f[y_value][0];
    const auto pixel = std::size_t(y * kSize + x);
    wrong += drawn[pixel] || !covers(halves[owner], x * 256 + 128, y * 256 + 128);
    drawn[pixel] = true;
    ++extreme.cases;
  });
  wrong += double(std::count(drawn.begin(), drawn.end(), false));
  extreme.measure(wrong, "picture 4096 by 4096");
  extreme.stimuli.push_back(std::move(stimulus));
  return extreme;
}

}  // namespace

std::vector<ExtremeEntry> geometry_extremes() {
  return {{1, "zero-area triangle", "", zero_area},
          {2, "coincident vertices", "", coincident},
          {3, "sliver 4096 px by 1 sub-pixel", "", slivers},
          {4, "one pixel centre, or none", "", one_centre},
          {5, "vertices and edges on pixel centres", "", on_centres},
          {6, "area of one sub-pixel: steepest gradients", "", minimal_area},
          {7, "as large as the guard band", "", guard_band},
          {8, "off-screen on each side and corner", "", off_screen},
          {9, "across the guard band", "", straddling},
          {10, "both windings", "", windings},
          {11, "spans of 1, 4095, 4096 pixels", "", span_lengths},
          {12, "pictures 1x1, 1x4096, 4096x1, 4096x3, 3x4096", "", image_sizes},
          {12, "picture 4096 by 4096", "", largest_image, true}};
}

}  // namespace wrinkle

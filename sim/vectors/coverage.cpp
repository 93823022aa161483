// T id class x0 y0 x1 y1 x2 y2 count, then R y mask for each row: the exact pixels of a triangle in 1/256 pixel.
#include <fmt/format.h>

#include <array>
#include <bit>

#include "golden/triangle/packet.h"
#include "sim/input_error.h"
#include "sim/vectors/vectors.h"

namespace wrinkle {
namespace {

constexpr int kSize = 64;
using Mask = std::array<std::uint64_t, kSize>;

// How often pixels were drawn: 1 in `once`, more often in `repeated`.
struct Drawn {
  std::vector<Mask> once;
  std::vector<int> repeated, outside;

  explicit Drawn(std::size_t triangles) : once(triangles), repeated(triangles), outside(triangles) {}
  void add(std::size_t triangle, int x, int y) {
    if (x >= kSize || y >= kSize) {
      ++outside[triangle];
      return;
    }
    std::uint64_t& row = once[triangle][std::size_t(y)];
    const std::uint64_t bit = std::uint64_t{1} << x;
    repeated[triangle] += (row & bit) != 0;
    row |= bit;
  }
};

VectorScore score(const std::string& engine, const std::vector<Mask>& expected, const Drawn& drawn) {
  VectorScore result{.engine = engine};
  for (std::size_t t = 0; t < expected.size(); ++t) {
    int wrong = drawn.repeated[t] + drawn.outside[t];
    for (std::size_t y = 0; y < kSize; ++y) wrong += std::popcount(expected[t][y] ^ drawn.once[t][y]);
    result.measure(wrong, 0, fmt::format("triangle {}: {} pixels differ", t, wrong));
  }
  return result;
}

}  // namespace

VectorReport check_coverage(const std::filesystem::path& path, std::span<const VectorLine> lines, const Config& config,
                            const BenchOptions* rtl) {
  Stimulus stimulus(config);
  stimulus.add_draw({});
  std::vector<Mask> expected;
  for (const VectorLine& line : lines) {
    if (line.words[0] == "T") {
      std::array<std::array<std::int32_t, 2>, 3> corners;
      for (std::size_t i = 0; i < 6; ++i) corners[i / 2][i % 2] = std::int32_t(whole(path, line, 3 + i));
      ScreenVertex attributes;
      attributes.N = attributes.L = attributes.H = {0, 0, 1};
      attributes.z = 0.5;
      stimulus.add(screen_triangle(corners, attributes), kSize, kSize);
      expected.emplace_back();
    } else if (line.words[0] == "R") {
      const std::int64_t y = whole(path, line, 1);
      if (expected.empty() || y < 0 || y >= kSize)
        throw InputError(Place{path.string(), line.number, 0, ""}, fmt::format("row {}", y),
                         "a row 0 to 63 after a T line");
      expected.back()[std::size_t(y)] = std::uint64_t(whole(path, line, 2, 16));
    }
  }

  const auto& owners = stimulus.stream().packet_triangle;
  Drawn golden(expected.size());
  const auto draw_batch = [&](const auto& batch) {
    for (int i = 0; i < batch.count; ++i) {
      const Fragment f = fragment(batch, i);
      golden.add(owners[batch.packet[std::size_t(i)]], f.x, f.y);
    }
  };
  Golden(config, stimulus.textures()).draw(stimulus.stream().words, {draw_batch, draw_batch});
  VectorReport report{VectorKind::kCoverage, "pixels", 0, {score("golden", expected, golden)}};
  if (rtl) {
    Drawn drawn(expected.size());
    std::size_t packet = 0;
    BenchSinks sinks;
    sinks.fragments = [&](std::span<const Fragment> fragments) {
      for (const Fragment& f : fragments) {
        if (packet < owners.size()) drawn.add(owners[packet], f.x, f.y);
        packet += f.last;
      }
    };
    BenchOptions options = *rtl;
    options.compare = false;
    run_bench(config, stimulus.stream(), stimulus.textures(), "coverage vectors", options, sinks);
    report.scores.push_back(score("rtl", expected, drawn));
  }
  return report;
}

}  // namespace wrinkle

// How long the RTL takes, to the clock: values alone would not show a clock lost at every packet, or a buffer that is
// full one word early.
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tb/bench.h"
#include "tb/stall.h"
#include "tests/bench/configurations.h"

namespace wrinkle {
namespace {

TriangleWords rectangle(const Config& config, int rows, int columns) {
  TriangleWords triangle(config);
  triangle.rows = triangle.rows_end0 = rows;
  triangle.start = {0, 0, -1, 0, 1};
  triangle.end0 = triangle.end1 = {columns, 0, -1, 0, 1};
  return triangle;
}

// From reset until the core is idle, without stalls, of so many equal packets. Each texel comes in the clock after its
// request, or up to `latency` clocks later.
std::int64_t clocks(const Config& config, const TriangleWords& triangle, int packets, bool textured = false,
                    int latency = 0) {
  PacketStream stream;
  DrawWords draw;
  draw.textured = draw.bump = textured;
  encode(config, draw, stream.words);
  for (int i = 0; i < packets; ++i) encode(config, triangle, stream.words);
  Texture texel;
  texel.components = Shape(config).texels;
  texel.component_bits = config.texel_bits;
  texel.levels = {{0}};
  BenchOptions options;
  options.latency = latency;
  options.model.optimize = false;  // a few thousand clocks
  const BenchResult result = run_bench(config, stream, {texel}, "clocks", options);
  EXPECT_TRUE(result.equal()) << (result.first ? describe(*result.first) : "stopped");
  return static_cast<std::int64_t>(result.cycles);
}

struct Shape {
  int rows, columns;
  std::int64_t pixels() const { return rows * columns; }
};
// About the words of a packet, their half and their third.
constexpr Shape kShapes[] = {{1, 1},  {1, 2},  {3, 1},  {1, 5}, {1, 6}, {1, 7}, {1, 8},
                             {1, 17}, {1, 18}, {1, 19}, {4, 5}, {5, 4}, {8, 8}, {16, 3}};

struct Law {
  const char* name;
  Config config;
  // Clocks from one packet to the next, of the words of both parts and the pixels.
  std::int64_t (*period)(std::int64_t scan, std::int64_t planes, std::int64_t pixels);
  std::int64_t pixel_clocks;
};
void PrintTo(const Law& law, std::ostream* out) { *out << law.name; }

Config rival(std::string_view name) {
  for (const Rival& r : rivals())
    if (name == r.name) return r.config;
  throw std::invalid_argument(std::string(name));
}

std::vector<Law> laws() {
  // Words of a packet come while the one before is drawn: the longer of both is the time.
  const auto beside = [](std::int64_t scan, std::int64_t planes, std::int64_t pixels) {
    return std::max(scan + planes, pixels);
  };
  const auto in_turn = [](std::int64_t scan, std::int64_t planes, std::int64_t pixels) {
    return std::max(scan + planes, 3 * pixels);
  };
  // The planes come when the walk has ended.
  const auto after = [](std::int64_t scan, std::int64_t planes, std::int64_t pixels) {
    return std::max(scan + planes, planes + pixels + 2);
  };
  return {{"small", small_config(), beside, 1},
          {"constant_light", rival("constant_light"), beside, 1},
          {"shared", rival("shared"), in_turn, 3},
          {"single", rival("single"), after, 1},
          {"single_blinn_held", rival("single_blinn_held"), after, 1}};
}

class Clocks : public testing::TestWithParam<Law> {};

TEST_P(Clocks, OfPacketsThatFollowEachOther) {
  const auto& [name, config, period, pixel_clocks] = GetParam();
  const std::int64_t scan = scan_word_count(config), planes = plane_word_count(config);
  const std::int64_t rest = clocks(config, rectangle(config, 1, 1), 1) - scan - planes - pixel_clocks;
  EXPECT_LT(rest, 50) << "ranks of the pipeline";
  for (const bool textured : {false, true}) {
    for (const Shape shape : kShapes) {
      SCOPED_TRACE(testing::Message() << shape.rows << " by " << shape.columns << (textured ? ", textured" : ""));
      const TriangleWords triangle = rectangle(config, shape.rows, shape.columns);
      EXPECT_EQ(clocks(config, triangle, 1, textured), scan + planes + pixel_clocks * shape.pixels() + rest);
      // After a start in which the ranks fill.
      EXPECT_EQ(clocks(config, triangle, 40, textured) - clocks(config, triangle, 20, textured),
                20 * period(scan, planes, shape.pixels()));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Bench, Clocks, testing::ValuesIn(laws()),
                         [](const auto& test) { return std::string(test.param.name); });

// When the last of so many texels is taken out of a buffer of `capacity` fragments: one is asked for at a clock, as
// soon as there was room in the clock before, and they come in order, one a clock.
std::int64_t last_texel(int fragments, int capacity, int latency) {
  LatencySource source(StallProfile::kNone, latency, BenchOptions{}.seed * 8 + 5);  // that of the bench
  std::vector<std::int64_t> taken;
  std::int64_t asked = -1, due = 0;
  for (int i = 0; i < fragments; ++i) {
    asked = std::max(asked + 1, i >= capacity ? taken[static_cast<std::size_t>(i - capacity)] + 1 : 0);
    due = std::max(due, asked + 1 + static_cast<std::int64_t>(source.next()));
    taken.push_back(std::max(due, taken.empty() ? 0 : taken.back() + 1));
  }
  return taken.back();
}

TEST(TextureClocks, TheBufferHoldsAllThatItHasRoomFor) {
  constexpr int kRows = 16, kColumns = 16, kLatency = 40;
  const auto measured = [](int bits) {
    Config config = small_config();
    config.texture_fifo_bits = bits;
    return clocks(config, rectangle(config, kRows, kColumns), 1, true, kLatency);
  };
  const auto expected = [](int bits) { return last_texel(kRows * kColumns, 1 << bits, kLatency); };
  for (const int bits : {1, small_config().texture_fifo_bits})
    EXPECT_EQ(measured(bits) - measured(5), expected(bits) - expected(5)) << (1 << bits) << " fragments";
}

}  // namespace
}  // namespace wrinkle

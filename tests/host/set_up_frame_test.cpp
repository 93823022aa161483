#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "tests/host/planes.h"

namespace wrinkle {
namespace {

using namespace test;

TEST(SetUp, DrawStatesAreQuantised) {
  Config config = fixed_widths();
  DrawState state;
  state.bump = state.textured = state.shadow = true;
  state.wrap_v = Wrap::kMirror;
  state.material = {{0, 0.5, 1}, {2, -1, 0.25}, {1.0 / 3, 0, 0}, 16};
  const auto textures = one_texture(5, 7);
  DrawWords draw = quantise(config, state, textures);
  EXPECT_TRUE(draw.bump && draw.textured && draw.shadow && !draw.exponent_zero);
  EXPECT_EQ(draw.squarings, 4);
  EXPECT_EQ(draw.wrap_v, 2);
  EXPECT_EQ(draw.log2_width, 5);
  EXPECT_EQ(draw.log2_height, 7);
  EXPECT_EQ(draw.max_level, 7);
  EXPECT_EQ(draw.ambient, (std::array{0, 128, 256}));
  EXPECT_EQ(draw.diffuse, (std::array{256, 0, 64}));
  EXPECT_EQ(draw.specular, (std::array{85, 0, 0}));
  config.channels = 0;
  state.material.ambient = {1, 1, 1};
  EXPECT_EQ(quantise(config, state, textures).ambient, (std::array{256, 0, 0}));
  config.datapath = 0, config.self_shadow = 0;
  draw = quantise(config, state, textures);
  EXPECT_FALSE(draw.bump || draw.textured || draw.shadow);
  EXPECT_EQ(draw.log2_width, 0);

  for (const auto& [exponent, squarings] : {std::pair{1, 0}, {2, 1}, {32, 5}, {1024, 5}}) {
    state.material.exponent = exponent;
    EXPECT_EQ(quantise(config, state, textures).squarings, squarings);
    EXPECT_FALSE(quantise(config, state, textures).exponent_zero);
  }
  state.material.exponent = 0;
  EXPECT_TRUE(quantise(config, state, textures).exponent_zero);
  for (int exponent : {-1, 3, 96}) {
    state.material.exponent = exponent;
    EXPECT_THROW(quantise(config, state, textures), std::invalid_argument);
  }
  state.material.exponent = 1;
  state.texture = 1;
  EXPECT_THROW(quantise(Config{}, state, textures), std::invalid_argument);
}

Frame random_frame(std::uint64_t seed) {
  Random random(seed);
  Frame frame;
  frame.width = 200, frame.height = 150;
  frame.textures = one_texture(7, 6);
  for (int d = 0; d < 4; ++d) {
    Draw draw;
    draw.state.bump = draw.state.textured = d % 2 == 0;
    for (int i = 0; i < 50 && d != 1; ++i) {
      const auto point = [&] {
        return Point{static_cast<int>(random.integer(-9000, 60000)), static_cast<int>(random.integer(-9000, 50000))};
      };
      const Point a = point(), b = point(), c = point();
      draw.triangles.push_back(triangle(a, b, c));
      draw.triangles.back().id = static_cast<std::uint32_t>(100 * d + i);
      randomize_attributes(random, draw.triangles.back());
    }
    frame.draws.push_back(draw);
  }
  frame.draws[3].triangles.assign(3, triangle({0, 0}, {0, 0}, {5, 5}));
  return frame;
}

TEST(SetUp, AFrameBecomesAStreamWithItsIndex) {
  const Config config = fixed_widths();
  const Frame frame = random_frame(10);
  const PacketStream stream = build_packets(config, frame);
  EXPECT_EQ(stream.draw_word.size(), 2u) << "draws without packets are left out";
  ASSERT_EQ(stream.packet_word.size(), stream.packet_triangle.size());
  std::size_t next = 0, draws = 0;
  for (std::size_t i = 0; i < stream.packet_word.size(); ++i) {
    if (draws < stream.draw_word.size() && stream.draw_word[draws] == next) {
      EXPECT_EQ(decode_draw(config, std::span(stream.words).subspan(next)).bump, true);
      next += static_cast<std::size_t>(Shape(config).draw_words);
      ++draws;
    }
    ASSERT_EQ(stream.packet_word[i], next);
    const TriangleWords packet = decode_triangle(config, std::span(stream.words).subspan(next));
    const std::uint32_t draw = stream.packet_draw[i], id = stream.packet_triangle[i];
    const auto packets =
        set_up(config, frame.draws[draw].triangles[id - 100 * draw], frame.draws[draw].state, frame.textures, 200, 150);
    EXPECT_NE(std::find(packets.begin(), packets.end(), packet), packets.end());
    next += static_cast<std::size_t>(triangle_word_count(config));
  }
  EXPECT_EQ(next, stream.words.size());
  EXPECT_GT(stream.packet_word.size(), 50u);
}

std::uint64_t fingerprint(const Config& config) {
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
  for (std::uint64_t word : build_packets(config, random_frame(11)).words) {
    for (int shift = 0; shift < 64; shift += 8) hash = (hash ^ (word >> shift & 0xFF)) * 0x100000001b3;
  }
  return hash;
}

// Every compiler at every optimisation must give the same words. gcc 12 and clang 14 gave these, with -O0 to -O2 on
// x86-64.
TEST(SetUp, WordsAreTheSameFromEveryCompiler) {
  Config config = fixed_widths();
  EXPECT_EQ(fingerprint(config), 16283448069667544233u);
  config.perspective = 1;
  config.screen_bits = 12, config.guard_bits = 14, config.vector_bits = 18, config.lod_bits = 8;
  EXPECT_EQ(fingerprint(config), 7457417461308410475u);
}

}  // namespace
}  // namespace wrinkle

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "golden/pixel/pixel.h"
#include "tests/host/packet_walker.h"

namespace wrinkle {
namespace {

using namespace test;

std::int64_t residue(Random& random, int bits) {
  const std::int64_t half = std::int64_t{1} << (bits - 1);
  return random.integer(-half, half - 1);
}

EdgeWords random_edge(Random& random, const Config& config) {
  EdgeWords edge;
  edge.denominator = random.integer(1, (std::int64_t{1} << Shape(config).edge_bits) - 1);
  edge.remainder = random.integer(-edge.denominator, -1);
  edge.remainder_step = random.integer(0, edge.denominator - 1);
  edge.w = residue(random, config.screen_bits + 2);
  edge.step = residue(random, config.screen_bits + 2);
  return edge;
}

TriangleWords random_triangle(Random& random, const Config& config) {
  TriangleWords triangle(config);
  triangle.mirror = random.integer(0, 1) != 0;
  triangle.y = static_cast<int>(random.integer(0, config.screen_size() - 1));
  triangle.rows = static_cast<int>(random.integer(1, config.screen_size()));
  triangle.rows_end0 = static_cast<int>(random.integer(1, triangle.rows));
  triangle.start = random_edge(random, config);
  triangle.end0 = random_edge(random, config);
  triangle.end1 = random_edge(random, config);
  for (std::size_t p = 0; const PlaneFormat& format : plane_formats(config)) {
    PlaneWords& plane = triangle.planes[p++];
    if (format.is_held) {
      plane.value = residue(random, format.width);
      continue;
    }
    const int bits = format.width + config.guard_bits;
    plane = {residue(random, bits), residue(random, bits), residue(random, bits)};
  }
  if (Shape(config).textured != 0 && config.perspective == 0) {
    triangle.lod = static_cast<int>(random.integer(0, (16 << Shape(config).lod_fraction_bits) - 1));
  }
  return triangle;
}

TEST(Packet, TrianglesComeBackFromTheirWords) {
  Random random(1);
  for (int i = 0; i < 3000; ++i) {
    const Config config = random.config();
    const TriangleWords triangle = random_triangle(random, config);
    std::vector<std::uint64_t> words;
    encode(config, triangle, words);
    ASSERT_EQ(static_cast<int>(words.size()), triangle_word_count(config));
    ASSERT_EQ(decode_triangle(config, words), triangle) << "configuration " << i;
  }
}

TEST(Packet, DrawsComeBackFromTheirWords) {
  Random random(2);
  Config config = fixed_widths();
  for (int i = 0; i < 1000; ++i) {
    config.light_vectors = i % 2;
    const auto flag = [&] { return random.integer(0, 1) != 0; };
    const auto field = [&](int bits) { return static_cast<int>(random.integer(0, (1 << bits) - 1)); };
    const auto up_to = [&](int most) { return static_cast<int>(random.integer(0, most)); };
    DrawWords draw{flag(),
                   flag(),
                   flag(),
                   flag(),
                   up_to(2),
                   up_to(2),
                   up_to(kMaxLog2Size),
                   up_to(kMaxLog2Size),
                   field(4),
                   field(12),
                   up_to(config.specular_squarings),
                   {},
                   {},
                   {}};
    for (auto* colour : {&draw.ambient, &draw.diffuse, &draw.specular}) {
      for (int& channel : *colour) channel = up_to(1 << config.colour_bits);
    }
    const auto unit = [&] { return field(config.unit_bits + 2) - (1 << (config.unit_bits + 1)); };
    if (i % 2 == 1) draw.l = {unit(), unit(), unit()}, draw.h = {unit(), unit(), unit()};
    std::vector<std::uint64_t> words;
    encode(config, draw, words);
    ASSERT_EQ(words.size(), static_cast<std::size_t>(Shape(config).draw_words));
    ASSERT_EQ(decode_draw(config, words), draw);
  }
}

// The bit positions of docs/formats.md, written out by hand.
TEST(Packet, DrawFieldsLieWhereTheFormatSays) {
  DrawWords draw;
  draw.textured = true;
  draw.wrap_v = 2;
  draw.log2_height = 9;
  draw.texture = 0xABC;
  draw.squarings = 5;
  draw.ambient = {1, 2, 3};
  draw.specular = {0x100, 0, 7};
  std::vector<std::uint64_t> words;
  encode(Config{}, draw, words);
  EXPECT_EQ(words[0], 1u | 1u << 5 | 2u << 10 | 9u << 16 | std::uint64_t{0xABC} << 24 | std::uint64_t{5} << 36);
  EXPECT_EQ(words[1], std::uint64_t{0x0000'0003'0002'0001});
  EXPECT_EQ(words[2], 0u);
  EXPECT_EQ(words[3], std::uint64_t{0x0000'0007'0000'0100});
}

// Bit offsets of docs/formats.md for the standard widths: X = 10, S = 8, ED = 20, plane 0 at a new word.
TEST(Packet, TriangleFieldsLieWhereTheFormatSays) {
  const Config config = fixed_widths();
  TriangleWords triangle(config);
  triangle.mirror = true;
  triangle.y = 0x155;
  triangle.rows = 0x400;
  triangle.rows_end0 = 0x3FF;
  triangle.start.w = -1;
  triangle.planes[0].value = 5;
  triangle.planes[0].row = -1;
  std::vector<std::uint64_t> words;
  encode(config, triangle, words);
  EXPECT_EQ(words[0] & 0xF, 2u);
  EXPECT_EQ(words[0] >> 4 & 1, 1u);
  EXPECT_EQ(words[0] >> 5 & 0x3FF, 0x155u);
  EXPECT_EQ(words[0] >> 15 & 0x7FF, 0x400u);
  EXPECT_EQ(words[0] >> 26 & 0x7FF, 0x3FFu);
  EXPECT_EQ(words[0] >> 37 & 0xFFF, 0xFFFu);
  // 4 + 1 + 10 + 11 + 11 + 3 * (12 + 12 + 21 + 20 + 20) = 292 bits are five words.
  EXPECT_EQ(scan_word_count(config), 5);
  EXPECT_EQ(words[5] & 0x3FFFFF, 5u);  // 12 + 10 bits
  EXPECT_EQ(words[5] >> 22 & 0x3FFFFF, 0x3FFFFFu);
}

TEST(Packet, PlanesFollowTheConfiguration) {
  Config config = fixed_widths();
  const auto has = [&](std::string_view name) {
    const std::vector<PlaneFormat> formats = plane_formats(config);
    return std::any_of(formats.begin(), formats.end(), [&](const PlaneFormat& f) { return f.name == name; });
  };
  EXPECT_TRUE(has("h") && has("u") && has("z"));
  EXPECT_FALSE(has("q") || has("lod"));
  config.perspective = 1;
  EXPECT_TRUE(has("q") && has("lod"));
  config.datapath = 0, config.decal = 0;
  EXPECT_FALSE(has("u") || has("q") || has("lod"));
  config.lighting = 0, config.depth = 0;
  EXPECT_EQ(plane_formats(config).size(), 6u);
}

// Words 4 and 5 of docs/formats.md: three fields of F + 2 bits each.
TEST(Packet, ConstantLightVectorsLieWhereTheFormatSays) {
  Config config = fixed_widths();
  config.light_vectors = 1, config.unit_bits = 10;
  DrawState state;
  state.L = {-1, 0, 0}, state.H = {0, 0.6, 0.8};
  std::vector<std::uint64_t> words;
  encode(config, quantise(config, state, {}), words);
  ASSERT_EQ(words.size(), 6u);
  EXPECT_EQ(words[4], 0xC00u) << "-2^10 in 12 bits";
  EXPECT_EQ(words[5], std::uint64_t{614} << 12 | std::uint64_t{819} << 24) << "614.4 and 819.2";
  state.H = {0, 0.6, 0.9};
  EXPECT_THROW(quantise(config, state, {}), std::invalid_argument);
}

TEST(Packet, CrossProductsComeFirstAndConstantsHaveOneField) {
  Config config = fixed_widths();
  config.datapath = 2, config.wide_bits = 16, config.cross_products = 0;
  const std::vector<PlaneFormat> formats = plane_formats(config);
  EXPECT_TRUE(formats[0].is("a", 0));
  EXPECT_TRUE(formats[8].is("c", 2));
  EXPECT_TRUE(formats[9].is("l", 0));
  EXPECT_EQ(formats[0].width, 18);
  const std::size_t a_z = 2, b_x = 3, b_y = 4;
  TriangleWords triangle(config);
  triangle.planes[a_z].dw = -1;
  triangle.planes[b_x].value = 5;
  const auto scan_words = static_cast<std::size_t>(scan_word_count(config));
  // Three planes of three fields of 28 bits: B begins at bit 252 with a width of 28, or of 18 where it is constant.
  std::vector<std::uint64_t> words;
  encode(config, triangle, words);
  EXPECT_EQ(words[scan_words + 3] >> 60, 5u);
  config.cross_products = 1;
  triangle.planes[b_y].value = 3;
  words.clear();
  encode(config, triangle, words);
  EXPECT_EQ(words[scan_words + 3] >> 60, 5u);
  EXPECT_EQ(words[scan_words + 4] >> 14 & 0x3FFFF, 3u) << "bit 252 + 18";
  EXPECT_EQ(decode_triangle(config, words), triangle);
}

TEST(Packet, WhatIsCutShortOrOfAnotherOpcodeIsRefused) {
  const Config config = fixed_widths();
  std::vector<std::uint64_t> words;
  encode(config, TriangleWords(config), words);
  EXPECT_THROW(decode_draw(config, words), std::invalid_argument);
  words.pop_back();
  EXPECT_THROW(decode_triangle(config, words), std::invalid_argument);
  EXPECT_THROW(decode_triangle(config, {}), std::invalid_argument);
}

// Each is a packet of the format but for one field.
TEST(Packet, FieldsOutOfTheirRangesAreRefused) {
  const Config config = fixed_widths();
  const auto refuses = [&](const char* what, auto fields, const auto& decode, const auto& change) {
    std::vector<std::uint64_t> words;
    encode(config, fields, words);
    EXPECT_NO_THROW(decode(config, words));
    change(fields);
    words.clear();
    encode(config, fields, words);
    EXPECT_THROW(decode(config, words), std::invalid_argument) << what;
  };
  const auto refuses_draw = [&](const char* what, const auto& change) {
    refuses(what, DrawWords(), decode_draw, change);
  };
  const auto refuses_triangle = [&](const char* what, const auto& change) {
    refuses(what, TriangleWords(config), decode_triangle, change);
  };
  refuses_draw("wrap_u", [](DrawWords& draw) { draw.wrap_u = 3; });
  refuses_draw("wrap_v", [](DrawWords& draw) { draw.wrap_v = 3; });
  refuses_draw("log2_width", [](DrawWords& draw) { draw.log2_width = kMaxLog2Size + 1; });
  refuses_draw("log2_height", [](DrawWords& draw) { draw.log2_height = kMaxLog2Size + 1; });
  refuses_draw("squarings", [&](DrawWords& draw) { draw.squarings = config.specular_squarings + 1; });
  refuses_draw("ambient", [&](DrawWords& draw) { draw.ambient[1] = (1 << config.colour_bits) + 1; });
  refuses_draw("specular", [&](DrawWords& draw) { draw.specular[2] = 0xFFFF; });
  refuses_triangle("rows", [](TriangleWords& triangle) { triangle.rows = 0; });
  refuses_triangle("remainder of 0", [](TriangleWords& triangle) { triangle.start.remainder = 0; });
  refuses_triangle("remainder below the denominator", [](TriangleWords& triangle) { triangle.end0.remainder = -2; });
  refuses_triangle("step of the denominator", [](TriangleWords& triangle) { triangle.end1.remainder_step = 1; });
}

// A draw packet says what its texture is: texels are fetched by what it says.
TEST(Packet, DrawsOfOtherTexturesThanThereAreRefused) {
  Config config;
  config.decal = 1;
  const Shape shape(config);
  Texture texture{2, 1, shape.texels, shape.texel_bits, {}};
  for (int level = 0; level < 3; ++level) {
    texture.levels.emplace_back(
        static_cast<std::size_t>(texture.width(level) * texture.height(level) * texture.texel_words()));
  }
  const std::vector<Texture> textures{texture};
  const auto draw = [&](const auto& change) {
    DrawWords state;
    state.textured = true;
    state.log2_width = 2;
    state.log2_height = 1;
    state.max_level = 2;
    change(state);
    std::vector<std::uint64_t> words;
    encode(shape, state, words);
    Golden(shape, textures).draw(words, {[](const auto&) {}, [](const auto&) {}});
  };
  EXPECT_NO_THROW(draw([](DrawWords&) {}));
  EXPECT_THROW(draw([](DrawWords& state) { state.texture = 1; }), std::invalid_argument);
  EXPECT_THROW(draw([](DrawWords& state) { state.log2_width = 3; }), std::invalid_argument);
  EXPECT_THROW(draw([](DrawWords& state) { state.log2_height = 0; }), std::invalid_argument);
  EXPECT_THROW(draw([](DrawWords& state) { state.max_level = 3; }), std::invalid_argument);
}

}  // namespace
}  // namespace wrinkle

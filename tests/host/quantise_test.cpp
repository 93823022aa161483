// Texel codes and texture assembly.
#include "golden/texel/quantise.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "golden/datapath/datapaths.h"

namespace wrinkle {
namespace {

Config config_with(Decode decode, int texel_bits, int decal = 0) {
  Config config;
  config.decode = static_cast<int>(decode);
  config.texel_bits = texel_bits;
  config.decal = decal;
  return config;
}

std::uint64_t component(std::uint64_t word, int i, int bits) { return word >> (i * bits) & ((1u << bits) - 1); }

std::uint64_t normal_code(double n, Decode decode, int bits) { return bump_code(n, config_with(decode, bits, 0)); }

// What the hardware makes of a code [architecture, texture].
double decoded(std::uint64_t code, Decode decode, int bits) {
  const double d = decode == Decode::kRange ? 1 : 0;
  return (2.0 * static_cast<double>(code) - (std::ldexp(1, bits) - d)) / std::ldexp(1, bits);
}

TEST(Quantise, EightBitImageComesBackAsItsOwnCodes) {
  NormalMap image(256, 1);
  for (int c = 0; c < 256; ++c) image.at(c, 0) = {c / 255.0, (255 - c) / 255.0, (c * 7 % 256) / 255.0};
  const Grid<Vec3> decal = image;
  const ExactTexture exact = assemble(normal_mips(normal_map_from_image(image)), colour_mips(decal));
  const Texture texture = quantise(exact, config_with(Decode::kRange, 8, 1));
  ASSERT_EQ(texture.components, 6);
  for (unsigned c = 0; c < 256; ++c) {
    const std::uint64_t word = texture.levels[0][c];
    for (int part : {0, 3}) {
      ASSERT_EQ(component(word, part, 8), c);
      ASSERT_EQ(component(word, part + 1, 8), 255 - c);
      ASSERT_EQ(component(word, part + 2, 8), c * 7 % 256);
    }
  }
}

TEST(Quantise, CodesAreTheNearest) {
  for (const Decode decode : {Decode::kRange, Decode::kOffset}) {
    for (const int bits : {4, 8, 10}) {
      // Codes stand for n times the full scale of their decode.
      const double full = decode == Decode::kRange ? 1 - std::ldexp(1, -bits) : 1 - std::ldexp(1, 1 - bits);
      for (double n = -1; n <= 1; n += 0.0037) {
        const double error = decoded(normal_code(n, decode, bits), decode, bits) - n * full;
        ASSERT_LE(std::abs(error), std::ldexp(1, -bits) * (1 + 1e-9));
      }
      EXPECT_EQ(normal_code(7, decode, bits), normal_code(1, decode, bits));
      EXPECT_EQ(normal_code(-7, decode, bits), normal_code(-1, decode, bits));
      EXPECT_EQ(normal_code(1, decode, bits), (1u << bits) - 1);
    }
  }
}

TEST(Quantise, OffsetCodeWritesTheFlatNormalExactly) {
  for (const int bits : {4, 8, 10}) {
    EXPECT_EQ(decoded(normal_code(0, Decode::kOffset, bits), Decode::kOffset, bits), 0);
    EXPECT_NE(decoded(normal_code(0, Decode::kRange, bits), Decode::kRange, bits), 0);
    EXPECT_EQ(normal_code(-1, Decode::kOffset, bits), 1u);
  }
}

TEST(Quantise, ComponentsFollowTheConfiguration) {
  const ExactTexture exact = assemble(normal_mips(NormalMap(4, 2, {0, 0, 1})), {});
  Config config = config_with(Decode::kRange, 10, 1);
  const Texture both = quantise(exact, config);
  EXPECT_EQ(both.components, 6);
  EXPECT_EQ(both.levels.size(), 3u);
  EXPECT_EQ(both.levels[1].size(), 2u);
  EXPECT_EQ(component(both.levels[0][0], 2, 10), 1023u);
  EXPECT_EQ(component(both.levels[0][0], 5, 10), 1023u);
  config.datapath = static_cast<int>(Datapath::kPhong);
  const Texture decal_alone = quantise(exact, config);
  EXPECT_EQ(decal_alone.components, 3);
  EXPECT_EQ(decal_alone.levels[0][0], (1u << 30) - 1);  // white
}

// The gloss is the last component, whatever comes before it.
TEST(Quantise, GlossIsTheLastComponent) {
  Grid<Vec3> gloss(2, 1, {1, 1, 1});
  gloss.at(0, 0) = {0.2, 0.2, 0.2};
  const ExactTexture exact = assemble(normal_mips(NormalMap(2, 1, {0, 0, 1})), {}, colour_mips(gloss));
  for (const int datapath : {0, 1, 2, 3, 4}) {
    for (const int decal : {0, 1}) {
      Config config = config_with(Decode::kRange, 10, decal);
      config.datapath = datapath;
      config.gloss_map = 1;
      const Texture texture = quantise(exact, config);
      ASSERT_EQ(texture.components, Shape(config).bump_components + 3 * decal + 1);
      const int last = texture.components - 1;
      EXPECT_EQ(texture.code(texture.levels[0], 0, last), 205u);  // 0.2 * 1023
      EXPECT_EQ(texture.code(texture.levels[0], 1, last), 1023u);
      EXPECT_EQ(texture.code(texture.levels[1], 0, last), 614u);  // the mean
      if (decal != 0) {
        EXPECT_EQ(texture.code(texture.levels[0], 0, last - 1), 1023u);
      }
    }
  }
}

TEST(Quantise, ChainsOfDifferentSizesMeetAtTheLarger) {
  NormalMap normals(2, 2, {0, 0, 1});
  normals.at(0, 0) = {1, 0, 0};
  Grid<Vec3> decal(8, 4, {0.5, 0.5, 0.5});
  decal.at(7, 3) = {1, 0, 0};
  const ExactTexture texture = assemble(normal_mips(normals), colour_mips(decal));
  EXPECT_EQ(texture.log2_width, 3);
  EXPECT_EQ(texture.log2_height, 2);
  ASSERT_EQ(texture.levels.size(), 4u);
  EXPECT_EQ(texture.levels[0].size(), 32u);
  EXPECT_EQ(texture.levels[0][31].colour[0], 1.0f);                   // the decal's own texel
  EXPECT_FLOAT_EQ(texture.levels[0][8 + 1].bump[0], 0.875f * 0.75f);  // bilinear between the four normals
  EXPECT_FLOAT_EQ(texture.levels[0][2 * 8 + 5].bump[0], 0.125f * 0.25f);
  for (const auto& level : texture.levels) {
    for (const auto& texel : level) {
      for (const float c : texel.bump) EXPECT_TRUE(c >= -1 && c <= 1);
      for (const float c : texel.colour) EXPECT_TRUE(c >= 0 && c <= 1);
    }
  }
}

TEST(Quantise, WithoutAnythingFlatAndWhite) {
  const ExactTexture texture = assemble({}, {});
  ASSERT_EQ(texture.levels.size(), 1u);
  EXPECT_EQ(texture.levels[0][0], (ExactTexel{{0, 0, 1}}));
}

}  // namespace
}  // namespace wrinkle

// texture against its exact twin, and against samples made elsewhere.
#include "golden/exact/texture.h"

#include <cmath>
#include <fstream>
#include <sstream>

#include "golden/pixel/probe.h"
#include "tests/stage/support.h"

namespace wrinkle {
namespace {

TEST(Texture, LanesAgree) { expect_lanes_agree(kTexture, 8); }

// The codes of a texture, decoded without rounding.
ExactTexture decoded(const Config& config, const Texture& texture) {
  ExactTexture out{texture.log2_width, texture.log2_height, {}};
  const int t = config.texel_bits;
  const double centre = std::ldexp(1.0, t) - (config.decode == 0 ? 1 : 0);
  for (const auto& level : texture.levels) {
    auto& texels = out.levels.emplace_back();
    for (std::size_t i = 0; i < level.size() / static_cast<std::size_t>(texture.texel_words()); ++i) {
      ExactTexel texel;
      for (std::size_t k = 0; k < static_cast<std::size_t>(texture.components); ++k) {
        const double code = static_cast<double>(texture.code(level, i, static_cast<int>(k)));
        const auto bump = static_cast<std::size_t>(Shape(config).bump_components);
        const double half = std::ldexp(1.0, t - 1);
        const auto colours = static_cast<std::size_t>(Shape(config).colours);
        if (k >= bump + colours)
          texel.gloss = static_cast<float>(std::ldexp(code, -t));
        else if (k >= bump)
          texel.colour[k - bump] = static_cast<float>(std::ldexp(code, -t));
        else
          texel.bump[k] = static_cast<float>(Shape(config).bump_saturates != 0 ? code / half - 1
                                                                               : std::ldexp(2 * code - centre, -t));
      }
      texels.push_back(texel);
    }
  }
  return out;
}

// Per axis and level the coordinate is off by half a weight's LSB, at most, of a difference of neighbours up to the
// full range: 2 for normals, 1 for decals. Then half an ulp of the output.
TEST(Texture, SamplesStayWithinTheirBounds) {
  Worst normal("texture normal, share of 2^(1-B) + ulp/2", 1);
  // One ulp: what rounds up to 1 saturates.
  Worst saturated("texture slope or offset, share of 2^(1-B) + ulp", 1),
      decal("texture decal or gloss, share of 2^-B + ulp/2", 1);
  std::uint64_t seed = base_seed();
  for (auto [name, config] : configurations(60)) {
    if (Shape(config).textured == 0) continue;
    Random random(++seed);
    SCOPED_TRACE(name + ", seed " + std::to_string(seed));
    DrawWords draw = random_draw(config, random);
    draw.textured = true;
    const Texture texture = random_texture(config, draw, random);
    const ExactTexture exact_texture = decoded(config, texture);
    Context context = make_context(config);
    set_draw(
        context, draw,
        std::make_shared<BoundTexture>(bind_texture(texture, context.config.bump_components,
                                                    static_cast<Wrap>(draw.wrap_u), static_cast<Wrap>(draw.wrap_v))));
    auto batch = std::make_unique<Batch<std::int64_t>>(context.config);
    fill(config, seed, *batch);
    batch->count = kBatch;
    batch = run_one(context, kTexture, std::move(batch));
    const auto& u = config.perspective != 0 ? batch->perspective_u[0] : batch->interpolate_u[0];
    const auto& v = config.perspective != 0 ? batch->perspective_v[0] : batch->interpolate_v[0];
    const int b = context.config.weight_fraction_bits;
    const double weight_error = b == 0 ? 0 : std::ldexp(1.0, -b);
    const double bump_ulp = std::ldexp(1.0, -context.config.bump_fraction),
                 decal_ulp = std::ldexp(1.0, -config.texel_bits);
    for (std::size_t i = 0; i < kBatch; ++i) {
      const auto real = [](std::int64_t x, int bits) { return std::ldexp(static_cast<double>(x), -bits); };
      double lod = real(batch->interpolate_lod[0][i], context.config.lod_fraction_bits);
      // Without a trilinear filter the level of detail is a whole level already.
      const exact::Sample want =
          exact::sample(exact::filtering(config, draw), exact_texture, {real(u[i], config.uv_bits), real(v[i], config.uv_bits)}, lod);
      for (std::size_t k = 0; k < batch->texture_bump.size(); ++k) {
        const double error = real(batch->texture_bump[k][i], context.config.bump_fraction) - want.bump[k];
        if (context.config.bump_saturates != 0)
          saturated.see(error / (2 * weight_error + bump_ulp + 1e-6));
        else
          normal.see(error / (2 * weight_error + bump_ulp / 2 + 1e-6));
      }
      const auto see = [&](std::int64_t code, double value) {
        decal.see((real(code, config.texel_bits) - value) / (weight_error + decal_ulp / 2 + 1e-6));
      };
      for (std::size_t k = 0; k < batch->texture_decal.size(); ++k) see(batch->texture_decal[k][i], want.colour[k]);
      for (const auto& column : batch->texture_gloss) see(column[i], want.gloss);
    }
  }
}

// Codes at both ends, the middle and one LSB beside: c stands for c - 2^(T-1), whatever `decode` says.
TEST(Texture, SlopesAreSigned) {
  for (int decode : {0, 1}) {
    const Config config = with({{&Config::datapath, 2}, {&Config::decode, decode}, {&Config::gradient_bits, 9}});
    for (const auto& [code, slope] :
         {std::pair<std::uint64_t, std::int64_t>{0, -512}, {127, -4}, {128, 0}, {129, 4}, {255, 508}}) {
      Texture texture;
      texture.components = 2;
      texture.levels = {{code | (255 - code) << 8}};
      Context context = make_context(config);
      DrawWords draw;
      draw.bump = draw.textured = true;
      set_draw(context, draw, std::make_shared<BoundTexture>(bind_texture(texture, 2, Wrap::kRepeat, Wrap::kRepeat)));
      auto batch = std::make_unique<Batch<std::int64_t>>(context.config);
      batch->count = 1;
      batch = run_one(context, kTexture, std::move(batch));
      EXPECT_EQ(batch->texture_bump[0][0], slope);
      EXPECT_EQ(batch->texture_bump[1][0], -slope - 4);
    }
  }
}

Config offset_config() { return with({{&Config::decode, 1}, {&Config::vector_bits, 10}, {&Config::texel_bits, 8}}); }

Texture constant_texture(const Config& config, std::uint64_t texel, int log2_size) {
  Texture texture;
  texture.log2_width = texture.log2_height = log2_size;
  texture.component_bits = config.texel_bits;
  for (int level = 0; level <= log2_size; ++level)
    texture.levels.emplace_back(
        static_cast<std::size_t>(texture.width(level)) * static_cast<std::size_t>(texture.height(level)), texel);
  return texture;
}

// 42, 63: weights sum to 1, whatever the fractions; (128, 128, 255) under both decodes.
TEST(Texture, ConstantStaysConstant) {
  const std::uint64_t texel = 128 | 128 << 8 | 255 << 16;
  Random random(base_seed());
  for (int decode : {0, 1}) {
    Config config = offset_config();
    config.decode = decode;
    const Texture texture = constant_texture(config, texel, 5);
    const std::int64_t xy = decode == 0 ? 4 : 0, z = decode == 0 ? 1020 : 1016;
    for (int i = 0; i < 300; ++i) {
      const auto sample = sample_texture(config, texture, static_cast<Wrap>(i % 3), static_cast<Wrap>(i / 3 % 3),
                                         pattern(random, {-(1 << 21), (1 << 21) - 1}),
                                         pattern(random, {-(1 << 21), (1 << 21) - 1}), uniform(random, -64, 400));
      ASSERT_EQ(sample.bump, (std::vector<std::int64_t>{xy, xy, z}));
    }
  }
}

// A texture whose texel (x, y) of level 0 has the codes (x, y, 0), of level l (l, l, l).
Texture ramp(const Config& config, int log2_size) {
  Texture texture = constant_texture(config, 0, log2_size);
  for (int level = 1; level <= log2_size; ++level)
    for (auto& texel : texture.levels[static_cast<std::size_t>(level)])
      texel = static_cast<std::uint64_t>(level) * 0x10101;
  for (std::size_t y = 0; y < 1u << log2_size; ++y)
    for (std::size_t x = 0; x < 1u << log2_size; ++x) texture.levels[0][(y << log2_size) + x] = x | y << 8;
  return texture;
}

// Code of a normal component under `offset`, as n = (2 c - 256) 2^(V - 8).
double code_of(std::int64_t n) { return (static_cast<double>(n) / 4 + 256) / 2; }

// 39, 40: the ends of the texture at -1, 0, size - 1 and size texels, near 0 and 2^3 - 1 repeats away.
TEST(Texture, WrapsAtItsEnds) {
  const Config config = offset_config();
  const Texture texture = ramp(config, 4);
  struct Case {
    Wrap wrap;
    std::array<double, 4> x;  // at centres of texels -1, 0, 15, 16
  };
  const int texel = 1 << (config.uv_bits - 4);
  for (const Case& c :
       {Case{Wrap::kRepeat, {15, 0, 15, 0}}, Case{Wrap::kClamp, {0, 0, 15, 15}}, Case{Wrap::kMirror, {0, 0, 15, 15}}}) {
    const int positions[] = {-1, 0, 15, 16};
    for (std::size_t k = 0; k < 4; ++k) {
      const std::int64_t u = positions[k] * texel + texel / 2;
      EXPECT_EQ(code_of(sample_texture(config, texture, c.wrap, c.wrap, u, texel / 2, 0).bump[0]), c.x[k]) << k;
      EXPECT_EQ(code_of(sample_texture(config, texture, c.wrap, c.wrap, texel / 2, u, 0).bump[1]), c.x[k]) << k;
      if (c.wrap == Wrap::kClamp) continue;
      const std::int64_t far = u - (8 << config.uv_bits) + (k == 0 ? 2 << config.uv_bits : 0);
      EXPECT_EQ(code_of(sample_texture(config, texture, c.wrap, c.wrap, far, texel / 2, 0).bump[0]), c.x[k])
          << "40: an even number of repeats away, " << k;
    }
  }
}

// 39, 42: halfway over the seam, fraction 0 and the greatest.
TEST(Texture, FiltersOverTheSeam) {
  const Config config = offset_config();
  const Texture texture = ramp(config, 4);
  const auto x = [&](Wrap wrap, std::int64_t u) {
    return code_of(sample_texture(config, texture, wrap, wrap, u, 1 << (config.uv_bits - 5), 0).bump[0]);
  };
  EXPECT_EQ(x(Wrap::kRepeat, 0), 7.5);
  EXPECT_EQ(x(Wrap::kClamp, 0), 0);
  EXPECT_EQ(x(Wrap::kMirror, 0), 0);
  EXPECT_EQ(x(Wrap::kMirror, 1 << config.uv_bits), 15);
  const std::int64_t lsb = 1 << (config.uv_bits - 4 - config.weight_bits);
  EXPECT_NEAR(x(Wrap::kRepeat, 5 * (1 << 14) + (1 << 13) - lsb), 5 - 1 / 256.0, 1 / 16.0) << "greatest fraction";
}

// 41, 43: smallest level, level of detail at whole levels, one LSB beside, below 0 and above the last.
TEST(Texture, LevelsOfDetail) {
  const Config config = offset_config();
  const Texture texture = ramp(config, 4);
  const auto level = [&](std::int64_t lod) {
    return code_of(sample_texture(config, texture, Wrap::kRepeat, Wrap::kRepeat, 12345, -54321, lod).bump[2]);
  };
  const std::int64_t one = 1 << config.lod_bits;
  EXPECT_EQ(level(-one), 0);
  EXPECT_EQ(level(-1), 0) << "43: below 0 magnifies";
  for (std::int64_t l = 1; l <= 4; ++l) EXPECT_EQ(level(l * one), static_cast<double>(l));
  EXPECT_NEAR(level(2 * one + 1), 2 + 1.0 / 32, 1 / 16.0);
  EXPECT_NEAR(level(2 * one - 1), 2 - 1.0 / 32, 1 / 16.0);
  EXPECT_EQ(level(4 * one + 1), 4) << "43: above the last level";
  EXPECT_EQ(level(9 * one), 4);
  const Texture dot = constant_texture(config, 0x332211, 0);
  EXPECT_EQ(code_of(sample_texture(config, dot, Wrap::kRepeat, Wrap::kMirror, 7777, -7777, 99).bump[2]), 0x33) << "41";
}

// 44, 45: opposed texels average to the zero vector.
TEST(Texture, OpposedTexelsCancel) {
  const Config config = with({{&Config::decode, 0}});
  Texture texture = constant_texture(config, 0, 1);
  texture.levels[0] = {0xffffff, 0x000000, 0x000000, 0xffffff};
  const std::int64_t corner = 1 << (config.uv_bits - 1);
  EXPECT_EQ(sample_texture(config, texture, Wrap::kRepeat, Wrap::kRepeat, corner, corner, 0).bump,
            (std::vector<std::int64_t>{0, 0, 0}))
      << "45: checker";
  Texture levels = constant_texture(config, 0xffffff, 1);
  levels.levels[1] = {0};
  EXPECT_EQ(sample_texture(config, levels, Wrap::kRepeat, Wrap::kRepeat, 0, 0, 1 << (config.lod_bits - 1)).bump,
            (std::vector<std::int64_t>{0, 0, 0}))
      << "44: half way between opposed levels";
}

TEST(Texture, WithoutTexelsNormalIsZeroDecalWhiteAndGlossFull) {
  const Config config = with({{&Config::decal, 1}, {&Config::gloss_map, 1}});
  Context context = make_context(config);
  set_draw(context, {}, nullptr);
  auto batch = std::make_unique<Batch<std::int64_t>>(context.config);
  batch->count = 1;
  batch->texture_bump[1][0] = batch->texture_decal[1][0] = batch->texture_gloss[0][0] = 77;
  batch = run_one(context, kTexture, std::move(batch));
  EXPECT_EQ(batch->texture_bump[1][0], 0);
  EXPECT_EQ(batch->texture_decal[1][0], 255);
  EXPECT_EQ(batch->texture_gloss[0][0], 255);
}

// 4,500 samples by OpenGL's rule in double precision, made elsewhere. The bound in codes: u and v have 12 fraction
// bits, so weights of 8 bits are exact at sizes 32 and 16; below, half a weight's LSB an axis of up to 255 codes.
TEST(Texture, SamplesMadeElsewhere) {
  std::ifstream in(std::string(WRINKLE_SHARED_DIR) + "/assets/vectors/trilinear_32x32.txt");
  if (!in) GTEST_SKIP() << "../shared/assets/vectors/trilinear_32x32.txt is not there";
  const Config config =
      with({{&Config::uv_bits, 12}, {&Config::lod_bits, 8}, {&Config::vector_bits, 18}, {&Config::decode, 1}});
  Worst large("trilinear_32x32.txt, levels 0-1, codes", std::ldexp(1.0, -10));
  Worst all("trilinear_32x32.txt, all levels, codes", 1.0);
  Texture texture;
  texture.log2_width = texture.log2_height = 5;
  int count = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('#')) continue;
    if (line.starts_with('M')) {
      texture.levels.emplace_back();
    } else if (line.starts_with('S')) {
      std::istringstream fields(line.substr(1));
      int mode, u, v, lod;
      double expected;
      fields >> mode >> u >> v >> lod >> expected;
      const auto wrap = static_cast<Wrap>(mode);
      const auto n = sample_texture(config, texture, wrap, wrap, u, v, lod).bump[0];
      const double code = (std::ldexp(static_cast<double>(n), -10) + 256) / 2;
      (lod <= 256 ? large : all).see(code - expected, line);
      ++count;
    } else {
      for (std::size_t i = 0; i + 1 < line.size(); i += 2)
        texture.levels.back().push_back(std::stoul(line.substr(i, 2), nullptr, 16));
    }
  }
  EXPECT_EQ(count, 4500);
}

}  // namespace
}  // namespace wrinkle

// output against its exact twin, given the very intensities that the hardware got.
#include "golden/exact/output.h"

#include <cmath>

#include "tests/stage/support.h"

namespace wrinkle {
namespace {

TEST(Output, LanesAgree) { expect_lanes_agree(kOutput, 8); }

TEST(Output, ColourStaysWithinItsBound) {
  Worst plain("output colour, ulp of u0.C", 0.5), decal("output colour with decal, share of its bound", 1),
      glossy("output colour with gloss, share of its bound", 1);
  std::uint64_t seed = base_seed();
  for (const auto& [name, config] : configurations(40)) {
    SCOPED_TRACE(name);
    Random random(++seed);
    const Context context = random_context(config, random);
    auto batch = std::make_unique<Batch<std::int64_t>>(context.config);
    fill(config, seed, *batch);
    batch->count = kBatch;
    batch = run_one(context, kOutput, std::move(batch));
    const double full = (1 << config.colour_bits) - 1;
    const auto unit = [&](int code) { return std::ldexp(code, -config.colour_bits); };
    for (std::size_t k = 0; k < static_cast<std::size_t>(context.config.count); ++k) {
      for (std::size_t i = 0; i < kBatch; ++i) {
        exact::Lit lit;
        lit.diffuse = std::ldexp(static_cast<double>(batch->light_diffuse[0][i]), -config.dot_bits);
        if (context.config.glossy != 0)
          lit.specular = std::ldexp(static_cast<double>(batch->light_specular[0][i]), -config.power_bits);
        const double code =
            config.decal == 0 ? 1 : static_cast<double>(batch->texture_decal[k][i]) / ((1 << config.texel_bits) - 1);
        const double gloss = config.gloss_map == 0
                                 ? 1
                                 : static_cast<double>(batch->texture_gloss[0][i]) / ((1 << config.texel_bits) - 1);
        const double exact = exact::shade(unit(context.draw.ambient[k]), unit(context.draw.diffuse[k]),
                                          gloss * unit(context.draw.specular[k]), code, lit);
        const double error = static_cast<double>(batch->output_colour[k][i]) - full * exact;
        // The decal code / (2^T - 1) as (code + its top bit) / 2^T is right to 2^-(T+1), of a base up to 2.
        const double code_error = full * 2 * std::ldexp(0.51, -config.texel_bits);
        const double base_error = full * std::ldexp(0.5, -config.colour_bits - config.dot_bits);
        const double decal_error = config.decal != 0 ? code_error + base_error : 0;
        // The same of the gloss, of a highlight up to 1, which is then rounded.
        const double gloss_error = full * (std::ldexp(0.51, -config.texel_bits) + std::ldexp(0.5, -config.power_bits));
        if (config.gloss_map != 0)
          glossy.see(error / (0.5 + decal_error + gloss_error));
        else
          config.decal != 0 ? decal.see(error / (0.5 + decal_error)) : plain.see(error);
      }
    }
  }
}

// 37: the sum saturates, each channel for itself; black and white are exact.
TEST(Output, ExtremesOfColour) {
  for (int bits : {4, 8, 12}) {
    const int one = 1 << bits;
    Context context = make_context(with({{&Config::colour_bits, bits}}));
    DrawWords draw;
    draw.ambient = {one, 0, 0};
    draw.diffuse = {one, one, 0};
    draw.specular = {one, 0, 0};
    set_draw(context, draw, nullptr);
    auto batch = std::make_unique<Batch<std::int64_t>>(context.config);
    batch->count = 1;
    batch->light_diffuse[0][0] = 1 << context.config.dot_bits;
    batch->light_specular[0][0] = 1 << context.config.power_bits;
    batch = run_one(context, kOutput, std::move(batch));
    EXPECT_EQ(batch->output_colour[0][0], one - 1) << "37: 3 saturates";
    EXPECT_EQ(batch->output_colour[1][0], one - 1) << "1 is white";
    EXPECT_EQ(batch->output_colour[2][0], 0) << "0 is black";
  }
}

// Both configurations, given the same intensities, a white decal and full gloss: the same colours.
void expect_same_colours(const Config& plain, const Config& textured) {
  Random random(base_seed());
  for (int round = 0; round < 20; ++round) {
    Context a = make_context(plain), b = make_context(textured);
    const DrawWords draw = random_draw(plain, random);
    set_draw(a, draw, nullptr);
    set_draw(b, draw, nullptr);
    auto first = std::make_unique<Batch<std::int64_t>>(a.config),
         second = std::make_unique<Batch<std::int64_t>>(b.config);
    fill(plain, base_seed() + static_cast<std::uint64_t>(round), *first);
    std::ranges::copy(first->light_diffuse, second->light_diffuse.begin());
    std::ranges::copy(first->light_specular, second->light_specular.begin());
    for (auto& column : second->texture_decal) column.fill((1 << textured.texel_bits) - 1);
    for (auto& column : second->texture_gloss) column.fill((1 << textured.texel_bits) - 1);
    first->count = second->count = kBatch;
    first = run_one(a, kOutput, std::move(first));
    second = run_one(b, kOutput, std::move(second));
    EXPECT_TRUE(std::ranges::equal(first->output_colour, second->output_colour));
  }
}

// A white decal leaves the colour as it is, bit for bit.
TEST(Output, WhiteDecalIsNeutral) { expect_same_colours({}, with({{&Config::decal, 1}})); }

// So does full gloss: a draw or a scene without a gloss map looks as without the multiplier.
TEST(Output, FullGlossIsNeutral) {
  for (int bits : {4, 8, 10}) {
    expect_same_colours({}, with({{&Config::gloss_map, 1}, {&Config::texel_bits, bits}}));
    expect_same_colours({}, with({{&Config::gloss_map, 1}, {&Config::decal, 1}, {&Config::texel_bits, bits}}));
  }
}

// Without gloss the colour is that of a black specular colour, whatever the highlight.
TEST(Output, NoGlossLeavesNoHighlight) {
  Random random(base_seed());
  const Config config = with({{&Config::gloss_map, 1}});
  DrawWords draw = random_draw(config, random);
  draw.specular.fill(1 << config.colour_bits);
  std::array<std::unique_ptr<Batch<std::int64_t>>, 2> batches;
  for (std::size_t matt : {0, 1}) {
    Context context = make_context(config);
    if (matt != 0) draw.specular = {};
    set_draw(context, draw, nullptr);
    batches[matt] = std::make_unique<Batch<std::int64_t>>(context.config);
    fill(config, base_seed(), *batches[matt]);
    for (auto& column : batches[matt]->texture_gloss) column.fill(matt != 0 ? 77 : 0);
    batches[matt]->count = kBatch;
    batches[matt] = run_one(context, kOutput, std::move(batches[matt]));
  }
  EXPECT_TRUE(std::ranges::equal(batches[0]->output_colour, batches[1]->output_colour));
}

}  // namespace
}  // namespace wrinkle

// What the tests of the stages share: configurations, inputs, and the comparison of all instances of the one source.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "golden/pixel/lane_bits.h"
#include "golden/pixel/stages.h"
#include "hwy/targets.h"
#include "tb/random_config.h"
#include "tb/random_texels.h"

namespace wrinkle {

using Random = std::mt19937_64;

inline std::int64_t uniform(Random& random, std::int64_t low, std::int64_t high) {
  return std::uniform_int_distribution<std::int64_t>(low, high)(random);
}

// All seeds come from here, so that one environment variable moves every random test.
inline std::uint64_t base_seed() {
  const char* text = std::getenv("WRINKLE_SEED");
  return text != nullptr ? std::strtoull(text, nullptr, 10) : 1997;
}

using NamedConfig = std::pair<std::string, Config>;

inline Config with(std::initializer_list<std::pair<int Config::*, int>> changes) {
  Config config;
  for (const auto& [member, value] : changes) config.*member = value;
  return config;
}

// Vectors are normalized after the dot products.
inline Config deferred(std::initializer_list<std::pair<int Config::*, int>> changes) {
  Config config = with(changes);
  config.normalize_order = 1;
  config.self_shadow = 0;
  return config;
}

inline Config extreme(bool highest) {
  Config config;
  for (const Parameter& p : parameters())
    if (p.values.empty()) config.*p.member = highest ? p.maximum : p.minimum;
  if (highest) config.q_bits = config.reciprocal_bits + 1;
  config.reciprocal_bits = std::max(config.reciprocal_bits, config.q_bits - 1);
  config.perspective = 1;
  config.decal = config.gloss_map = 1;
  return config;
}

inline Config random_config(Random& random) {
  return wrinkle::random_config([&](int low, int high) { return uniform(random, low, high); });
}

// Every choice at least once, the ends of all widths, and random ones.
inline std::vector<NamedConfig> configurations(int random_count = 12) {
  std::vector<NamedConfig> list{
      {"default", {}},
      {"phong", with({{&Config::datapath, 0}})},
      {"phong with decal", with({{&Config::datapath, 0}, {&Config::decal, 1}})},
      {"diffuse", with({{&Config::lighting, 0}, {&Config::channels, 0}})},
      {"no normalizers", with({{&Config::normalizer_n, 0}, {&Config::normalizer_l, 0}, {&Config::normalizer_h, 0}})},
      {"compact, lite and near",
       with({{&Config::normalizer_n, 2}, {&Config::normalizer_l, 3}, {&Config::normalizer_h, 4}})},
      {"wide compact, lite and near", with({{&Config::datapath, 2},
                                            {&Config::wide_bits, 22},
                                            {&Config::unit_bits, 16},
                                            {&Config::normalizer_n, 2},
                                            {&Config::normalizer_l, 4},
                                            {&Config::normalizer_h, 3}})},
      {"compact at half-angle of the pixel", with({{&Config::lighting, 3},
                                                   {&Config::normalizer_n, 3},
                                                   {&Config::normalizer_l, 4},
                                                   {&Config::normalizer_h, 2}})},
      {"widest compact in 32 bits", with({{&Config::vector_bits, 12},
                                          {&Config::unit_bits, 12},
                                          {&Config::normalizer_n, 2},
                                          {&Config::normalizer_l, 2},
                                          {&Config::normalizer_h, 2}})},
      {"hard shadow", with({{&Config::self_shadow, 1}})},
      {"no shadow", with({{&Config::self_shadow, 0}})},
      {"smooth shadow", with({{&Config::self_shadow, 2}})},
      {"nearest", with({{&Config::filter, 0}})},
      {"bilinear", with({{&Config::filter, 1}, {&Config::decode, 1}})},
      {"perspective", with({{&Config::perspective, 1}})},
      {"decal", with({{&Config::decal, 1}, {&Config::depth, 0}})},
      {"gloss", with({{&Config::gloss_map, 1}})},
      {"gloss and decal of a texel over 64 bits",
       with({{&Config::gloss_map, 1}, {&Config::decal, 1}, {&Config::texel_bits, 10}})},
      {"phong with gloss", with({{&Config::datapath, 0}, {&Config::gloss_map, 1}, {&Config::channels, 0}})},
      {"rotated with gloss, nearest", with({{&Config::datapath, 3}, {&Config::gloss_map, 1}, {&Config::filter, 0}})},
      {"narrowest colour with widest gloss",
       with({{&Config::gloss_map, 1}, {&Config::colour_bits, 4}, {&Config::texel_bits, 10}})},
      {"blinn", with({{&Config::datapath, 2}})},
      {"blinn with decal, constant cross products",
       with({{&Config::datapath, 2}, {&Config::decal, 1}, {&Config::cross_products, 1}, {&Config::filter, 1}})},
      {"widest blinn", with({{&Config::datapath, 2}, {&Config::wide_bits, 22}, {&Config::gradient_bits, 12}})},
      {"rotated", with({{&Config::datapath, 3}})},
      {"constant light vectors", with({{&Config::light_vectors, 1}})},
      {"reflection", with({{&Config::lighting, 2}})},
      {"reflection, not normalized", with({{&Config::lighting, 2},
                                           {&Config::normalizer_n, 0},
                                           {&Config::normalizer_l, 0},
                                           {&Config::normalizer_h, 0}})},
      {"half-angle of the pixel", with({{&Config::lighting, 3}})},
      {"half-angle of the pixel, constant light vectors", with({{&Config::lighting, 3}, {&Config::light_vectors, 1}})},
      {"normalized after", deferred({})},
      {"normalized after, diffuse", deferred({{&Config::lighting, 0}, {&Config::vector_bits, 7}})},
      {"normalized after, blinn", deferred({{&Config::datapath, 2}, {&Config::perspective, 1}})},
      {"normalized after, narrowest dots of the longest vectors",
       deferred({{&Config::unit_bits, 13}, {&Config::dot_bits, 6}, {&Config::power_bits, 6}})},
      {"normalized after, widest",
       deferred(
           {{&Config::vector_bits, 18}, {&Config::unit_bits, 16}, {&Config::dot_bits, 16}, {&Config::power_bits, 18}})},
      {"narrowest", extreme(false)},
      {"widest", extreme(true)},
  };
  Random random(base_seed());
  for (int i = 0; i < random_count; ++i) list.emplace_back("random " + std::to_string(i), random_config(random));
  return list;
}

// The values that a column can hold. Stages that follow a normalizer or a clamp see less than the format allows.
struct Range {
  std::int64_t low, high;
};
inline Range range_of(const Shape& config, const Value& value) {
  const auto up_to = [](int bits) { return std::int64_t{1} << bits; };
  if (value.stage == "light") return {0, up_to(value.fraction_bits)};
  if (value.stage == "normalize" && config.normalizes_after != 0 && value.is_signed)
    return {1 - up_to(value.fraction_bits), up_to(value.fraction_bits) - 1};
  if (value.stage == "normalize" && value.is_signed) {
    const int normalizer = value.name == "n"   ? config.normalizer_n
                           : value.name == "l" ? config.normalizer_l
                                               : config.normalizer_h;
    const std::int64_t one = up_to(value.fraction_bits);
    if (normalizer == static_cast<int>(Normalizer::kLite)) return {-one - one / 32, one + one / 32};
    if (normalizer != static_cast<int>(Normalizer::kNone)) return {-one, one};
  }
  if (value.name == "lod" && config.perspective == 0) return {0, up_to(value.width - 2) - 1};
  if (value.is_signed) return {-up_to(value.width - 1), up_to(value.width - 1) - 1};
  return {0, up_to(value.width) - 1};
}

// Ends, powers of two and their neighbours half of the time, anything the other half.
inline std::int64_t pattern(Random& random, Range range) {
  if (uniform(random, 0, 1) == 0) return uniform(random, range.low, range.high);
  const std::int64_t power = std::int64_t{1} << uniform(random, 0, 40);
  const std::int64_t near[] = {range.low, range.high, 0, power, -power};
  return std::clamp(near[uniform(random, 0, 4)] + uniform(random, -1, 1), range.low, range.high);
}

// Fills every value with patterns: the same for both lane widths.
template <class Int>
void fill(const Config& config, std::uint64_t seed, Batch<Int>& batch) {
  Random random(seed);
  const std::vector<Value> list = values(config);
  for (std::size_t v = 0; v < list.size(); ++v)
    for (auto& column : batch.value[v])
      for (std::size_t i = 0; i < kBatch; ++i) column[i] = static_cast<Int>(pattern(random, range_of(config, list[v])));
}

// Draw states of all kinds.
inline DrawWords random_draw(const Shape& config, Random& random) {
  DrawWords draw;
  draw.bump = config.bump_components != 0 && uniform(random, 0, 2) != 0;
  draw.textured = config.textured != 0 && (draw.bump || config.tints != 0);
  draw.shadow = uniform(random, 0, 1) != 0;
  draw.exponent_zero = uniform(random, 0, 7) == 0;
  draw.wrap_u = static_cast<int>(uniform(random, 0, 2));
  draw.wrap_v = static_cast<int>(uniform(random, 0, 2));
  draw.log2_width = static_cast<int>(uniform(random, 0, 6));
  draw.log2_height = static_cast<int>(uniform(random, 0, 6));
  draw.max_level = static_cast<int>(uniform(random, 0, std::max(draw.log2_width, draw.log2_height)));
  draw.squarings = static_cast<int>(uniform(random, 0, config.specular_squarings));
  if (config.has_light_planes == 0)
    for (auto* vector : {&draw.l, &draw.h})
      for (int& component : *vector)
        component = static_cast<int>(pattern(random, {-(1 << config.unit_bits), 1 << config.unit_bits}));
  for (auto* colour : {&draw.ambient, &draw.diffuse, &draw.specular})
    for (int& channel : *colour) channel = static_cast<int>(pattern(random, {0, 1 << config.colour_bits}));
  return draw;
}

inline Texture random_texture(const Shape& config, const DrawWords& draw, Random& random) {
  Texture texture;
  texture.log2_width = draw.log2_width;
  texture.log2_height = draw.log2_height;
  texture.components = config.texels;
  texture.component_bits = config.texel_bits;
  for (int level = 0; level <= draw.max_level; ++level) {
    auto& words = texture.levels.emplace_back();
    const int texels = texture.width(level) * texture.height(level);
    words.resize(static_cast<std::size_t>(texels) * static_cast<std::size_t>(texture.texel_words()));
    for (int i = 0; i < texels; ++i)
      for (int k = 0; k < texture.components; ++k)
        put_code(texture, words, static_cast<std::size_t>(i), k,
                 static_cast<std::uint64_t>(pattern(random, {0, (1 << config.texel_bits) - 1})));
  }
  return texture;
}

// A context with a random draw and texture bound.
inline Context random_context(const Config& config, Random& random) {
  Context context = make_context(config);
  const DrawWords draw = random_draw(config, random);
  std::shared_ptr<const BoundTexture> texture;
  if (draw.textured)
    texture =
        std::make_shared<BoundTexture>(bind_texture(random_texture(config, draw, random), Shape(config).bump_components,
                                                    static_cast<Wrap>(draw.wrap_u), static_cast<Wrap>(draw.wrap_v)));
  set_draw(context, draw, std::move(texture));
  return context;
}

template <class Int>
void expect_same(const Config& config, const Batch<std::int64_t>& expected, const Batch<Int>& got) {
  FragmentValues a, b;
  for (int i = 0; i < expected.count; ++i) {
    extract(expected, i, a);
    extract(got, i, b);
    if (a == b) continue;
    const auto list = values(config);
    for (std::size_t v = 0; v < a.size(); ++v)
      ASSERT_EQ(a[v], b[v]) << list[v].stage << '_' << list[v].name << " of fragment " << i;
  }
}

// Calls body(name) once for each instruction set of this machine.
template <class Body>
void for_each_target(const Body& body) {
  const auto choose = [](std::int64_t targets) {
    hwy::SetSupportedTargetsForTest(targets);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  };
  for (std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    choose(target);
    body(std::string(simd_target()));
  }
  choose(0);
}

// Plain, checked and SIMD lanes of both widths give the same values: patterns in, one stage, all targets.
inline void expect_lanes_agree(unsigned stage, int rounds = 4) {
  std::uint64_t seed = base_seed();
  for (const auto& [name, config] : configurations()) {
    for (int round = 0; round < rounds; ++round) {
      SCOPED_TRACE(name + ", seed " + std::to_string(++seed));
      Random random(seed);
      const Context context = random_context(config, random);
      const auto run = [&]<class Int>(Lanes lanes, Int) {
        auto batch = std::make_unique<Batch<Int>>(config);
        fill(config, seed, *batch);
        batch->count = round == 0 ? 1 : kBatch - 5 * round;
        run_stages(lanes, context, stage, *std::make_unique<Spans<Int>>(), *batch);
        return batch;
      };
      const auto scalar = run(Lanes::kScalar, std::int64_t{});
      ASSERT_NO_THROW(expect_same(config, *scalar, *run(Lanes::kChecked, std::int64_t{})));
      for_each_target([&](const std::string& target) {
        SCOPED_TRACE(target);
        expect_same(config, *scalar, *run(Lanes::kSimd, std::int64_t{}));
        if (lane_bits(config) == 32) expect_same(config, *scalar, *run(Lanes::kSimd, std::int32_t{}));
      });
    }
  }
}

// The worst error seen, against the bound that docs/numerics.md states.
class Worst {
 public:
  Worst(std::string what, double bound) : what_(std::move(what)), bound_(bound) {}
  ~Worst() { std::printf("%-48s measured %.6g, bound %.6g\n", what_.c_str(), worst_, bound_); }
  Worst(const Worst&) = delete;
  Worst& operator=(const Worst&) = delete;
  void see(double error, const std::string& where = {}) {
    worst_ = std::max(worst_, std::abs(error));
    if (std::abs(error) > bound_) ADD_FAILURE() << what_ << ": " << error << " exceeds " << bound_ << ' ' << where;
  }
  double worst() const { return worst_; }

 private:
  std::string what_;
  double bound_, worst_ = 0;
};

// One fragment through stages of the checked instance.
inline std::unique_ptr<Batch<std::int64_t>> run_one(const Context& context, unsigned stages,
                                                    std::unique_ptr<Batch<std::int64_t>> batch) {
  run_checked(context, stages, *std::make_unique<Spans<std::int64_t>>(), *batch);
  return batch;
}

}  // namespace wrinkle

// Configurations the bench is tested with.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "golden/config/config.h"
#include "golden/datapath/datapaths.h"

namespace wrinkle {

// Quick to build and to run, with every stage in it.
inline Config small_config() {
  Config c;
  c.perspective = 1;
  c.decal = 1;
  c.screen_bits = 6;
  c.vector_bits = 7;
  c.uv_bits = 12;
  c.q_bits = 10;
  c.reciprocal_bits = 10;
  c.lod_bits = 2;
  c.weight_bits = 3;
  c.texel_bits = 6;
  c.unit_bits = 6;
  c.dot_bits = 8;
  c.power_bits = 8;
  c.specular_squarings = 2;
  c.depth_bits = 10;
  return c;
}

// The small configuration by another datapath, illumination or source of light vectors, a name each.
struct Rival {
  const char* name;
  Config config;
};

inline std::vector<Rival> rivals() {
  const auto with = [](auto change) {
    Config c = small_config();
    change(c);
    return c;
  };
  const auto blinn = [](Config& c) {
    c.datapath = static_cast<int>(Datapath::kBlinn);
    c.wide_bits = 10;
    c.gradient_bits = 7;
  };
  const auto deferred = [](Config& c) {
    c.normalize_order = static_cast<int>(NormalizeOrder::kAfter);
    c.self_shadow = static_cast<int>(SelfShadow::kOff);
  };
  const auto lit = [](Config& c, Lighting lighting) { c.lighting = static_cast<int>(lighting); };
  return {
      {"blinn", with(blinn)},
      {"blinn_held", with([&](Config& c) {
         blinn(c);
         c.cross_products = static_cast<int>(CrossProducts::kConstant);
         c.perspective = 0;
       })},
      {"blinn_constant_light_reflection", with([&](Config& c) {
         blinn(c);
         lit(c, Lighting::kReflection);
         c.light_vectors = static_cast<int>(LightVectorSource::kConstant);
       })},
      {"rotated", with([](Config& c) { c.datapath = static_cast<int>(Datapath::kRotated); })},
      {"rotated_reflection", with([&](Config& c) {
         c.datapath = static_cast<int>(Datapath::kRotated);
         lit(c, Lighting::kReflection);
         c.decal = 0;
       })},
      {"constant_light", with([](Config& c) { c.light_vectors = static_cast<int>(LightVectorSource::kConstant); })},
      {"deferred", with(deferred)},
      {"deferred_diffuse", with([&](Config& c) {
         deferred(c);
         lit(c, Lighting::kDiffuse);
         c.vector_bits = 6;
       })},
      {"deferred_blinn", with([&](Config& c) {
         blinn(c);
         deferred(c);
         c.unit_bits = 8;
         c.dot_bits = 6;
       })},
      {"reflection", with([&](Config& c) { lit(c, Lighting::kReflection); })},
      {"gloss_without_decal", with([](Config& c) {
         c.gloss_map = 1;
         c.decal = 0;
       })},
      {"gloss_of_a_texel_over_64_bits", with([](Config& c) {
         c.gloss_map = 1;
         c.texel_bits = 10;
       })},
      {"shared_gloss", with([](Config& c) {
         c.sharing = c.gloss_map = 1;
         c.channels = 0;
       })},
      {"compact_lite_near", with([](Config& c) {
         c.normalizer_n = static_cast<int>(Normalizer::kCompact);
         c.normalizer_l = static_cast<int>(Normalizer::kLite);
         c.normalizer_h = static_cast<int>(Normalizer::kNear);
       })},
      {"without_normalizers",
       with([](Config& c) { c.normalizer_n = c.normalizer_l = c.normalizer_h = static_cast<int>(Normalizer::kNone); })},
      {"pixel_halfangle", with([&](Config& c) { lit(c, Lighting::kPixelHalfangle); })},
      {"constant_light_pixel_halfangle", with([&](Config& c) {
         lit(c, Lighting::kPixelHalfangle);
         c.light_vectors = static_cast<int>(LightVectorSource::kConstant);
       })},
      {"shared", with([](Config& c) { c.sharing = 1; })},
      {"shared_third_squaring", with([](Config& c) {
         c.sharing = 1;
         c.self_shadow = static_cast<int>(SelfShadow::kOff);
         c.decal = c.perspective = 0;
         c.specular_squarings = 5;
       })},
      {"single", with([](Config& c) { c.buffering = 1; })},
      {"single_blinn_held", with([&](Config& c) {
         blinn(c);
         c.buffering = 1;
         c.cross_products = static_cast<int>(CrossProducts::kConstant);
         c.perspective = 0;
       })},
      {"shared_single", with([](Config& c) {
         c.sharing = c.buffering = 1;
         c.self_shadow = static_cast<int>(SelfShadow::kSmooth);
       })},
      {"shared_single_unshadowed", with([](Config& c) {
         c.sharing = c.buffering = 1;
         c.self_shadow = static_cast<int>(SelfShadow::kOff);
         c.depth = c.decal = c.perspective = 0;
         c.specular_squarings = 4;
       })},
      {"shared_single_phong", with([](Config& c) {
         c.sharing = c.buffering = 1;
         c.datapath = static_cast<int>(Datapath::kPhong);
         c.decal = 0;
         c.specular_squarings = 1;
       })},
  };
}

// All that makes a packet long, as wide as it goes.
inline Config longest_packet() {
  Config config;
  for (const Parameter& parameter : parameters())
    if (parameter.values.empty()) config.*parameter.member = parameter.maximum;
  config.datapath = static_cast<int>(Datapath::kBlinn);
  config.q_bits = config.reciprocal_bits + 1;
  config.perspective = config.depth = config.decal = config.gloss_map = 1;
  return config;
}

// As short as it goes, and as narrow.
inline Config shortest_packet() {
  Config config;
  for (const Parameter& parameter : parameters())
    if (parameter.values.empty()) config.*parameter.member = parameter.minimum;
  config.datapath = static_cast<int>(Datapath::kRotated);
  config.lighting = static_cast<int>(Lighting::kDiffuse);
  config.depth = 0;
  return config;
}

inline constexpr int kSpread = 6;

// Six legal configurations. Every width takes six values from its minimum to its maximum, another in each; every choice
// takes all of its values.
inline Config spread_config(int index) {
  Config config;
  int turn = 0;
  for (const Parameter& parameter : parameters()) {
    const int range = parameter.maximum - parameter.minimum;
    ++turn;
    if (!parameter.values.empty()) {
      const int rank = (turn % 2 == 0 ? index + turn : kSpread - 1 - index + turn * turn) % kSpread;
      config.*parameter.member = rank * (range + 1) / kSpread;
      continue;
    }
    // The widths that bound each other grow together; the others are dealt in turn.
    const bool bound = parameter.member == &Config::unit_bits || parameter.member == &Config::dot_bits ||
                       parameter.member == &Config::power_bits || parameter.member == &Config::q_bits ||
                       parameter.member == &Config::reciprocal_bits;
    const int rank = bound ? index : (index + turn) % kSpread;
    config.*parameter.member = parameter.minimum + (range * rank + 2) / (kSpread - 1);
  }
  config.q_bits = std::min(config.q_bits, config.reciprocal_bits + 1);
  // What the choices do not allow each other.
  config.normalize_order = config.sharing = 0;
  if (Shape(config).light_may_be_constant == 0) config.light_vectors = 0;
  // Wide compact normalizers take long to build: tests/rtl/normalizer.sh has them alone.
  if (index >= kSpread / 2) {
    for (int Config::*normalizer : {&Config::normalizer_n, &Config::normalizer_l, &Config::normalizer_h})
      config.*normalizer = std::min(config.*normalizer, static_cast<int>(Normalizer::kFaithful));
  }
  if (Shape(config).normal_any_length != 0) config.normalizer_n = static_cast<int>(Normalizer::kFaithful);
  if (Shape(config).glossy == 0) config.gloss_map = 0;
  if (config.is(Lighting::kPixelHalfangle)) config.normalizer_h = static_cast<int>(Normalizer::kFaithful);
  return config;
}

}  // namespace wrinkle

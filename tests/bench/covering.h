// A few configurations in which every value of every parameter is simulated.
#pragma once

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "golden/config/config.h"
#include "golden/datapath/datapaths.h"
#include "sim/digest/choices.h"
#include "tb/stall.h"

namespace wrinkle {

// Whether a parameter changes anything that this configuration draws. A width counts as simulated only where it does.
inline bool is_in_use(const Shape& c, std::string_view name) {
  const auto among = [&](std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  if (among({"cross_products", "wide_bits", "gradient_bits"})) return c.datapath == static_cast<int>(Datapath::kBlinn);
  if (name == "decode") return c.datapath == static_cast<int>(Datapath::kNormalMapped);
  if (name == "lod_bits") return c.textured != 0 && c.trilinear != 0;
  if (name == "weight_bits") return c.textured != 0 && c.weight_fraction_bits > 0;
  if (among({"filter", "perspective", "uv_integer_bits", "uv_bits", "texel_bits", "texture_fifo_bits"}))
    return c.textured != 0;
  if (among({"q_bits", "reciprocal_bits"})) return c.q != 0;
  if (name == "depth_bits") return c.depth != 0;
  if (among({"power_bits", "specular_squarings"})) return c.glossy != 0;
  if (name == "normalizer_n") return c.normal != 0;
  if (name == "normalizer_l") return c.has_light_planes != 0;
  if (name == "normalizer_h") return c.glossy != 0 && (c.has_light_planes != 0 || c.is(Lighting::kPixelHalfangle));
  if (name == "vector_bits") return c.datapath <= static_cast<int>(Datapath::kNormalMapped) || c.has_light_planes != 0;
  return true;
}

// A value of a parameter; or the kind of a normalizer, and F.
using Setting = std::pair<std::string_view, int>;
constexpr std::array<std::string_view, 5> kKinds{"none", "faithful", "compact", "lite", "near"};

inline std::set<Setting> settings_in_use(const Config& config) {
  std::set<Setting> settings;
  for (const Parameter& parameter : parameters()) {
    if (parameter.scope != Scope::core || !is_in_use(config, parameter.name)) continue;
    const int value = config.*parameter.member;
    settings.emplace(parameter.name, value);
    if (parameter.name.starts_with("normalizer_") && config.normalize_order == 0)
      settings.emplace(kKinds[static_cast<std::size_t>(value)], config.unit_bits);
  }
  return settings;
}

// All that some legal configuration uses.
inline std::set<Setting> all_settings() {
  std::set<Setting> settings;
  for (const Parameter& parameter : parameters()) {
    if (parameter.scope != Scope::core) continue;
    for (int value = parameter.minimum; value <= parameter.maximum; ++value) {
      settings.emplace(parameter.name, value);
      if (parameter.name == "unit_bits")
        for (const std::string_view kind : kKinds) settings.emplace(kind, value);
    }
  }
  // Wider than 1 + reciprocal_bits q is only without `perspective`, where nothing reads it.
  for (int bits = 22; bits <= 24; ++bits) settings.erase({"q_bits", bits});
  return settings;
}

// What the widths and choices of a random configuration demand of each other, given to them.
inline void make_legal(Config& c, Random& random) {
  c.dot_bits = std::min(c.dot_bits, 2 * c.unit_bits);
  c.power_bits = std::max(c.power_bits, c.dot_bits);
  c.reciprocal_bits = std::max(c.reciprocal_bits, std::min(c.q_bits - 1, 20));
  c.q_bits = std::min(c.q_bits, c.reciprocal_bits + 1);
  if (c.sharing != 0) share_units(c);
  if (c.normalize_order != 0) normalize_after(c);
  if (Shape(c).normal == 0) c.light_vectors = 0;
  if (Shape(c).glossy == 0) c.gloss_map = 0;
  const auto of_any_length = [&] { return random.between(1, 3); };
  if (c.datapath == static_cast<int>(Datapath::kBlinn)) c.normalizer_n = of_any_length();
  if (c.is(Lighting::kPixelHalfangle)) c.normalizer_h = of_any_length();
}

// A legal configuration of mostly what is still wanted; the rest is random.
inline Config candidate(const std::set<Setting>& wanted, Random& random) {
  Config config;
  do {
    for (const Parameter& parameter : parameters()) {
      std::vector<int> values;
      for (int value = parameter.minimum; value <= parameter.maximum; ++value)
        if (wanted.contains({parameter.name, value})) values.push_back(value);
      const bool take = !values.empty() && random.below(8) != 0;
      config.*parameter.member = take ? values[random.below(static_cast<std::uint32_t>(values.size()))]
                                      : random.between(parameter.minimum, parameter.maximum);
    }
    // What most widths are in use with.
    if (random.below(4) != 0) config.datapath = static_cast<int>(Datapath::kBlinn);
    if (random.below(8) != 0) config.perspective = config.depth = 1;
    if (random.below(4) != 0) config.sharing = 0;
    if (random.below(4) != 0) config.normalize_order = 0;
    make_legal(config, random);
  } while (!check(config).key.empty());
  return config;
}

// Greedy: of many candidates the one that has most of what is still wanted, until nothing is.
inline const std::vector<Config>& covering_configs() {
  static const std::vector<Config> configs = [] {
    Random random(1);
    std::vector<Config> chosen;
    std::set<Setting> wanted = all_settings();
    while (!wanted.empty()) {
      Config best;
      int most = 0;
      for (int i = 0; i < 300 || most == 0; ++i) {
        const Config config = candidate(wanted, random);
        int count = 0;
        for (const Setting& setting : settings_in_use(config)) count += wanted.contains(setting);
        if (count <= most) continue;
        best = config;
        most = count;
      }
      for (const Setting& setting : settings_in_use(best)) wanted.erase(setting);
      chosen.push_back(best);
    }
    return chosen;
  }();
  return configs;
}

}  // namespace wrinkle

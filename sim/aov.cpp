#include "sim/aov.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "sim/input_error.h"

namespace wrinkle {
namespace {

using Exact = double (*)(const ExactFragment&);

struct Aov {
  std::string_view name, description;
  std::string_view stage, value;  // of values.def; empty for `triangle`
  std::vector<Exact> exact;       // one per element
};

#define WRINKLE_EXACT(member) [](const ExactFragment& f) { return f.member; }
#define WRINKLE_EXACT3(member) \
  { WRINKLE_EXACT(member.x), WRINKLE_EXACT(member.y), WRINKLE_EXACT(member.z) }

const std::vector<Aov>& table() {
  static const std::vector<Aov> all{
      {"N", "unit normal, perturbed", "normalize", "n", WRINKLE_EXACT3(n)},
      {"L", "unit light vector", "normalize", "l", WRINKLE_EXACT3(l)},
      {"H", "unit half-angle vector", "normalize", "h", WRINKLE_EXACT3(h)},
      {"NL", "N.L, clamped", "light", "nl", {WRINKLE_EXACT(nl)}},
      {"NH", "N.H, clamped", "light", "nh", {WRINKLE_EXACT(nh)}},
      {"diffuse", "after self-shadow", "light", "diffuse", {WRINKLE_EXACT(diffuse)}},
      {"specular", "power of N.H, after self-shadow", "light", "specular", {WRINKLE_EXACT(specular)}},
      {"u", "texture coordinate", "interpolate", "u", {WRINKLE_EXACT(u)}},
      {"v", "texture coordinate", "interpolate", "v", {WRINKLE_EXACT(v)}},
      {"lod", "level of detail", "interpolate", "lod", {WRINKLE_EXACT(lod)}},
      {"z", "depth", "interpolate", "z", {WRINKLE_EXACT(z)}},
      {"interpolated_N", "normal from the vertices", "interpolate", "n", WRINKLE_EXACT3(frame[0])},
      {"interpolated_L", "light vector from the vertices", "interpolate", "l", WRINKLE_EXACT3(interpolated_l)},
      {"interpolated_H", "half-angle vector from the vertices", "interpolate", "h", WRINKLE_EXACT3(interpolated_h)},
      {"texture_N",
       "normal from the texture",
       "texture",
       "n",
       {WRINKLE_EXACT(bump[0]), WRINKLE_EXACT(bump[1]), WRINKLE_EXACT(bump[2])}},
      {"gradient",
       "slopes fu, fv from the texture",
       "texture",
       "gradient",
       {WRINKLE_EXACT(bump[0]), WRINKLE_EXACT(bump[1])}},
      {"decal", "base colour from the texture", "texture", "decal", WRINKLE_EXACT3(decal)},
      {"triangle", "1 + number of the triangle in the frame, 0 where there is none", "", "", {}},
  };
  return all;
}

#undef WRINKLE_EXACT3
#undef WRINKLE_EXACT

// u and v are those that the texture stage reads: after the division, where there is one.
std::string_view stage_of(const Config& config, const Aov& aov) {
  if (config.perspective != 0 && (aov.name == "u" || aov.name == "v")) return "perspective";
  return aov.stage;
}

// Vectors that are normalized after the dot products are mantissas; times its scale each has unit length.
void multiply_by_scale(const std::vector<Value>& all, AovChannel& channel) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].stage != "normalize" || all[i].name != "scale") continue;
    const std::string_view vector = all[std::size_t(channel.value)].name;
    channel.factor = int(i);
    channel.factor_element = vector == "n" ? 0 : vector == "l" ? 1 : 2;
    channel.scale = std::ldexp(channel.scale, -all[i].fraction_bits);
  }
}

void append(const Config& config, const Aov& aov, std::vector<AovChannel>& channels) {
  if (aov.stage.empty()) {
    channels.push_back({.name = std::string(aov.name)});
    return;
  }
  const std::vector<Value> all = values(config);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Value& value = all[i];
    if (value.stage != stage_of(config, aov) || value.name != aov.value) continue;
    for (std::size_t e = 0; e < aov.exact.size(); ++e) {
      const std::string suffix = aov.exact.size() == 1 ? "" : fmt::format(".{}", "xyz"[e]);
      channels.push_back(
          {std::string(aov.name) + suffix, int(i), e, std::ldexp(1.0, -value.fraction_bits), aov.exact[e]});
      if (config.normalizes_after() && value.stage == "normalize") multiply_by_scale(all, channels.back());
    }
    return;
  }
  throw InputError(Place{fmt::format("--aov {}", aov.name)},
                   fmt::format("this configuration has no {}_{}", stage_of(config, aov), aov.value));
}

}  // namespace

std::vector<AovName> aov_names() {
  std::vector<AovName> names;
  for (const Aov& aov : table()) names.push_back({aov.name, aov.description});
  return names;
}

std::vector<AovChannel> aov_channels(const Config& config, const std::vector<std::string>& names) {
  std::vector<AovChannel> channels;
  for (const std::string& name : names) {
    const Aov* found = nullptr;
    std::vector<std::string_view> known;
    for (const Aov& aov : table()) {
      known.push_back(aov.name);
      if (aov.name == name) found = &aov;
    }
    if (!found) throw InputError(Place{"--aov"}, name, fmt::format("one of {}", fmt::join(known, ", ")));
    append(config, *found, channels);
  }
  return channels;
}

}  // namespace wrinkle

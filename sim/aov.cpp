#include "sim/aov.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "sim/input_error.h"

namespace wrinkle {
namespace {

double element_of(double value, std::size_t) { return value; }
double element_of(const Vec3& v, std::size_t k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; }
double element_of(const BumpComponents& bump, std::size_t k) { return bump[k]; }
double element_of(const FrameVectors& frame, std::size_t k) { return element_of(frame[k / 3], k % 3); }

struct Twin {
  std::string_view wire;
  ExactNumber number;
};
constexpr Twin kTwins[] = {
#define WRINKLE_EXACT(type, name, initial, wire) \
  {#wire, [](const ExactFragment& f, std::size_t k) { return element_of(f.name, k); }},
#include "golden/exact/fragment.def"
#undef WRINKLE_EXACT
};

struct ShortName {
  std::string_view name, value, description;
};
constexpr ShortName kShortNames[] = {
    {"N", "normalize_n", "unit normal, perturbed"},
    {"L", "normalize_l", "unit light vector"},
    {"H", "normalize_h", "unit half-angle vector"},
    {"NL", "light_nl", "N.L, clamped"},
    {"NH", "light_nh", "N.H, clamped"},
    {"diffuse", "light_diffuse", "after self-shadow"},
    {"specular", "light_specular", "power of N.H, after self-shadow"},
    {"u", "interpolate_u", "texture coordinate, divided where there is a division"},
    {"v", "interpolate_v", "texture coordinate, divided where there is a division"},
    {"lod", "interpolate_lod", "level of detail"},
    {"z", "interpolate_z", "depth"},
    {"decal", "texture_decal", "base colour from the texture"},
    {"gloss", "texture_gloss", "factor of the highlight from the texture"},
};
constexpr std::string_view kTriangle = "triangle";

// The twins have u and v as `perspective` hands them on.
bool is_divided(const Shape& config, std::string_view wire) {
  return config.divides != 0 && (wire == "interpolate_u" || wire == "interpolate_v");
}

// Null where a value has no twin. The picture has the colours themselves.
ExactNumber twin_of(const Shape& config, const Value& value) {
  if (value.stage == "output" || is_divided(config, value.wire)) return nullptr;
  const std::string_view wire = value.wire == "perspective_u"   ? "interpolate_u"
                                : value.wire == "perspective_v" ? "interpolate_v"
                                                                : value.wire;
  const auto twin = std::find_if(std::begin(kTwins), std::end(kTwins), [&](const Twin& t) { return t.wire == wire; });
  return twin == std::end(kTwins) ? nullptr : twin->number;
}

std::string full_name(const Value& value) { return fmt::format("{}_{}", value.stage, value.name); }

// The value that a name stands for.
std::string value_named(const Shape& config, std::string_view name) {
  for (const ShortName& known : kShortNames) {
    if (known.name != name) continue;
    const std::string divided = fmt::format("perspective_{}", name);
    return is_divided(config, known.value) ? divided : std::string(known.value);
  }
  return std::string(name);
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

void append(const Shape& config, const std::string& name, std::vector<AovChannel>& channels) {
  if (name == kTriangle) {
    channels.push_back({.name = name});
    return;
  }
  const std::vector<Value> all = values(config);
  const std::string wanted = value_named(config, name);
  std::vector<std::string> known{std::string(kTriangle)};
  for (const ShortName& short_name : kShortNames) known.emplace_back(short_name.name);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Value& value = all[i];
    const ExactNumber exact = twin_of(config, value);
    if (exact == nullptr) continue;
    known.push_back(full_name(value));
    if (known.back() != wanted) continue;
    for (std::size_t e = 0; e < std::size_t(value.elements); ++e) {
      const std::string suffix = value.elements == 1  ? ""
                                 : value.elements > 3 ? fmt::format(".{}", e)
                                                      : fmt::format(".{}", "xyz"[e]);
      channels.push_back({name + suffix, int(i), e, std::ldexp(1.0, -value.fraction_bits), exact,
                          std::size_t(value.first_element) + e});
      if (config.normalizes_after != 0 && value.stage == "normalize") multiply_by_scale(all, channels.back());
    }
    return;
  }
  if (wanted != name)
    throw InputError(Place{fmt::format("--aov {}", name)}, fmt::format("this configuration has no {}", wanted));
  throw InputError(Place{"--aov"}, name, fmt::format("one of {}", fmt::join(known, ", ")));
}

}  // namespace

std::string aov_help() {
  std::string text;
  for (const ShortName& known : kShortNames) text += fmt::format("\n  {}: {}", known.name, known.description);
  return text + fmt::format("\n  {}: 1 + number of the triangle in the frame, 0 where there is none", kTriangle) +
         "\n  STAGE_VALUE: any other value of docs/parameters.md that has an exact twin, such as texture_n";
}

std::vector<AovChannel> aov_channels(const Config& config, const std::vector<std::string>& names) {
  std::vector<AovChannel> channels;
  for (const std::string& name : names) append(config, name, channels);
  return channels;
}

}  // namespace wrinkle

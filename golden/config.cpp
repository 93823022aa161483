#include "golden/config.h"

#include <algorithm>

#include "golden/pixel/compact_geometry.h"
#include "golden/pixel/reciprocal.h"
#include "golden/pixel/rsqrt.h"

namespace wrinkle {
namespace {

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t bar = text.find('|'); bar != text.npos; bar = text.find('|')) {
    words.push_back(text.substr(0, bar));
    text.remove_prefix(bar + 1);
  }
  words.push_back(text);
  return words;
}

Parameter choice(std::string_view name, int Config::*member, int standard, std::string_view values,
                 std::string_view description) {
  auto names = split(values);
  const int maximum = static_cast<int>(names.size()) - 1;
  return {name, member, standard, 0, maximum, std::move(names), description};
}

IllegalParameter check_range(const Config& config, const Parameter& parameter) {
  const int value = config.*parameter.member;
  if (value >= parameter.minimum && value <= parameter.maximum) return {};
  std::string message = std::string(parameter.name) + " = " + std::to_string(value) + " is not ";
  if (parameter.values.empty()) {
    message += "in " + std::to_string(parameter.minimum) + " to " + std::to_string(parameter.maximum);
  } else {
    message += "one of";
    for (std::size_t i = 0; i < parameter.values.size(); ++i)
      message += (i == 0 ? " " : ", ") + std::string(parameter.values[i]);
  }
  return {std::string(parameter.name), message + " (" + std::string(parameter.description) + ")"};
}

IllegalParameter illegal(std::string key, int value, const std::string& range, const std::string& reason) {
  std::string message = key + " = " + std::to_string(value) + " is not " + range + ": " + reason;
  return {std::move(key), std::move(message)};
}

// Widest operand of each stage; the derivations are those of docs/numerics.md.

int interpolate_bits(const Config& c) {
  int width = c.vector_width();
  if (c.has_blinn()) width = std::max(width, c.wide_width());
  if (c.has_texture()) width = std::max(width, c.uv_width());
  if (c.has_texture() && c.perspective != 0) width = std::max({width, c.q_bits, 6 + c.lod_fraction_bits()});
  if (c.depth != 0) width = std::max(width, c.depth_bits);
  return width + c.guard_bits;  // accumulators are modular: no bit is lost to a sign
}

int perspective_bits(const Config& c) {
  if (!c.has_texture() || c.perspective == 0) return 0;
  const ReciprocalGeometry g{c.q_bits, c.reciprocal_bits};
  const int table = g.output_bits + kReciprocalGuard + 2 + g.offset_bits();
  const int doubled_product = c.uv_width() + c.reciprocal_bits + 2;
  return std::max(table, doubled_product);
}

int texture_bits(const Config& c) {
  if (!c.has_texture()) return 0;
  const int scaled_coordinate = c.uv_width() + c.coordinate_shift() + 1;
  const int doubled_code = c.texel_bits + c.filter_fraction_bits() + 2;
  return std::max({scaled_coordinate, doubled_code, c.vector_width()});
}

int perturb_bits(const Config& c) {
  // The three terms of N', each below 2^(VW + 1 + GB), and the half that rounds.
  return c.has_blinn() ? c.wide_bits + c.gradient_bits + 5 : 0;
}

// One unit, for vectors in s1.V.
int unit_bits_of(const Config& c, int vector_bits) {
  const RsqrtGeometry& g = rsqrt_geometry(c.unit_bits);
  const int magnitude = vector_bits + 1;
  const int sum = std::max(2 * magnitude + 3, g.input_bits + 1);
  const int table = g.output_bits + g.guard_bits + 2 + g.offset_bits();
  const int product = magnitude + g.output_bits + 2;
  const int bypass = std::max(vector_bits, c.unit_bits) + 3;
  return std::max({sum, table, product, bypass});
}

bool has_compact_unit(const Config& c) {
  const auto is_compact = [](int normalizer) { return normalizer >= static_cast<int>(Normalizer::kCompact); };
  return is_compact(c.normalizer_n) || is_compact(c.normalizer_l) || is_compact(c.normalizer_h);
}

// One unit of the kinds `compact`, `lite` and `near`, of which the first is the widest.
int compact_unit_bits_of(const Config& c, int vector_bits) {
  const CompactGeometry g = compact_geometry(Normalizer::kCompact, c.unit_bits, vector_bits);
  const int sum = 2 * g.magnitude_bits + 3;
  const int table = g.rsqrt.output_bits + g.rsqrt.guard_bits + 3 + g.rsqrt.offset_bits();
  const int product = g.magnitude_bits + g.rsqrt.output_bits + 2;
  return std::max({sum, table, product});
}

// V of the unit with the widest input.
int widest_unit_input_bits(const Config& c) {
  const int sum_of_two = c.is(Lighting::kPixelHalfangle) ? c.unit_bits + 1 : 0;
  return std::max({c.vector_bits, c.normal_unit_input_bits(), sum_of_two});
}

int normalize_bits(const Config& c) {
  const int vector_bits = widest_unit_input_bits(c);
  return std::max(unit_bits_of(c, vector_bits), has_compact_unit(c) ? compact_unit_bits_of(c, vector_bits) : 0);
}

int light_bits(const Config& c) {
  const auto magnitude = [&](int normalizer) {
    return c.unit_bits + (normalizer == static_cast<int>(Normalizer::kNone) ? 1 : 0);
  };
  const int other =
      c.has_specular() ? std::max(magnitude(c.normalizer_l), magnitude(c.normalizer_h)) : magnitude(c.normalizer_l);
  const int dot = magnitude(c.normalizer_n) + other + 3;
  const int shift = c.dot_bits + 5;
  // 2 (N.L) (N.E) - L.E, each product of two factors up to 2^F.
  const int reflected = c.is(Lighting::kReflection) ? dot + 2 : 0;
  // Dot product below 4 by scales below 4; the product of two scales.
  const int deferred = c.normalizes_after() ? std::max(2 * c.dot_bits + 6, 2 * c.scale_bits() + 3) : 0;
  return std::max({dot, reflected, shift, deferred, 2 * c.dot_bits + 2, 2 * c.power_bits + 2});
}

int output_bits(const Config& c) {
  const int with_decal = c.colour_bits + c.dot_bits + c.texel_bits + 3;
  return std::max(2 * c.colour_bits + c.power_bits + 3, c.decal != 0 ? with_decal : 0);
}

}  // namespace

int Config::scale_bits() const { return rsqrt_geometry(unit_bits).output_bits; }

std::span<const Parameter> parameters() {
  static const std::vector<Parameter> list = {
#define WRINKLE_CHOICE(name, standard, values, description) choice(#name, &Config::name, standard, values, description),
#define WRINKLE_WIDTH(name, standard, minimum, maximum, description) \
  {#name, &Config::name, standard, minimum, maximum, {}, description},
#include "golden/parameters.def"
#undef WRINKLE_CHOICE
#undef WRINKLE_WIDTH
  };
  return list;
}

// What the normalizers and the parts before them demand of each other.
static IllegalParameter check_normalizers(const Config& c) {
  const auto takes_any_length = [](int kind) {
    return kind != static_cast<int>(Normalizer::kNone) && kind != static_cast<int>(Normalizer::kNear);
  };
  const auto reject = [](std::string key, int kind, const std::string& reason) {
    const char* name = kind == static_cast<int>(Normalizer::kNone) ? "none" : "near";
    return IllegalParameter{key, key + " = " + name + " is not legal: " + reason};
  };
  if (c.has_blinn() && !takes_any_length(c.normalizer_n))
    return reject("normalizer_n", c.normalizer_n, "the length of Pu x Pv - fu Pv x N - fv N x Pu is anything");
  if (c.is(Lighting::kPixelHalfangle) && !takes_any_length(c.normalizer_h))
    return reject("normalizer_h", c.normalizer_h, "the length of L + E is anything up to 2");
  return {};
}

// What scaling after the dot products, one unit in turn, and both demand of the rest.
static IllegalParameter check_order_and_sharing(const Config& c) {
  const bool three_vectors = (c.is(Datapath::kPhong) || c.has_texture_normal()) && c.has_light_planes();
  const bool alike = c.normalizer_l == c.normalizer_n && (!c.has_specular() || c.normalizer_h == c.normalizer_n);
  if (c.normalizes_after()) {
    const auto reject = [](const std::string& reason) {
      return IllegalParameter{"normalize_order", "normalize_order = after is not legal: " + reason};
    };
    if (!c.has_normal() || !c.has_light_planes()) return reject("N, L and H must be interpolated or from a texture");
    if (!alike || c.normalizer_n != static_cast<int>(Normalizer::kFaithful))
      return reject("the reciprocal lengths are those of normalizer_n, _l, _h = faithful");
    if (c.has_view_vector()) return reject("lighting = reflection and pixel_halfangle need unit vectors");
    if (c.self_shadow != static_cast<int>(SelfShadow::kOff)) return reject("self_shadow needs the unit vector L");
  }
  if (c.sharing != 0) {
    const auto reject = [](const std::string& reason) {
      return IllegalParameter{"sharing", "sharing = on is not legal: " + reason};
    };
    if (!three_vectors) return reject("N, L and H must be three interpolated or texture vectors of one width");
    if (!alike || c.normalizer_n == static_cast<int>(Normalizer::kNone))
      return reject("normalizer_n, _l and _h must be one kind, and not none");
    if (!c.is(Lighting::kHalfangle)) return reject("it takes turns between N.L and N.H: lighting = halfangle");
    if (c.normalizes_after()) return reject("normalize_order = after has units of its own");
  }
  return {};
}

IllegalParameter check(const Config& config) {
  for (const Parameter& parameter : parameters())
    if (auto fault = check_range(config, parameter); !fault.key.empty()) return fault;
  if (config.dot_bits > 2 * config.unit_bits)
    return illegal("dot_bits", config.dot_bits, "at most " + std::to_string(2 * config.unit_bits),
                   "a product of unit vectors has no more than 2 unit_bits fraction bits");
  if (config.power_bits < config.dot_bits)
    return illegal("power_bits", config.power_bits, "at least " + std::to_string(config.dot_bits),
                   "N.H is widened from dot_bits to power_bits before it is squared");
  if (config.perspective != 0 && config.reciprocal_bits < config.q_bits - 1)
    return illegal("reciprocal_bits", config.reciprocal_bits, "at least " + std::to_string(config.q_bits - 1),
                   "u q times 1/q is scaled by a right shift only, of reciprocal_bits less the leading zeros of q");
  if (config.is(Datapath::kRotated) && !config.has_light_planes())
    return {"light_vectors",
            "light_vectors = constant is not legal: L and H turn with the frame of datapath = rotated"};
  if (auto fault = check_normalizers(config); !fault.key.empty()) return fault;
  return check_order_and_sharing(config);
}

int widest_operand_bits(const Config& config) {
  return std::max({interpolate_bits(config), perspective_bits(config), texture_bits(config), perturb_bits(config),
                   normalize_bits(config), light_bits(config), output_bits(config)});
}

int lane_bits(const Config& config) {
  // Factors that the pixel stages multiply as halves of a lane: m, r, and intensities up to 1.
  int magnitude = widest_unit_input_bits(config) + 1, root = rsqrt_geometry(config.unit_bits).output_bits + 1;
  if (has_compact_unit(config)) {
    magnitude = std::max(magnitude, config.unit_bits + 1);
    root = std::max(root, compact_rsqrt_geometry(config.unit_bits).output_bits + 1);
  }
  const int intensity = config.power_bits + 1, colour = config.colour_bits + 1;
  const int deferred = config.normalizes_after() ? config.dot_bits + 2 : 0;
  const bool halves_fit = std::max({magnitude, root, intensity, colour, deferred}) <= 15;
  return widest_operand_bits(config) <= 32 && halves_fit ? 32 : 64;
}

}  // namespace wrinkle

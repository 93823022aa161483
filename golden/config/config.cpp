#include "golden/config/config.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include "golden/datapath/datapaths.h"

namespace wrinkle {
namespace {

#define WRINKLE_DATAPATH(name, Type) "|" #name
constexpr std::string_view kListedDatapaths =
#include "golden/datapath/list.def"
    ;
#undef WRINKLE_DATAPATH
constexpr std::string_view kDatapathNames = kListedDatapaths.substr(1);

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t bar = text.find('|'); bar != text.npos; bar = text.find('|')) {
    words.push_back(text.substr(0, bar));
    text.remove_prefix(bar + 1);
  }
  words.push_back(text);
  return words;
}

Parameter choice(Scope scope, std::string_view name, int Config::*member, int standard, std::string_view values,
                 std::string_view description) {
  auto names = split(values);
  const int maximum = static_cast<int>(names.size()) - 1;
  return {scope, name, member, standard, 0, maximum, std::move(names), description};
}

const Parameter& parameter_named(std::string_view name) {
  for (const Parameter& parameter : parameters())
    if (parameter.name == name) return parameter;
  throw std::logic_error("no parameter is named " + std::string(name));
}

// A value as a user writes it.
std::string written(const Parameter& parameter, int value) {
  const bool has_name = value >= 0 && static_cast<std::size_t>(value) < parameter.values.size();
  return has_name ? std::string(parameter.values[static_cast<std::size_t>(value)]) : std::to_string(value);
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

// The names of the rules' conditions are members.
struct RuleBook : Shape {
  // The position in rules() of the first rule that is broken.
  std::optional<std::size_t> broken() const {
    std::size_t index = 0;
#define WRINKLE_RULE(name, key, condition, message) \
  if (condition) return index;                      \
  ++index;
#include "golden/config/rules.def"
#undef WRINKLE_RULE
    return std::nullopt;
  }
};

// A rule's message with the value of every width that it names behind the name, so that both that collide are shown.
std::string with_values(const Config& config, std::string_view message) {
  const auto is_part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  std::string shown;
  for (std::size_t at = 0; at < message.size();) {
    std::size_t end = at;
    while (end < message.size() && is_part(message[end])) ++end;
    const std::string_view word = message.substr(at, std::max(end - at, std::size_t{1}));
    shown += word;
    for (const Parameter& parameter : parameters())
      if (parameter.name == word && parameter.values.empty())
        shown += " (" + std::to_string(config.*parameter.member) + ")";
    at += word.size();
  }
  return shown;
}

}  // namespace

DatapathProperties datapath_properties(const Config& config) {
  return with_datapath(config, [](const auto& datapath) {
    return DatapathProperties{
#define WRINKLE_PROPERTY(scope, name, standard, description) datapath.name().value,
#include "golden/datapath/properties.def"
#undef WRINKLE_PROPERTY
    };
  });
}

std::span<const Parameter> parameters() {
  static const std::vector<Parameter> list = {
#define WRINKLE_CHOICE(scope, name, standard, values, description) \
  choice(Scope::scope, #name, &Config::name, standard, values, description),
#define WRINKLE_WIDTH(scope, name, standard, minimum, maximum, description) \
  {Scope::scope, #name, &Config::name, standard, minimum, maximum, {}, description},
#include "golden/config/parameters.def"
#undef WRINKLE_CHOICE
#undef WRINKLE_WIDTH
  };
  return list;
}

std::span<const DerivedValue> properties() {
  static const std::vector<DerivedValue> list = {
#define WRINKLE_PROPERTY(scope, name, standard, description) \
  {Scope::scope, #name, &Shape::name, #standard, description},
#include "golden/datapath/properties.def"
#undef WRINKLE_PROPERTY
  };
  return list;
}

std::span<const DerivedValue> derived_values() {
  static const std::vector<DerivedValue> list = {
#define WRINKLE_DERIVED(scope, name, expression, description) \
  {Scope::scope, #name, &Shape::name, #expression, description},
#include "golden/config/derived.def"
#undef WRINKLE_DERIVED
  };
  return list;
}

std::span<const Rule> rules() {
  static const std::vector<Rule> list = {
#define WRINKLE_RULE(name, key, condition, message) {#name, #key, #condition, message},
#include "golden/config/rules.def"
#undef WRINKLE_RULE
  };
  return list;
}

IllegalParameter check(const Config& config) {
  for (const Parameter& parameter : parameters())
    if (auto fault = check_range(config, parameter); !fault.key.empty()) return fault;
  const std::optional<std::size_t> broken = RuleBook{config}.broken();
  if (!broken) return {};
  const Rule& rule = rules()[*broken];
  const Parameter& parameter = parameter_named(rule.key);
  return {std::string(rule.key), std::string(rule.key) + " = " + written(parameter, config.*parameter.member) +
                                     " is not legal: " + with_values(config, rule.message)};
}

bool Config::has_blinn() const { return Shape(*this).frame_unbounded != 0; }
bool Config::has_texture_normal() const { return Shape(*this).surface_is_z != 0; }
bool Config::has_bump() const { return Shape(*this).bump_components != 0; }
bool Config::has_normal_planes() const { return Shape(*this).frame_vectors == 1; }
bool Config::has_normal() const { return Shape(*this).normal_width != 0; }
bool Config::has_cross_planes() const { return Shape(*this).frame_vectors == 3 && Shape(*this).frame_held == 0; }
int Config::wide_width() const { return wide_bits + 2; }
int Config::normal_vector_bits() const { return Shape(*this).normal_bits; }
int Config::normal_vector_width() const { return Shape(*this).normal_width; }
int Config::normal_unit_input_bits() const { return Shape(*this).normal_input_bits; }
int Config::mantissa_bits(int input_bits) const { return input_bits < unit_bits ? input_bits + 1 : unit_bits; }
bool Config::has_light_planes() const { return Shape(*this).has_light_planes != 0; }
bool Config::has_specular() const { return Shape(*this).glossy != 0; }
bool Config::has_view_vector() const { return Shape(*this).has_view_vector != 0; }
bool Config::has_texture() const { return Shape(*this).textured != 0; }
bool Config::trilinear() const { return Shape(*this).trilinear != 0; }
bool Config::normalizes_after() const { return Shape(*this).normalizes_after != 0; }
int Config::third_normalizer() const { return Shape(*this).third_normalizer; }
int Config::normalized_width() const { return Shape(*this).normalized_width; }
int Config::scale_bits() const { return Shape(*this).scale_bits; }
int Config::channel_count() const { return Shape(*this).count; }
int Config::vector_width() const { return Shape(*this).vector_width; }
int Config::uv_width() const { return Shape(*this).uv_width; }
int Config::lod_fraction_bits() const { return Shape(*this).lod_fraction_bits; }
int Config::weight_fraction_bits() const { return Shape(*this).weight_fraction_bits; }
int Config::filter_fraction_bits() const { return Shape(*this).filter_fraction_bits; }
int Config::coordinate_shift() const { return Shape(*this).coordinate_shift; }
int Config::texel_components() const { return Shape(*this).texels; }
int Config::draw_words() const { return Shape(*this).draw_words; }
int Config::edge_bits() const { return Shape(*this).edge_bits; }

}  // namespace wrinkle

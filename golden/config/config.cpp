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

}  // namespace wrinkle

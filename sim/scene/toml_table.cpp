#include "sim/scene/toml_table.h"

#include <algorithm>
#include <cctype>
#include <cfloat>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "sim/scene/files.h"
#include "sim/scene/suggest.h"

namespace wrinkle {
namespace {

std::string number_text(double value) {
  std::ostringstream text;
  text.precision(9);
  text << value;
  return text.str();
}

std::string range_text(double minimum, double maximum) {
  return "between " + number_text(minimum) + " and " + number_text(maximum);
}

// Bare words behind "=" are the usual fault of syntax.
std::string advice(const std::string& text, unsigned line) {
  std::istringstream lines(text);
  std::string found;
  for (unsigned i = 0; i < line; ++i) std::getline(lines, found);
  const std::size_t equals = found.find('=');
  const std::size_t word = equals == std::string::npos ? equals : found.find_first_not_of(" \t", equals + 1);
  if (word == std::string::npos || std::isalpha(static_cast<unsigned char>(found[word])) == 0) return "";
  const std::size_t end = found.find_first_of(" \t\r#,]}", word);
  const std::string value = found.substr(word, end == std::string::npos ? end : end - word);
  if (value == "true" || value == "false" || value == "inf" || value == "nan") return "";
  return "; text is written in quotes: " + shortened(found.substr(0, equals)) + "= \"" + shortened(value) + "\"";
}

}  // namespace

toml::table parse_toml_file(const std::string& path) {
  const std::string text = read_text_file(path, std::uintmax_t{1} << 24);
  try {
    return toml::parse(text, path);
  } catch (const toml::parse_error& error) {
    throw InputError(Place{path, error.source().begin.line, error.source().begin.column, {}},
                     shortened(std::string(error.description())) + advice(text, error.source().begin.line));
  }
}

Place place_of(const std::string& file, const toml::node& node) {
  return {file, node.source().begin.line, node.source().begin.column, {}};
}

std::string describe(const toml::node& node) {
  if (const auto* text = node.as_string()) return "the string \"" + text->get().substr(0, 60) + "\"";
  if (const auto* integer = node.as_integer()) return "the integer " + std::to_string(integer->get());
  if (const auto* number = node.as_floating_point()) return "the number " + number_text(number->get());
  if (const auto* boolean = node.as_boolean()) return boolean->get() ? "true" : "false";
  if (node.is_array()) return "an array";
  if (node.is_table()) return "a table";
  return "a date or time";
}

double checked_number(double value, double minimum, double maximum, const std::string& what, const Place& place) {
  if (std::isnan(value)) throw InputError(place, what + " = NaN", "a finite number");
  if (std::isinf(value)) throw InputError(place, what + " = infinity", "a finite number");
  if (value != 0 && std::abs(value) < static_cast<double>(FLT_MIN)) {
    throw InputError(place, what + " = " + number_text(value) + ", denormal in single precision",
                     "0 or at least 1.17549e-38 in magnitude");
  }
  if (value < minimum || value > maximum) {
    throw InputError(place, what + " = " + number_text(value), "a number " + range_text(minimum, maximum));
  }
  return value + 0.0;  // -0 becomes 0
}

TomlTable::TomlTable(std::string file, const toml::table& table, std::string name, std::vector<std::string_view> keys)
    : file_(std::move(file)), table_(table), name_(std::move(name)), keys_(std::move(keys)) {
  for (const auto& [key, node] : table_) {
    if (std::find(keys_.begin(), keys_.end(), key.str()) != keys_.end()) continue;
    const Place at{file_, key.source().begin.line, key.source().begin.column, {}};
    std::string known = did_you_mean(key.str(), keys_);
    if (known.empty()) known = "; it may have " + list_of(keys_);
    throw InputError(at, "unknown key \"" + std::string(key.str()) + "\" in " + name_ + known);
  }
}

const toml::node* TomlTable::find(std::string_view key) const {
  if (std::find(keys_.begin(), keys_.end(), key) == keys_.end()) {
    throw std::logic_error("the key " + std::string(key) + " is not in the list of " + name_);
  }
  return table_.get(key);
}

Place TomlTable::place(std::string_view key) const {
  const toml::node* node = find(key);
  return node != nullptr ? place_of(file_, *node) : place();
}

void TomlTable::missing(std::string_view key, const std::string& expected) const {
  throw InputError(place(), name_ + " without \"" + std::string(key) + "\"", expected);
}

std::int64_t TomlTable::integer(std::string_view key, std::int64_t minimum, std::int64_t maximum,
                                std::optional<std::int64_t> standard) const {
  const std::string expected = "an integer from " + std::to_string(minimum) + " to " + std::to_string(maximum);
  const toml::node* node = find(key);
  if (node == nullptr) {
    if (!standard) missing(key, expected);
    return *standard;
  }
  const auto* value = node->as_integer();
  if (value == nullptr || value->get() < minimum || value->get() > maximum) {
    throw InputError(place(key), std::string(key) + " = " + describe(*node), expected);
  }
  return value->get();
}

double TomlTable::number(std::string_view key, double minimum, double maximum, std::optional<double> standard) const {
  const toml::node* node = find(key);
  if (node == nullptr) {
    if (!standard) missing(key, "a number " + range_text(minimum, maximum));
    return *standard;
  }
  const std::optional<double> value = node->is_number() ? node->value<double>() : std::nullopt;
  if (!value) {
    throw InputError(place(key), std::string(key) + " = " + describe(*node),
                     "a number " + range_text(minimum, maximum));
  }
  return checked_number(*value, minimum, maximum, std::string(key), place(key));
}

bool TomlTable::boolean(std::string_view key, bool standard) const {
  const toml::node* node = find(key);
  if (node == nullptr) return standard;
  if (!node->is_boolean()) {
    throw InputError(place(key), std::string(key) + " = " + describe(*node), "true or false");
  }
  return node->as_boolean()->get();
}

std::string TomlTable::string(std::string_view key, std::optional<std::string> standard) const {
  const toml::node* node = find(key);
  if (node == nullptr) {
    if (!standard) missing(key, "a string");
    return *standard;
  }
  if (!node->is_string()) throw InputError(place(key), std::string(key) + " = " + describe(*node), "a string");
  const std::string text = node->as_string()->get();
  if (text.find('\0') != std::string::npos) {
    throw InputError(place(key), std::string(key) + " with a zero byte", "a string without one");
  }
  return text;
}

int TomlTable::choice(std::string_view key, std::span<const std::string_view> choices,
                      std::optional<int> standard) const {
  const toml::node* node = find(key);
  if (node == nullptr) {
    if (!standard) missing(key, list_of(choices));
    return *standard;
  }
  const auto* text = node->as_string();
  const auto found = text == nullptr ? choices.end() : std::find(choices.begin(), choices.end(), text->get());
  if (found == choices.end()) {
    throw InputError(place(key), std::string(key) + " = " + describe(*node),
                     list_of(choices) + (text == nullptr ? "" : did_you_mean(text->get(), choices)));
  }
  return static_cast<int>(found - choices.begin());
}

const toml::array& TomlTable::array(std::string_view key, std::size_t count, const std::string& expected) const {
  const toml::node* node = find(key);
  if (node == nullptr) missing(key, expected);
  const toml::array* array = node->as_array();
  if (array == nullptr) throw InputError(place(key), std::string(key) + " = " + describe(*node), expected);
  if (array->size() != count) {
    throw InputError(place(key), std::string(key) + " of " + std::to_string(array->size()) + " elements", expected);
  }
  return *array;
}

std::vector<int> TomlTable::choices(std::string_view key, std::size_t count,
                                    std::initializer_list<std::string_view> choices) const {
  std::vector<int> indices;
  for (const toml::node& element : array(key, count, "an array of " + std::to_string(count) + " choices")) {
    const auto* text = element.as_string();
    const auto found = text == nullptr ? choices.end() : std::find(choices.begin(), choices.end(), text->get());
    if (found == choices.end()) {
      throw InputError(place_of(file_, element), describe(element), list_of({choices.begin(), choices.size()}));
    }
    indices.push_back(static_cast<int>(found - choices.begin()));
  }
  return indices;
}

std::vector<std::int64_t> TomlTable::integers(std::string_view key, std::size_t count, std::int64_t minimum,
                                              std::int64_t maximum,
                                              std::optional<std::vector<std::int64_t>> standard) const {
  if (!has(key) && standard) return *standard;
  const std::string range = std::to_string(minimum) + " to " + std::to_string(maximum);
  std::vector<std::int64_t> values;
  for (const toml::node& element :
       array(key, count, "an array of " + std::to_string(count) + " integers from " + range)) {
    const auto* value = element.as_integer();
    if (value == nullptr || value->get() < minimum || value->get() > maximum) {
      throw InputError(place_of(file_, element), describe(element) + " in " + std::string(key),
                       "an integer from " + range);
    }
    values.push_back(value->get());
  }
  return values;
}

std::vector<double> TomlTable::numbers(std::string_view key, std::size_t count, double minimum, double maximum,
                                       std::optional<std::vector<double>> standard) const {
  if (!has(key) && standard) return *standard;
  std::vector<double> values;
  for (const toml::node& element : array(key, count, "an array of " + std::to_string(count) + " numbers")) {
    if (!element.is_number()) {
      throw InputError(place_of(file_, element), describe(element) + " in " + std::string(key), "a number");
    }
    values.push_back(checked_number(*element.value<double>(), minimum, maximum,
                                    std::string(key) + "[" + std::to_string(values.size()) + "]",
                                    place_of(file_, element)));
  }
  return values;
}

Vec3 TomlTable::vector(std::string_view key, double minimum, double maximum, std::optional<Vec3> standard) const {
  std::optional<std::vector<double>> fallback;
  if (standard) fallback = {standard->x, standard->y, standard->z};
  const std::vector<double> v = numbers(key, 3, minimum, maximum, fallback);
  return {v[0], v[1], v[2]};
}

const toml::table* TomlTable::table(std::string_view key) const {
  const toml::node* node = find(key);
  if (node == nullptr) return nullptr;
  if (!node->is_table()) throw InputError(place(key), std::string(key) + " = " + describe(*node), "a table");
  return node->as_table();
}

std::vector<const toml::table*> TomlTable::tables(std::string_view key, std::size_t maximum) const {
  const std::string expected = "[[" + std::string(key) + "]], 1 to " + std::to_string(maximum) + " tables";
  const toml::node* node = find(key);
  if (node == nullptr) missing(key, expected);
  const toml::array* array = node->as_array();
  if (array == nullptr) throw InputError(place(key), std::string(key) + " = " + describe(*node), expected);
  if (array->empty() || array->size() > maximum) {
    throw InputError(place(key), std::string(key) + " of " + std::to_string(array->size()) + " elements", expected);
  }
  std::vector<const toml::table*> tables;
  for (const toml::node& element : *array) {
    if (!element.is_table()) throw InputError(place_of(file_, element), describe(element), "a table");
    tables.push_back(element.as_table());
  }
  return tables;
}

bool TomlTable::is_string(std::string_view key) const {
  const toml::node* node = find(key);
  return node != nullptr && node->is_string();
}

bool TomlTable::is_array(std::string_view key) const {
  const toml::node* node = find(key);
  return node != nullptr && node->is_array();
}

}  // namespace wrinkle

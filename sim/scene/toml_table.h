// Strict reading of TOML: every key known, every value of its type and in its range, every error with line and column.
#pragma once

#include <toml++/toml.h>

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "golden/vector.h"
#include "sim/input_error.h"

namespace wrinkle {

// Parses a file; a fault of syntax is an InputError at its line and column.
toml::table parse_toml_file(const std::string& path);

Place place_of(const std::string& file, const toml::node& node);

// A number of a scene: finite, neither denormal in single precision nor outside [minimum, maximum]; -0 becomes 0.
double checked_number(double value, double minimum, double maximum, const std::string& what, const Place& place);

// One table and the keys it may have. Asking for a key that is not among them is a fault of the program
// (std::logic_error).
class TomlTable {
 public:
  TomlTable(std::string file, const toml::table& table, std::string name, std::vector<std::string_view> keys);

  bool has(std::string_view key) const { return find(key) != nullptr; }
  // Of the key where it is there, else of the table.
  Place place(std::string_view key) const;
  Place place() const { return place_of(file_, table_); }
  const std::string& file() const { return file_; }

  // Each of these: the default where the key is absent, an error where there is none to fall back on.
  std::int64_t integer(std::string_view key, std::int64_t minimum, std::int64_t maximum,
                       std::optional<std::int64_t> standard = {}) const;
  double number(std::string_view key, double minimum, double maximum, std::optional<double> standard = {}) const;
  bool boolean(std::string_view key, bool standard) const;
  std::string string(std::string_view key, std::optional<std::string> standard = {}) const;
  // Index of the value in `choices`.
  int choice(std::string_view key, std::span<const std::string_view> choices, std::optional<int> standard = {}) const;
  int choice(std::string_view key, std::initializer_list<std::string_view> choices,
             std::optional<int> standard = {}) const {
    return choice(key, std::span<const std::string_view>(choices.begin(), choices.size()), standard);
  }
  std::vector<int> choices(std::string_view key, std::size_t count,
                           std::initializer_list<std::string_view> choices) const;
  // An array of `count` integers.
  std::vector<std::int64_t> integers(std::string_view key, std::size_t count, std::int64_t minimum,
                                     std::int64_t maximum,
                                     std::optional<std::vector<std::int64_t>> standard = {}) const;
  // An array of `count` numbers.
  std::vector<double> numbers(std::string_view key, std::size_t count, double minimum, double maximum,
                              std::optional<std::vector<double>> standard = {}) const;
  Vec3 vector(std::string_view key, double minimum, double maximum, std::optional<Vec3> standard = {}) const;
  // A table within, or nothing.
  const toml::table* table(std::string_view key) const;
  // An array of at least one table.
  std::vector<const toml::table*> tables(std::string_view key, std::size_t maximum) const;
  bool is_string(std::string_view key) const;
  bool is_array(std::string_view key) const;

 private:
  const toml::node* find(std::string_view key) const;
  const toml::array& array(std::string_view key, std::size_t count, const std::string& expected) const;
  [[noreturn]] void missing(std::string_view key, const std::string& expected) const;

  std::string file_;
  const toml::table& table_;
  std::string name_;
  std::vector<std::string_view> keys_;
};

// What a node is, for messages: "the string \"8\"", "an array".
std::string describe(const toml::node& node);

}  // namespace wrinkle

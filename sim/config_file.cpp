#include "sim/config_file.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "sim/scene/files.h"
#include "sim/scene/suggest.h"
#include "sim/scene/toml_table.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

constexpr int kMaximumBases = 8;  // of one file on another

std::vector<std::string_view> parameter_names() {
  std::vector<std::string_view> names;
  for (const Parameter& parameter : parameters()) names.push_back(parameter.name);
  return names;
}

// The keys a chain of files sets, with the file and line of the last setting of each.
struct Loaded {
  Config config;
  std::vector<std::pair<std::string, Place>> places;

  Place place(const std::string& key, const std::string& file) const {
    const auto found =
        std::find_if(places.begin(), places.end(), [&](const auto& entry) { return entry.first == key; });
    return found != places.end() ? found->second : Place{file, 0, 0, {}};
  }
};

fs::path file_of(const std::string& name, const fs::path& folder, const Place& place) {
  if (name.find('/') != std::string::npos || extension_of(name) == ".toml") return find_file(folder, name, place);
  const std::vector<std::string> names = named_configs();
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    const std::vector<std::string_view> views(names.begin(), names.end());
    throw InputError(place, "the configuration \"" + name + "\"",
                     list_of(views) + ", or a file ending in .toml" + did_you_mean(name, views));
  }
  return fs::path(WRINKLE_CONFIG_DIR) / (name + ".toml");
}

int read_value(const TomlTable& table, const Parameter& parameter) {
  if (parameter.values.empty()) {
    return static_cast<int>(table.integer(parameter.name, parameter.minimum, parameter.maximum));
  }
  return table.choice(parameter.name, parameter.values);
}

Loaded load_file(const fs::path& path, int depth) {
  const std::string file = path.string();
  const toml::table parsed = parse_toml_file(file);
  std::vector<std::string_view> keys = parameter_names();
  keys.push_back("base");
  const TomlTable table(file, parsed, "the configuration", keys);

  Loaded loaded;
  if (table.has("base")) {
    if (depth == kMaximumBases) {
      throw InputError(table.place("base"), "more than " + std::to_string(kMaximumBases) + " files based on each other",
                       "a chain of bases that ends");
    }
    loaded = load_file(file_of(table.string("base"), path.parent_path(), table.place("base")), depth + 1);
  }
  for (const Parameter& parameter : parameters()) {
    if (!table.has(parameter.name)) continue;
    loaded.config.*parameter.member = read_value(table, parameter);
    std::erase_if(loaded.places, [&](const auto& entry) { return entry.first == parameter.name; });
    loaded.places.emplace_back(parameter.name, table.place(parameter.name));
  }
  return loaded;
}

std::string legal_values(const Parameter& parameter) {
  if (!parameter.values.empty()) return list_of(parameter.values);
  return "an integer from " + std::to_string(parameter.minimum) + " to " + std::to_string(parameter.maximum);
}

std::optional<int> parse_value(const Parameter& parameter, std::string_view text) {
  if (!parameter.values.empty()) {
    const auto found = std::find(parameter.values.begin(), parameter.values.end(), text);
    if (found == parameter.values.end()) return std::nullopt;
    return static_cast<int>(found - parameter.values.begin());
  }
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  if (!whole || value < parameter.minimum || value > parameter.maximum) return std::nullopt;
  return value;
}

void apply_override(Config& config, const std::string& assignment) {
  const Place place{"--set " + assignment, 0, 0, {}};
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos) throw InputError(place, "no \"=\"", "key=value");
  const std::string key = assignment.substr(0, equals);
  const std::string text = assignment.substr(equals + 1);
  const auto all = parameters();
  const auto parameter = std::find_if(all.begin(), all.end(), [&](const Parameter& p) { return p.name == key; });
  if (parameter == all.end()) {
    throw InputError(place, "unknown key \"" + key + "\"" + did_you_mean(key, parameter_names()));
  }
  const std::optional<int> value = parse_value(*parameter, text);
  if (!value) {
    throw InputError(place, key + " = \"" + text + "\"",
                     legal_values(*parameter) + did_you_mean(text, parameter->values));
  }
  config.*(parameter->member) = *value;
}

}  // namespace

std::vector<std::string> named_configs() {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(WRINKLE_CONFIG_DIR)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Config load_config(const std::string& name_or_path, const fs::path& folder) {
  const Place place{name_or_path, 0, 0, {}};
  const fs::path path = file_of(name_or_path, folder, place);
  const Loaded loaded = load_file(path, 0);
  const IllegalParameter illegal = check(loaded.config);
  if (!illegal.key.empty()) {
    throw InputError(loaded.place(illegal.key, path.string()), illegal.message);
  }
  return loaded.config;
}

Config apply_overrides(Config config, std::span<const std::string> assignments) {
  for (const std::string& assignment : assignments) apply_override(config, assignment);
  const IllegalParameter illegal = check(config);
  if (illegal.key.empty()) return config;
  const auto culprit = std::find_if(assignments.begin(), assignments.end(),
                                    [&](const std::string& text) { return text.starts_with(illegal.key + "="); });
  const std::string file = culprit != assignments.end() ? "--set " + *culprit : "--set";
  throw InputError(Place{file, 0, 0, {}}, illegal.message);
}

std::string write_config(const Config& config) {
  std::string text;
  for (const Parameter& parameter : parameters()) {
    const int value = config.*parameter.member;
    text += "# " + std::string(parameter.description) + "; " + legal_values(parameter) + "\n";
    text += std::string(parameter.name) + " = ";
    text += parameter.values.empty() ? std::to_string(value)
                                     : "\"" + std::string(parameter.values[static_cast<std::size_t>(value)]) + "\"";
    text += "\n";
  }
  return text;
}

}  // namespace wrinkle

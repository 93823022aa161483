#include "sim/digest/table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>

#include "golden/stages.h"
#include "sim/input_error.h"

namespace wrinkle {
namespace {

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

// What every line consists of: name, scene, measured cells, settings.
std::vector<std::string> columns() {
  std::vector<std::string> names{"config", "scene"};
  for (std::string& name : measured_columns()) names.push_back(std::move(name));
  names.push_back("settings");
  return names;
}

void set(Config& config, const std::string& assignment, const Place& place) {
  const std::size_t equals = assignment.find('=');
  const std::string key = assignment.substr(0, equals);
  const auto all = parameters();
  const auto parameter = std::find_if(all.begin(), all.end(), [&](const Parameter& p) { return p.name == key; });
  if (equals == std::string::npos || parameter == all.end())
    throw InputError(place, "\"" + assignment + "\"", "KEY=VALUE with a parameter of golden/config/parameters.def");
  int& value = config.*(parameter->member);
  const char* const last = assignment.data() + assignment.size();
  const auto [end, error] = std::from_chars(assignment.data() + equals + 1, last, value);
  if (error != std::errc() || end != last) throw InputError(place, "\"" + assignment + "\"", "an integer after the =");
}

}  // namespace

std::string settings_of(const Config& config) {
  std::vector<std::string> settings;
  for (const Parameter& parameter : parameters()) {
    const int value = config.*parameter.member;
    if (value != parameter.standard) settings.push_back(fmt::format("{}={}", parameter.name, value));
  }
  return settings.empty() ? "-" : fmt::format("{}", fmt::join(settings, ","));
}

Config config_of(const std::string& settings, const std::string& file, unsigned line) {
  const Place place{file, line, 0, {}};
  Config config;
  std::istringstream in(settings == "-" ? "" : settings);
  for (std::string assignment; std::getline(in, assignment, ',');) set(config, assignment, place);
  const IllegalParameter illegal = check(config);
  if (!illegal.key.empty()) throw InputError(place, illegal.message);
  return config;
}

std::vector<std::string> measured_columns() {
  std::vector<std::string> names{"fragments", "clocks", "rtl", "fragment"};
  names.insert(names.end(), std::begin(kStageNames) + static_cast<int>(Stage::scan), std::end(kStageNames));
  return names;
}

std::string heading() {
  return "# What golden computes and how many clocks the RTL takes, a line a frame: made by ./wrinkle verify "
         "--digest;\n"
         "# the columns are explained in docs/commands.md, under \"verify\".\n" +
         fmt::format("{}\n", fmt::join(columns(), " "));
}

std::string text_of(const DigestLine& line) {
  return fmt::format("{} {} {} {}\n", line.frame.config_name, line.frame.scene, fmt::join(line.cells, " "),
                     line.frame.settings);
}

DigestLine parse_line(const std::string& text, const std::string& file, unsigned number) {
  std::vector<std::string> words = words_of(text);
  const std::size_t wanted = columns().size();
  if (words.size() != wanted)
    throw InputError(Place{file, number, 0, {}}, fmt::format("{} columns", words.size()), fmt::format("{}", wanted));
  DigestLine line;
  line.frame = {words.front(), words.back(), words[1]};
  line.cells.assign(words.begin() + 2, words.end() - 1);
  line.number = number;
  return line;
}

std::vector<DigestLine> read_digest(const std::filesystem::path& path) {
  std::ifstream in(path);
  if (!in) throw InputError(Place{path.string()}, "the digest cannot be read");
  std::vector<DigestLine> lines;
  unsigned number = 0;
  bool headed = false;
  for (std::string text; std::getline(in, text);) {
    ++number;
    if (text.empty() || text.front() == '#') continue;
    if (headed) {
      lines.push_back(parse_line(text, path.string(), number));
    } else if (words_of(text) == columns()) {
      headed = true;
    } else {
      throw InputError(Place{path.string(), number, 0, {}}, "\"" + text + "\"",
                       fmt::format("the columns \"{}\"", fmt::join(columns(), " ")));
    }
  }
  return lines;
}

std::string text_of(std::span<const DigestLine> lines) {
  std::string text = heading();
  for (const DigestLine& line : lines) text += text_of(line);
  return text;
}

std::string hash_text(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

}  // namespace wrinkle

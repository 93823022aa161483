// The file of `verify --digest`: a line a frame, whose cells say what golden computes and how long the RTL takes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "golden/config/config.h"

namespace wrinkle {

// What is drawn. The configuration is its settings; its name is only for people.
struct DigestFrame {
  std::string config_name;
  std::string settings;  // as settings_of() writes them
  std::string scene;     // a name of sim/scenes, or "random:SEED"
  bool operator==(const DigestFrame&) const = default;
};

// The parameters that differ from the default, KEY=VALUE with commas between them, or "-" where none does. A choice is
// the position of its value in parameters.def, so that giving a value another name changes no line.
std::string settings_of(const Config& config);
// Throws InputError, with `place` for the file and line, where a key or value is not legal.
Config config_of(const std::string& settings, const std::string& file, unsigned line);

// What is measured of a frame, in this order: fragments, clocks, rtl, fragment, and each stage.
std::vector<std::string> measured_columns();

struct DigestLine {
  DigestFrame frame;
  std::vector<std::string> cells;  // as measured_columns(); "-" where there is nothing
  unsigned number = 0;             // in the file it was read from
};

std::string heading();
std::string text_of(const DigestLine& line);
DigestLine parse_line(const std::string& text, const std::string& file, unsigned number);
// Throws InputError where the file is not there or its columns are not those of this program.
std::vector<DigestLine> read_digest(const std::filesystem::path& path);
std::string text_of(std::span<const DigestLine> lines);

// XXH3, 64 bits, as 16 digits.
std::string hash_text(std::uint64_t hash);

}  // namespace wrinkle

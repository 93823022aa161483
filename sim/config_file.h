// Configuration files: TOML, keys and values exactly as in golden/config/parameters.def. docs/formats.md,
// "Configuration file".
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "golden/config/config.h"

namespace wrinkle {

// The names under sim/configs, sorted.
std::vector<std::string> named_configs();

// A named configuration, or a file: whatever has a slash or ends in .toml. Files are relative to `folder`. The result
// is legal; InputError says file, line, key, value, legal range and reason otherwise.
Config load_config(const std::string& name_or_path, const std::filesystem::path& folder = ".");

// `config` with assignments such as "unit_bits=12" or "filter=bilinear". All of them are made before the result is
// checked.
Config apply_overrides(Config config, std::span<const std::string> assignments);

// The file that load_config() reads `config` from: every key, with its legal range and meaning.
std::string write_config(const Config& config);

}  // namespace wrinkle

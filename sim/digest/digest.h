// verify --digest: what golden computes and how many clocks the RTL takes, as a file to compare with later.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "sim/digest/measure.h"

namespace wrinkle {

struct DigestOptions {
  std::filesystem::path file;                // to write
  std::filesystem::path against;             // to compare with; empty: nothing
  std::vector<std::string> scenes, configs;  // only these; empty: all
  Engines engines;
  int processes = 0;  // at once; 0: one a core
};

// True where the RTL is golden in every frame and nothing differs from the file to compare with. `object` is what
// docs/commands.md says of the JSON.
bool verify_digest(const DigestOptions& options, nlohmann::json& object);

}  // namespace wrinkle

// Verilated models, built when first asked for and kept.
#pragma once

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "golden/config/config.h"

namespace wrinkle {

// Which model of a configuration. Every member is part of the cache key.
struct ModelOptions {
  std::filesystem::path source_root;  // holds rtl/; empty: this project
  std::filesystem::path cache;        // empty: $WRINKLE_CACHE, else `models` in the build directory
  bool trace = false;                 // can write waveforms; slower
  bool optimize = true;               // off: half the build time, a fraction of the speed
};

// Called with what is being done, a few times in a build and never for a model that is there already.
using BuildProgress = std::function<void(const std::string& message)>;

// A tool failed; what() has its output.
struct ModelBuildError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Path of the shared library with the Verilated wrinkle_core for a configuration. Safe to call from several processes
// and to interrupt: a library appears under its name only when it is complete.
std::filesystem::path build_model(const Config& config, const ModelOptions& options = {},
                                  const BuildProgress& progress = {});

// The wires of wrinkle_core that a model shows: the handshakes of the stages, and those that values lie on.
std::vector<std::string> visible_wires(const Config& config);

}  // namespace wrinkle

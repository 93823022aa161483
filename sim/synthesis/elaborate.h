// Which files a module is made of.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/synthesis/synthesis.h"

namespace wrinkle {

// Those of `files` that hold `top` with these parameters or a module inside it, found by elaboration. What it found is
// kept in `cache` until a file changes.
std::vector<std::filesystem::path> elaborated_files(const std::string& top, const VerilogParameters& parameters,
                                                    const std::vector<std::filesystem::path>& files,
                                                    const std::vector<std::filesystem::path>& include_folders,
                                                    const std::filesystem::path& cache);

}  // namespace wrinkle

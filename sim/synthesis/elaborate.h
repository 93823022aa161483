// What a module is made of: its files and its registers.
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

// A register, or an element of a memory, by its path of instances from the top: `adder.sum_q`, `buffer.memory_q[3]`.
struct Register {
  std::string name;  // of its net in what Yosys makes
  std::string path;  // in the Verilog
  std::size_t bits = 0;
};

// All registers of `top`. `folder` is for what Yosys reads and writes.
std::vector<Register> elaborated_registers(const std::string& top, const VerilogParameters& parameters,
                                           const std::vector<std::filesystem::path>& files,
                                           const std::vector<std::filesystem::path>& include_folders,
                                           const std::filesystem::path& folder);

}  // namespace wrinkle

// One scene through every engine: golden and RTL compared bit for bit, errors of method and of precision, pictures.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/command.h"
#include "sim/framebuffer.h"
#include "sim/picture.h"

namespace wrinkle {

struct Comparison {
  std::string name, scene;
  std::string config;            // empty: what the scene names
  std::vector<std::string> set;  // KEY=VALUE on top of it
};

// What the RTL drew, from the very fragments that were compared with golden.
struct ComparedDrawing {
  Framebuffer framebuffer;
  BenchResult result;
};
ComparedDrawing draw_compared(const Config& config, const Frame& frame, const BenchOptions& options);

// The columns of print_comparison().
void print_comparison_heading();

// Draws the scene by RTL without stalls (for the clocks) and under those of `rtl`, by golden, exact and ideal; writes
// the pictures NAME.png, NAME_golden.png, ... into `folder`, prints a line, and appends RTL picture, method error and
// precision error to `sheet`. The object has `name`, `config`, `pixels`, `mismatches`, `cycles`, `pixels_per_clock`,
// `psnr_method_db`, `psnr_precision_db`, `image` and more.
nlohmann::json compare_engines(const Comparison& comparison, const RtlOptions& rtl, const std::filesystem::path& folder,
                               std::vector<Picture>& sheet);

// A difference picture shows differences this many times as large, about mid grey.
inline constexpr double kDifferenceGain = 8;

}  // namespace wrinkle

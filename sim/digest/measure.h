// A frame drawn by golden and by the RTL, as a line of a digest.
#pragma once

#include <filesystem>

#include "sim/digest/table.h"

namespace wrinkle {

// What stands in the column `rtl`.
inline constexpr const char* kRtlEqual = "equal";
inline constexpr const char* kRtlDifferent = "DIFFERENT";
// The frame cannot be drawn: set-up refuses it, as when the screen is too small, or its light not that of the draws.
inline constexpr const char* kLeftOut = "left_out";

struct MeasuredFrame {
  DigestLine line;
  std::string note;  // the first difference of the RTL, or why the frame is left out; else empty
};

// What a frame is drawn by.
struct Engines {
  bool golden_only = false;   // leaves the columns `clocks` and `rtl` empty
  std::filesystem::path rtl;  // folder with other Verilog; empty: this project's
};

// Without `optimize` the model of the RTL is sooner built and slower.
MeasuredFrame measure(const DigestFrame& frame, const Engines& engines, bool optimize);

// "random:SEED" is a frame of random triangles.
bool is_random(const DigestFrame& frame);

// A hash of all that a line depends on, this program and the Verilog among it: while it stays, so do the lines.
std::string source_key(const Engines& engines);

}  // namespace wrinkle

// Precision error by stage, and the error of the whole picture.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "golden/config/config.h"
#include "sim/picture.h"
#include "sim/report/replay.h"

namespace wrinkle {

// Root mean square and maximum over the fragments of a frame.
struct Spread {
  double rms = 0, max = 0;
};

// What one stage rounds, and what that does to the colour. A number that the stage does not have is 0.
struct PartError {
  std::string_view name;
  Spread ulp;             // of each value in its own format
  Spread degrees;         // between rounded and exact vector
  Spread length;          // of the rounded vector, less that of the exact one
  Spread grey;            // of the colour, in 1/255, when this stage alone rounds
  double alone_db = 0;    // PSNR against the exact colour when this stage alone rounds
  double without_db = 0;  // ... when all others round
};

struct PictureError {
  double psnr_db = 0, p999 = 0, max = 0, ssim = 1;  // of channels in [0, 1], over covered pixels
};

struct ErrorReport {
  std::string config, scene;
  std::uint64_t fragments = 0;
  std::vector<PartError> parts;
  PictureError precision;  // golden against exact
  PictureError method;     // exact against ideal
  // Largest difference between golden's colour and the replay with the rounding of every stage: 0 but for float64.
  double replay_deviation = 0;
};

ErrorReport measure_error(const std::string& config_name, const Config& config, const Frame& frame);

PictureError picture_error(const Picture& a, const Picture& b, const std::vector<std::uint8_t>& mask);

nlohmann::json to_json(const PictureError& error);
nlohmann::json to_json(const ErrorReport& report);

}  // namespace wrinkle

// All measurements of a report as one JSON object.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "sim/report/area.h"

namespace wrinkle {

struct ReportOptions {
  std::vector<std::string> configs;  // empty: all named ones
  std::vector<std::string> scenes{"patch_fig1", "patch_fig5", "patch_fig6", "patch_fig7", "teapot"};
  bool rtl = false, no_area = false, no_speed = false, no_paper = false;
};

// {figures, configs: [{name, choices: {datapath ...}, area, error}], pictures: [{name, config, png}], paper (what
// `figures` measures), speed, provenance}. Parts that were left out are absent.
nlohmann::json collect(const ReportOptions& options);

// Fig. 1, 2 and 3 from the named configurations `standard` and `blinn`.
Figures named_figures(const AreaOptions& options);

}  // namespace wrinkle

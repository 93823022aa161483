// All measurements of a report as one JSON object.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "sim/report/area.h"

namespace wrinkle {

struct ReportOptions {
  std::vector<std::string> configs, scenes;  // class Runs says what is measured where these are empty
  bool rtl = false, no_area = false, no_speed = false, no_paper = false;
};

// {figures, configs: [{name, choices: {datapath ...}, parameters, area}], runs: [{name, config, scene, error}],
// left_out:
// [{name, why}] of runs whose scene the configuration cannot draw, pictures: [{name, config, scene, png, columns}],
// paper (what `figures` measures), speed: {runs: [{name, config, scene, engines}], chips}, provenance}. Parts that were
// left out are absent.
nlohmann::json collect(const ReportOptions& options);

// Fig. 1, 2 and 3 from the named configurations `standard` and `blinn`.
Figures named_figures(const AreaOptions& options);

}  // namespace wrinkle

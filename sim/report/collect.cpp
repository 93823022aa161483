#include "sim/report/collect.h"

#include <OpenImageIO/strutil.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "golden/pixel/pixel.h"
#include "sim/command.h"
#include "sim/config_file.h"
#include "sim/datapaths.h"
#include "sim/engine.h"
#include "sim/report/error.h"
#include "sim/report/paper.h"
#include "sim/report/speed.h"
#include "tb/process.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// Every choice of a configuration by name: what the page filters by.
json choices(const Config& config) {
  json result;
  for (const Parameter& p : parameters()) {
    if (!p.values.empty()) result[std::string(p.name)] = p.values[std::size_t(config.*p.member)];
  }
  return result;
}

std::string data_uri(const Picture& picture) {
  return "data:image/png;base64," + OIIO::Strutil::base64_encode(encode_png(picture));
}

// "Fig. 6" for patch_fig6; other scenes by their names.
std::string picture_title(const std::string& scene) {
  static const std::string kFigure = "patch_fig";
  return scene.starts_with(kFigure) ? "Fig. " + scene.substr(kFigure.size()) : scene;
}

void add_picture(json& entries, const std::string& title, const std::string& engine, const std::string& config,
                 const Picture& picture) {
  entries.push_back({{"name", fmt::format("{}, {}", title, engine)}, {"config", config}, {"png", data_uri(picture)}});
}

json picture_entries(const ReportOptions& options) {
  json entries = json::array();
  std::vector<std::pair<Engine, const char*>> engines{
      {Engine::kGolden, "golden"}, {Engine::kExact, "exact"}, {Engine::kIdeal, "ideal"}};
  if (options.rtl) engines.insert(engines.begin(), {Engine::kRtl, "rtl"});
  for (const std::string& name : options.scenes) {
    const Scene scene = scene_named(name);
    const Config config = load_config(scene.config);
    const Frame frame = build_frame(config, scene);
    for (const auto& [engine, engine_name] : engines)
      add_picture(entries, picture_title(name), engine_name, scene.config, drawn(engine, config, frame).colour());
  }
  return entries;
}

// Figs. 5, 6 and 7 against each other. Their pictures are added to `pictures` unless they are there already. Difference
// pictures are not added, since the page makes the difference of any two.
json paper_entry(const ReportOptions& options, json& pictures) {
  PaperOptions paper;
  paper.engine = options.rtl ? Engine::kRtl : Engine::kGolden;
  const PaperFigures figures = draw_paper_figures(paper);
  const std::string engine = figures.results["engine"];
  const std::map<std::string, std::string> titles{{"fig5", "Fig. 5"},
                                                  {"fig6", "Fig. 6"},
                                                  {"fig7", "Fig. 7"},
                                                  {"held_4x4", "Fig. 2 held, 4 x 4"},
                                                  {"interpolated_4x4", "Fig. 2, 4 x 4"},
                                                  {"rotated", "Rotated frame"},
                                                  {"phong", "Phong"}};
  for (const NamedPicture& named : figures.pictures) {
    const auto title = titles.find(named.name);
    if (title == titles.end()) continue;
    const auto is_there = [&](const json& entry) {
      return entry["name"] == fmt::format("{}, {}", title->second, engine);
    };
    if (std::none_of(pictures.begin(), pictures.end(), is_there))
      add_picture(pictures, title->second, engine, "", named.picture);
  }
  return figures.results;
}

// The scene of `verify --all` that a configuration is for; the paper's patch for those that have none.
std::string scene_of(const std::string& config) {
  for (const DatapathFrame& frame : datapath_frames()) {
    if (frame.comparison.config == config && frame.comparison.set.empty()) return frame.comparison.scene;
  }
  return "patch_fig6";
}

json config_entry(const std::string& name, const ReportOptions& options) {
  const Config config = load_config(name);
  json entry{{"name", name}, {"choices", choices(config)}};
  say(fmt::format("{}: error", name));
  entry["error"] = to_json(measure_error(name, config, build_frame(config, scene_named(scene_of(name)))));
  if (options.no_area) return entry;
  say(fmt::format("{}: area", name));
  AreaOptions area;
  area.progress = say;
  area.flat = false;  // Fig. 1 to 3 show how near the sum of the stages comes to it
  entry["area"] = to_json(measure_area(name, config, area));
  return entry;
}

json speed_entry(const ReportOptions& options, const json& configs) {
  const Config standard = load_config("standard");
  json result{{"config", "standard"}, {"scene", "patch_fig6"}, {"engines", json::array()}, {"chips", json::array()}};
  for (const EngineSpeed& speed : measure_engines(standard, build_frame(standard, scene_named("patch_fig6")), 3))
    result["engines"].push_back(to_json(speed));
  for (const json& entry : configs) {
    const std::string name = entry["name"];
    const Config config = load_config(name);
    const double period = options.no_area ? 0 : entry["area"]["critical_path_ns"].get<double>();
    result["chips"].push_back(
        to_json(chip_speed(name, config, build_frame(config, scene_named(scene_of(name))), period)));
  }
  return result;
}

std::string source_version() {
  if (!fs::exists(fs::path(WRINKLE_SOURCE_DIR) / ".git")) return "not in a repository";
  return first_line({"git", "-C", WRINKLE_SOURCE_DIR, "describe", "--always", "--dirty"});
}

// The processor, as Linux names it.
std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(": ") + 2);
  }
  return "unknown";
}

json provenance(const ReportOptions& options) {
  json result;
  result["source"] = source_version();
  result["command"] =
      fmt::format("./wrinkle report{}{} --scenes {}{}{}{}{}", options.configs.empty() ? "" : " --configs ",
                  fmt::join(options.configs, ","), fmt::join(options.scenes, ","), options.rtl ? " --rtl" : "",
                  options.no_area ? " --no-area" : "", options.no_speed ? " --no-speed" : "",
                  options.no_paper ? " --no-paper" : "");
  result["area of Fig. 1, 2 and 3"] = "./wrinkle area --figures";
  result["Fig. 5, 6 and 7"] = fmt::format("./wrinkle figures --engine {}", options.rtl ? "rtl" : "golden");
  result["one stage alone"] = "./wrinkle area standard --stage normalize";
  result["error of one configuration"] = "./wrinkle error standard patch_fig6";
  result["speed"] = "./wrinkle speed standard patch_fig6";
  result["processor"] = processor();
  result["compiler"] = __VERSION__;
  result["synthesis"] = first_line({"yosys", "-V"});
  result["cells"] = liberty_path(CellLibrary::kOsu035).string();
  result["timing"] = "OpenSTA " + first_line({"sta", "-version"}) + ", typical corner, no wires";
  result["model of the RTL"] = first_line({"verilator", "--version"});
  result["instruction set of golden"] = std::string(simd_target());
  result["seeds"] = "stalls and latencies of the RTL 1; everything else is deterministic";
  result["charts"] = "Chart.js of Debian's libjs-chart.js, MIT licence";
  return result;
}

}  // namespace

Figures named_figures(const AreaOptions& options) {
  const std::vector<std::string> no_shadow{"self_shadow=off"}, phong{"self_shadow=off", "datapath=phong"};
  // These are the smallest widths that keep the precision of `standard` on the patch.
  const std::vector<std::string> products{"self_shadow=off", "wide_bits=11", "gradient_bits=8"};
  const Config standard = load_config("standard");
  return measure_figures(apply_overrides(standard, phong), apply_overrides(load_config("blinn"), products),
                         apply_overrides(standard, no_shadow), options);
}

json collect(const ReportOptions& options) {
  json data;
  if (!options.no_area) {
    AreaOptions area;
    area.progress = say;
    data["figures"] = to_json(named_figures(area));
  }
  data["configs"] = json::array();
  for (const std::string& name : options.configs.empty() ? named_configs() : options.configs)
    data["configs"].push_back(config_entry(name, options));
  say("pictures");
  data["pictures"] = picture_entries(options);
  if (!options.no_paper) {
    say("Fig. 5, 6 and 7");
    data["paper"] = paper_entry(options, data["pictures"]);
  }
  if (!options.no_speed) data["speed"] = speed_entry(options, data["configs"]);
  data["provenance"] = provenance(options);
  return data;
}

}  // namespace wrinkle

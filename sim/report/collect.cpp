#include "sim/report/collect.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "golden/pixel/pixel.h"
#include "sim/command.h"
#include "sim/config_file.h"
#include "sim/engine.h"
#include "sim/input_error.h"
#include "sim/losses.h"
#include "sim/report/columns.h"
#include "sim/report/error.h"
#include "sim/report/paper.h"
#include "sim/report/runs.h"
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

void add_picture(json& entries, const std::string& title, const std::string& engine, const Run& run, json picture) {
  picture.update({{"name", fmt::format("{}, {}", title, engine)}, {"config", run.config}, {"scene", run.scene}});
  entries.push_back(std::move(picture));
}

// The runs whose scene the configuration can draw go to `visit`; why another cannot be drawn is told, once.
class Frames {
 public:
  explicit Frames(const Runs& runs) : runs_(runs) {}

  void for_each(const std::vector<Run>& list,
                const std::function<void(const Run&, const Config&, const Frame&)>& visit) {
    for (const Run& run : list) {
      const Config& config = runs_.config(run.config);
      const Scene& scene = runs_.scene(run.scene);
      try {
        const Frame frame = build_frame(config, scene);
        with_objects_named(config, scene, frame, [&] { visit(run, config, frame); });
      } catch (const std::invalid_argument& error) {
        leave_out(run, error.what());
      } catch (const InputError& error) {
        leave_out(run, error.what());
      }
    }
  }
  const json& left_out() const { return left_out_; }

 private:
  void leave_out(const Run& run, const std::string& why) {
    const json entry{{"name", fmt::format("{}, {}", run.config, run.scene)}, {"why", why}};
    if (std::find(left_out_.begin(), left_out_.end(), entry) != left_out_.end()) return;
    say(fmt::format("left out: {} on {}: {}", run.config, run.scene, why));
    left_out_.push_back(entry);
  }

  const Runs& runs_;
  json left_out_ = json::array();
};

json picture_entries(const ReportOptions& options, const Runs& runs, Frames& frames) {
  json entries = json::array();
  std::vector<std::pair<Engine, const char*>> engines{
      {Engine::kGolden, "golden"}, {Engine::kExact, "exact"}, {Engine::kIdeal, "ideal"}};
  if (options.rtl) engines.insert(engines.begin(), {Engine::kRtl, "rtl"});
  frames.for_each(runs.drawn(), [&](const Run& run, const Config& config, const Frame& frame) {
    say(fmt::format("{} on {}: pictures", run.config, run.scene));
    for (const auto& [engine, engine_name] : engines)
      add_picture(entries, runs.title(run), engine_name, run, picture_with_columns(engine, config, frame));
  });
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
      add_picture(pictures, title->second, engine, {}, {{"png", data_uri(named.picture)}});
  }
  return figures.results;
}

json config_entry(const std::string& name, const Config& config, const ReportOptions& options) {
  json entry{{"name", name}, {"choices", choices(config)}, {"parameters", parameters_json(config)}};
  if (options.no_area) return entry;
  say(fmt::format("{}: area", name));
  AreaOptions area;
  area.progress = say;
  area.flat = false;  // Fig. 1 to 3 show how near the sum of the stages comes to it
  entry["area"] = to_json(measure_area(name, config, area));
  return entry;
}

json run_entry(const Runs& runs, const Run& run) {
  return {{"name", runs.name(run)}, {"config", run.config}, {"scene", run.scene}};
}

json error_entries(const Runs& runs, Frames& frames) {
  json entries = json::array();
  frames.for_each(runs.measured(), [&](const Run& run, const Config& config, const Frame& frame) {
    say(fmt::format("{} on {}: error", run.config, run.scene));
    json entry = run_entry(runs, run);
    entry["error"] = to_json(measure_error(run.config, config, frame));
    entry["error"]["scene"] = run.scene;
    entries.push_back(std::move(entry));
  });
  return entries;
}

// The critical path of a configuration that was synthesized, else 0.
double period_of(const json& configs, const std::string& name) {
  for (const json& entry : configs) {
    if (entry["name"] == name && entry.contains("area")) return entry["area"]["critical_path_ns"];
  }
  return 0;
}

// The engines on the runs that were asked for by name; else on the paper's patch, by `standard`.
json speed_entry(const ReportOptions& options, const Runs& runs, Frames& frames, const json& configs) {
  json result{{"runs", json::array()}, {"chips", json::array()}};
  frames.for_each(runs.measured(), [&](const Run& run, const Config& config, const Frame& frame) {
    say(fmt::format("{} on {}: speed", run.config, run.scene));
    json chip = to_json(chip_speed(run.config, config, frame, period_of(configs, run.config)));
    chip.update(run_entry(runs, run));
    result["chips"].push_back(std::move(chip));
    if (options.configs.empty() && (run.config != "standard" || run.scene != "patch_fig6")) return;
    json entry = run_entry(runs, run);
    for (const EngineSpeed& speed : measure_engines(config, frame, 3)) entry["engines"].push_back(to_json(speed));
    result["runs"].push_back(std::move(entry));
  });
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
      fmt::format("./wrinkle report{}{}{}{}{}{}{}{}", options.configs.empty() ? "" : " --configs ",
                  fmt::join(options.configs, ","), options.scenes.empty() ? "" : " --scenes ",
                  fmt::join(options.scenes, ","), options.rtl ? " --rtl" : "", options.no_area ? " --no-area" : "",
                  options.no_speed ? " --no-speed" : "", options.no_paper ? " --no-paper" : "");
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
  const Runs runs(options.configs, options.scenes);
  Frames frames(runs);
  json data;
  data["runs"] = error_entries(runs, frames);
  if (data["runs"].empty()) throw InputError(Place{"report"}, "no configuration can draw any of the scenes");
  if (!options.no_area) {
    AreaOptions area;
    area.progress = say;
    data["figures"] = to_json(named_figures(area));
  }
  data["configs"] = json::array();
  for (const std::string& name : runs.configs())
    data["configs"].push_back(config_entry(name, runs.config(name), options));
  data["column_format"] = {{"offset", kColumnOffset}, {"step", kColumnStep}};
  data["pictures"] = picture_entries(options, runs, frames);
  if (!options.no_paper) {
    say("Fig. 5, 6 and 7");
    data["paper"] = paper_entry(options, data["pictures"]);
  }
  if (!options.no_speed) data["speed"] = speed_entry(options, runs, frames, data["configs"]);
  data["left_out"] = frames.left_out();
  data["provenance"] = provenance(options);
  return data;
}

}  // namespace wrinkle

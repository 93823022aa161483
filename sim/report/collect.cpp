#include "sim/report/collect.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "golden/pixel/pixel.h"
#include "sim/command.h"
#include "sim/config_file.h"
#include "sim/datapaths.h"
#include "sim/engine.h"
#include "sim/report/error.h"
#include "sim/report/speed.h"
#include "tb/process.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

void say(const std::string& message) { fmt::print(stderr, "wrinkle: {}\n", message); }

// The name of a choice's value.
std::string value_name(const Config& config, std::string_view key) {
  for (const Parameter& p : parameters()) {
    if (p.name == key) return std::string(p.values[std::size_t(config.*p.member)]);
  }
  return {};
}

std::string base64(const std::string& bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < n ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= n ? kDigits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

std::string data_uri(const Picture& picture) {
  const fs::path path = fs::temp_directory_path() / fmt::format("wrinkle-{}.png", getpid());
  write_picture(path, picture);
  const std::string uri = "data:image/png;base64," + base64(read_text(path));
  fs::remove(path);
  return uri;
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
    for (const auto& [engine, engine_name] : engines) {
      Framebuffer framebuffer = framebuffer_for(config, frame);
      draw(engine, config, frame, {}, [&](const Sample& sample) { framebuffer.add(sample); });
      entries.push_back({{"name", fmt::format("{}, {}", name, engine_name)},
                         {"config", scene.config},
                         {"png", data_uri(framebuffer.colour())}});
    }
  }
  return entries;
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
  json entry{
      {"name", name}, {"datapath", value_name(config, "datapath")}, {"normalizer", value_name(config, "normalizer_n")}};
  say(fmt::format("{}: error", name));
  entry["error"] = to_json(measure_error(name, config, build_frame(config, scene_named(scene_of(name)))));
  if (options.no_area) return entry;
  say(fmt::format("{}: area", name));
  AreaOptions area;
  area.progress = say;
  entry["area"] = to_json(measure_area(name, config, area));
  return entry;
}

json speed_entry(const ReportOptions& options, const json& configs) {
  const Config standard = load_config("standard");
  json result{{"config", "standard"}, {"scene", "patch_fig6"}, {"engines", json::array()}, {"chips", json::array()}};
  for (const EngineSpeed& speed : measure_engines(standard, build_frame(standard, scene_named("patch_fig6")), 3))
    result["engines"].push_back(to_json(speed));
  if (options.no_area) return result;
  for (const json& entry : configs) {
    const std::string name = entry["name"];
    const Config config = load_config(name);
    const double period = entry["area"]["flat"]["critical_path_ns"];
    result["chips"].push_back(
        to_json(chip_speed(name, config, build_frame(config, scene_named(scene_of(name))), period)));
  }
  return result;
}

std::string source_version() {
  if (!fs::exists(fs::path(WRINKLE_SOURCE_DIR) / ".git")) return "not in a repository";
  return first_line({"git", "-C", WRINKLE_SOURCE_DIR, "describe", "--always", "--dirty"});
}

json provenance(const ReportOptions& options) {
  json result;
  result["source"] = source_version();
  result["command"] =
      fmt::format("./wrinkle report{}{} --scenes {}{}{}{}", options.configs.empty() ? "" : " --configs ",
                  fmt::join(options.configs, ","), fmt::join(options.scenes, ","), options.rtl ? " --rtl" : "",
                  options.no_area ? " --no-area" : "", options.no_speed ? " --no-speed" : "");
  result["figures alone"] = "./wrinkle area --figures";
  result["one stage alone"] = "./wrinkle area standard --stage normalize";
  result["error of one configuration"] = "./wrinkle error standard patch_fig6";
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
  // The least that keep the precision of `standard` on the patch: one bit less of either falls below it.
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
  if (!options.no_speed) data["speed"] = speed_entry(options, data["configs"]);
  data["provenance"] = provenance(options);
  return data;
}

}  // namespace wrinkle

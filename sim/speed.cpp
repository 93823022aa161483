// speed: pixels per CPU second of every engine, and pixels per second of the chip in every configuration.
#include "sim/report/speed.h"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "sim/command.h"
#include "sim/config_file.h"

namespace wrinkle {
namespace {

struct Options {
  std::string config = "standard", scene = "patch_fig6";
  std::vector<std::string> chips{"lean", "standard"};
  int runs = 3;
  std::filesystem::path json;
};

nlohmann::json engines(const Options& options, const Scene& scene) {
  const Config config = load_config(options.config);
  nlohmann::json rows = nlohmann::json::array();
  fmt::print("{} on {}, medians of {} interleaved runs\n", options.config, scene.name, options.runs);
  for (const EngineSpeed& speed : measure_engines(config, build_frame(config, scene), options.runs)) {
    fmt::print("{:<14} {:>14.0f} pixels per CPU second   {}\n", speed.engine, speed.pixels_per_cpu_s,
               speed.faithful_to);
    rows.push_back(to_json(speed));
  }
  return rows;
}

nlohmann::json chips(const Options& options, const Scene& scene) {
  nlohmann::json rows = nlohmann::json::array();
  for (const std::string& name : options.chips) {
    const Config config = load_config(name);
    AreaOptions area;
    area.flat = false;
    const double period = measure_area(name, config, area).critical_path_ns();
    const ChipSpeed speed = chip_speed(name, config, build_frame(config, scene), period);
    fmt::print("{:<14} {:.3f} clocks per pixel, {:.2f} ns a clock in osu035: {:.1f} million pixels per second\n", name,
               speed.clocks_per_pixel, speed.period_ns, 1e-6 * speed.pixels_per_s);
    rows.push_back(to_json(speed));
  }
  return rows;
}

int speed(const Options& options) {
  const Scene scene = scene_named(options.scene);
  nlohmann::json result{{"config", options.config}, {"scene", options.scene}, {"runs", options.runs}};
  result["engines"] = engines(options, scene);
  result["chips"] = chips(options, scene);
  write_json(options.json, result);
  return kExitEqual;
}

}  // namespace

void add_speed(CLI::App& app, Action& run) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("speed", "Speed for accuracy: all engines, and the chip");
  command->add_option("config", options->config, "What the engines are timed in")->capture_default_str();
  command->add_option("scene", options->scene, "What is drawn")->capture_default_str();
  command->add_option("--chips", options->chips, "Configurations whose chip is timed")
      ->delimiter(',')
      ->capture_default_str();
  command->add_option("--runs", options->runs, "Interleaved runs that medians are taken of")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  add_json_option(*command, options->json);
  command->callback([options, &run] { run = [options] { return speed(*options); }; });
}

}  // namespace wrinkle

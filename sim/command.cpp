#include "sim/command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "sim/config_file.h"
#include "sim/input_error.h"
#include "sim/losses.h"
#include "sim/picture.h"
#include "sim/scene/scene_reader.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

StallProfile stall_profile(const std::string& name) {
  if (name == "none") return StallProfile::kNone;
  if (name == "random") return StallProfile::kRandom;
  if (name == "bursty") return StallProfile::kBursty;
  if (name == "extreme") return StallProfile::kExtreme;
  throw InputError(Place{"--stalls"}, name, "none, random, bursty or extreme");
}

}  // namespace

void say(const std::string& message) { fmt::print(stderr, "{}{}\n", isatty(STDERR_FILENO) ? "\r\033[K" : "", message); }

void add_config_options(CLI::App& command, ConfigOptions& options) {
  command.add_option(
      "-c,--config", options.name,
      fmt::format("{}, or a .toml file; else the one that the scene names", fmt::join(named_configs(), ", ")));
  add_set_option(command, options.set);
}

void add_set_option(CLI::App& command, std::vector<std::string>& set) {
  command.add_option("--set", set, "Change parameters of the configuration: KEY=VALUE, by commas")
      ->delimiter(',')
      ->allow_extra_args(false);
}

void sort_names(std::string& config, std::string& scene) {
  if (is_scene(config) && (scene.empty() || !is_scene(scene))) std::swap(config, scene);
}

Config chosen_config(const ConfigOptions& options, const std::string& otherwise) {
  return apply_overrides(load_config(options.name.empty() ? otherwise : options.name), options.set);
}

void add_rtl_options(CLI::App& command, RtlOptions& options) {
  command.add_option("--stalls", options.stalls, "On every stream: none, random, bursty or extreme")
      ->capture_default_str();
  command.add_option("--seed", options.seed, "Of stalls, latencies and random triangles")->capture_default_str();
  command.add_option("--latency", options.latency, "Longest wait for texels, in clocks")
      ->capture_default_str()
      ->check(CLI::Range(0, 100000));
  command.add_option("--rtl", options.rtl, "Folder with other Verilog sources, in rtl/")->check(CLI::ExistingDirectory);
}

BenchOptions quiet_bench_options() {
  BenchOptions bench;
  bench.progress = say;
  return bench;
}

BenchOptions bench_options(const RtlOptions& options) {
  BenchOptions bench = quiet_bench_options();
  bench.stalls = stall_profile(options.stalls);
  bench.seed = options.seed;
  bench.latency = options.latency;
  bench.model.source_root = options.rtl;
  return bench;
}

void add_json_option(CLI::App& command, fs::path& path) {
  command.add_option("--json", path, "Write the results to this file as one JSON object");
}

void write_json(const fs::path& path, const nlohmann::json& object) {
  if (!path.empty()) write_text(path, object.dump(2) + "\n");
}

void add_scene_options(CLI::App& command, SceneOverrides& overrides) {
  command.add_option("--camera", overrides.camera,
                     "Another view, as the table of a scene file: 'type = \"perspective\", eye = [0, 0, 5], fov = 35'");
  command.add_option("--light", overrides.light, "Another light: 'direction = [1, 2, 3]' or 'position = [1, 2, 3]'");
  command.add_option("--background", overrides.background, "R,G,B or one grey, each 0 to 1");
  command.add_option("--exposure", overrides.exposure, "Factor of all light");
}

Scene scene_named(const std::string& name_or_path, const SceneOverrides& overrides) {
  Notes notes;
  Scene scene = read_scene(name_or_path, &notes);
  apply_overrides(overrides, scene, notes);
  constexpr std::size_t kShown = 40;
  for (std::size_t i = 0; i < std::min(notes.size(), kShown); ++i) say(notes[i]);
  if (notes.size() > kShown) say(fmt::format("{}: and {} more notes", name_or_path, notes.size() - kShown));
  return scene;
}

void say_losses(const Config& config, const Scene& scene) {
  for (const std::string& loss : losses(config, scene)) say(scene.name + ": " + loss);
}

fs::path shared_assets() {
  const fs::path assets = fs::path(WRINKLE_SOURCE_DIR) / "../shared/assets";
  return fs::is_directory(assets) ? assets : fs::path();
}

nlohmann::json parameters_json(const Config& config) {
  nlohmann::json values;
  for (const Parameter& parameter : parameters()) {
    const int value = config.*parameter.member;
    nlohmann::json& entry = values[std::string(parameter.name)];
    if (parameter.values.empty()) {
      entry = value;
    } else {
      entry = std::string(parameter.values[std::size_t(value)]);
    }
  }
  return values;
}

nlohmann::json to_json(const Difference& d) {
  return {
      {"frame", d.frame},   {"draw", d.draw}, {"packet", d.packet}, {"triangle", d.triangle}, {"fragment", d.fragment},
      {"x", d.x},           {"y", d.y},       {"stage", d.stage},   {"value", d.value},       {"element", d.element},
      {"golden", d.golden}, {"rtl", d.rtl},   {"cycle", d.cycle},   {"text", describe(d)}};
}

}  // namespace wrinkle

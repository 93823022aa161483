// What the commands share. Each command is one file; main.cpp is the list of them.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "golden/config/config.h"
#include "golden/vertex/scene.h"
#include "sim/scene/scene_reader.h"
#include "tb/bench.h"

namespace wrinkle {

// The program did what was asked and all was equal; it compared and found a difference; the input was bad, or nothing
// could be done.
inline constexpr int kExitEqual = 0, kExitDifferent = 1, kExitBadInput = 2;

// Set by the command that was chosen; returns the exit code.
using Action = std::function<int()>;

void add_demo(CLI::App& app, Action& run);
void add_render(CLI::App& app, Action& run);
void add_verify(CLI::App& app, Action& run);
void add_stress(CLI::App& app, Action& run);
void add_bench(CLI::App& app, Action& run);
void add_area(CLI::App& app, Action& run);
void add_error(CLI::App& app, Action& run);
void add_speed(CLI::App& app, Action& run);
void add_figures(CLI::App& app, Action& run);
void add_report(CLI::App& app, Action& run);
void add_config(CLI::App& app, Action& run);
void add_completion(CLI::App& app, Action& run);
void add_generate(CLI::App& app, Action& run);

// --config NAME and --set KEY=VALUE.
struct ConfigOptions {
  std::string name;
  std::vector<std::string> set;
};
void add_config_options(CLI::App& command, ConfigOptions& options);
// --set KEY=VALUE[,KEY=VALUE...], as often as wanted.
void add_set_option(CLI::App& command, std::vector<std::string>& set);
// A configuration and a scene, given in either order or one alone: each is known by what it is. Empty stays empty.
void sort_names(std::string& config, std::string& scene);
// The configuration asked for, or `otherwise` by name.
Config chosen_config(const ConfigOptions& options, const std::string& otherwise);

// --stalls, --seed, --latency, --rtl.
struct RtlOptions {
  std::string stalls = "random";
  std::uint64_t seed = 1;
  int latency = 8;
  std::filesystem::path rtl;  // a folder that holds other Verilog sources under rtl/
};
void add_rtl_options(CLI::App& command, RtlOptions& options);
BenchOptions bench_options(const RtlOptions& options);
// The bench prints nothing but that a model is being built, and that only on a terminal.
BenchOptions quiet_bench_options();

// --json FILE.
void add_json_option(CLI::App& command, std::filesystem::path& path);
// Nothing when `path` is empty.
void write_json(const std::filesystem::path& path, const nlohmann::json& object);

// --camera, --light, --background, --exposure.
void add_scene_options(CLI::App& command, SceneOverrides& overrides);
// A scene by path, or one of sim/scenes by its bare name. What the reader passed over is printed on standard
// error.
Scene scene_named(const std::string& name_or_path, const SceneOverrides& overrides = {});
// Says on standard error what the configuration takes from the scene.
void say_losses(const Config& config, const Scene& scene);
// One line on standard error, in the place of a progress line.
void say(const std::string& message);

// The folder of reference material beside the project; an empty path where it is not present.
std::filesystem::path shared_assets();

nlohmann::json to_json(const Difference& difference);
// Every parameter by its name; choices by theirs.
nlohmann::json parameters_json(const Config& config);

}  // namespace wrinkle

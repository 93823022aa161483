// config: a configuration as it is after all files and settings, with what follows from it.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "golden/config/verilog.h"
#include "sim/command.h"
#include "sim/config_file.h"
#include "sim/losses.h"

namespace wrinkle {
namespace {

struct Options {
  std::string config, scene;
  std::vector<std::string> set;
  bool toml = false, verilog = false;
  std::filesystem::path json;
};

std::string value_of(const Config& config, const Parameter& parameter) {
  const int value = config.*parameter.member;
  return parameter.values.empty() ? std::to_string(value) : std::string(parameter.values[std::size_t(value)]);
}

std::string legal(const Parameter& parameter) {
  if (!parameter.values.empty()) return fmt::format("{}", fmt::join(parameter.values, "|"));
  return fmt::format("{} to {}", parameter.minimum, parameter.maximum);
}

// What goes between wrinkle_core and the name of an instance.
std::string verilog(const Config& config) {
  std::vector<std::string> connections;
  for (const Parameter& parameter : parameters()) {
    if (parameter.scope != Scope::core) continue;
    connections.push_back(fmt::format("    .{}({})", verilog_text(parameter.name), config.*parameter.member));
  }
  return fmt::format("#(\n{}\n)", fmt::join(connections, ",\n"));
}

void print_table(const Config& config) {
  for (const Parameter& parameter : parameters()) {
    const bool standard = config.*parameter.member == parameter.standard;
    fmt::print("{:<19} {:<13}{} {}\n", parameter.name, value_of(config, parameter), standard ? " " : "*",
               legal(parameter));
  }
  fmt::print("* other than the default\n\n");
  const Shape shape(config);
  for (const DerivedValue& value : derived_values())
    fmt::print("{:<24} {:<5} {}\n", value.name, shape.*value.member, value.description);
}

nlohmann::json to_json(const Options& options, const Config& config, const std::vector<std::string>& lost) {
  nlohmann::json widths;
  const Shape shape(config);
  for (const DerivedValue& value : derived_values()) widths[std::string(value.name)] = shape.*value.member;
  nlohmann::json result{{"config", options.config}, {"parameters", parameters_json(config)}, {"derived", widths}};
  if (!options.scene.empty()) {
    result["scene"] = options.scene;
    result["losses"] = lost;
  }
  return result;
}

int show(Options options) {
  sort_names(options.config, options.scene);
  if (options.config.empty()) options.config = "standard";
  const Config config = apply_overrides(load_config(options.config), options.set);
  std::vector<std::string> lost;
  if (!options.scene.empty()) lost = losses(config, scene_named(options.scene));
  if (options.toml) {
    fmt::print("{}", write_config(config));
  } else if (options.verilog) {
    fmt::print("{}\n", verilog(config));
  } else {
    print_table(config);
    for (const std::string& loss : lost) fmt::print("{}: {}\n", options.scene, loss);
    if (!options.scene.empty() && lost.empty()) fmt::print("{}: all that it has is drawn\n", options.scene);
  }
  write_json(options.json, to_json(options, config, lost));
  return kExitEqual;
}

}  // namespace

void add_config(CLI::App& app, Action& run) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("config", "A configuration: values, legal ranges, what follows from them");
  command->add_option("config", options->config, "Configuration, by name or .toml file; else standard");
  command->add_option("scene", options->scene, "A scene, to say what the configuration does not draw of it");
  add_set_option(*command, options->set);
  command->add_flag("--toml", options->toml, "As a configuration file");
  command->add_flag("--verilog", options->verilog, "As the parameters of an instance of wrinkle_core");
  add_json_option(*command, options->json);
  command->callback([options, &run] { run = [options] { return show(*options); }; });
}

}  // namespace wrinkle

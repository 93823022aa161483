// render: a picture of a scene by any engine, with intermediates as EXR channels.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "sim/command.h"
#include "sim/engine.h"
#include "sim/input_error.h"
#include "sim/losses.h"
#include "sim/picture.h"
#include "sim/scene/files.h"
#include "sim/scene/scene_reader.h"

namespace wrinkle {
namespace {

struct Options {
  std::string scene, engine = "golden", size;
  ConfigOptions config;
  std::vector<std::string> aovs;
  SceneOverrides overrides;
  std::filesystem::path output, json;
};

// A name with an ending that pictures have, as the option or, below out/, the scene says. Refused before anything is
// drawn where it cannot hold the picture, or is a file that was read.
std::filesystem::path checked_output(const Options& options, const Scene& scene) {
  const bool aovs = !options.aovs.empty();
  std::filesystem::path output = options.output;
  if (output.empty()) output = std::filesystem::path("out") / (scene.name + (aovs ? ".exr" : ".png"));
  if (aovs && extension_of(output) != ".exr")
    throw InputError(Place{output.string()}, "a picture without named channels", "an .exr file with --aov");
  check_not_read(output);
  if (!options.json.empty()) check_not_read(options.json);
  return output;
}

// "512" or "640x480".
void apply_size(const std::string& text, Scene& scene) {
  int width = 0, height = 0;
  char rest = 0;
  const int found = std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest);
  if (found == 1 && text.find_first_not_of("0123456789") == std::string::npos)
    height = width;
  else if (found != 2)
    width = 0;
  if (width < 1 || height < 1 || width > 4096 || height > 4096)
    throw InputError(Place{"--size"}, text, "WIDTHxHEIGHT, each 1 to 4096");
  scene.width = width;
  scene.height = height;
}

int render(const Options& options) {
  const Engine engine = engine_named(options.engine);
  Scene scene = scene_named(options.scene, options.overrides);
  if (!options.size.empty()) apply_size(options.size, scene);
  const Config config = chosen_config(options.config, scene.config);
  const std::vector<AovChannel> aovs = aov_channels(config, options.aovs);
  const std::filesystem::path output = checked_output(options, scene);
  say_losses(config, scene);

  const Frame frame = build_frame(config, scene);
  Framebuffer framebuffer = framebuffer_for(config, frame, aovs);
  EngineRun run;
  with_objects_named(config, scene, frame, [&] {
    run = draw(engine, config, frame, aovs, [&](const Sample& sample) { framebuffer.add(sample); });
  });
  if (run.fragments == 0) say(why_empty(scene));
  write_picture(output, aovs.empty() ? framebuffer.colour() : framebuffer.all_channels());
  fmt::print("{}: {} x {}, {} fragments by {}\n", output.string(), frame.width, frame.height, run.fragments,
             options.engine);
  write_json(options.json, {{"scene", scene.name},
                            {"engine", options.engine},
                            {"parameters", parameters_json(config)},
                            {"width", frame.width},
                            {"height", frame.height},
                            {"fragments", run.fragments},
                            {"cycles", run.cycles},
                            {"image", output.string()}});
  return kExitEqual;
}

}  // namespace

void add_render(CLI::App& app, Action& run) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("render", "Draw a scene with any engine");
  command->add_option("SCENE", options->scene, fmt::format("A scene file, or {}", fmt::join(named_scenes(), ", ")))
      ->required();
  command->add_option("-e,--engine", options->engine, std::string(engine_names()))->capture_default_str();
  add_config_options(*command, options->config);
  add_scene_options(*command, options->overrides);
  command->add_option("--size", options->size, "WIDTHxHEIGHT instead of the scene's");
  command->add_option("--aov", options->aovs, "Intermediates to write as EXR channels, by commas:" + aov_help())
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("-o,--output", options->output, "Picture to write, .png or .exr; else below out/");
  add_json_option(*command, options->json);
  command->callback([options, &run] { run = [options] { return render(*options); }; });
}

}  // namespace wrinkle

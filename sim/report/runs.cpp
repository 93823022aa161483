#include "sim/report/runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "sim/command.h"
#include "sim/config_file.h"
#include "sim/datapaths.h"

namespace wrinkle {
namespace {

const std::vector<std::string> kPaperScenes{"patch_fig1", "patch_fig5", "patch_fig6", "patch_fig7", "teapot"};

// The scene of `verify --all` that a configuration is for; the paper's patch for those that have none.
std::string scene_for(const std::string& config) {
  for (const DatapathFrame& frame : datapath_frames()) {
    if (frame.comparison.config == config && frame.comparison.set.empty()) return frame.comparison.scene;
  }
  return "patch_fig6";
}

}  // namespace

Runs::Runs(const std::vector<std::string>& configs, const std::vector<std::string>& scenes)
    : configs_(configs.empty() ? named_configs() : configs) {
  for (const std::string& config : configs_) {
    load_config_of(config);
    for (const std::string& scene : scenes.empty() ? std::vector{scene_for(config)} : scenes) {
      load_scene_of(scene);
      measured_.push_back({config, scene});
    }
  }
  if (!configs.empty()) {
    drawn_ = measured_;
    return;
  }
  for (const std::string& scene : scenes.empty() ? kPaperScenes : scenes) {
    load_scene_of(scene);
    drawn_.push_back({this->scene(scene).config, scene});
    load_config_of(drawn_.back().config);
  }
}

void Runs::load_config_of(const std::string& name) {
  if (!loaded_configs_.contains(name)) loaded_configs_[name] = load_config(name);
}

void Runs::load_scene_of(const std::string& name) {
  if (!loaded_scenes_.contains(name)) loaded_scenes_[name] = scene_named(name);
}

std::string Runs::short_name(const std::string& scene) const {
  const auto file = [](const std::string& name) { return std::filesystem::path(name).filename().string(); };
  const auto same = std::ranges::count_if(loaded_scenes_, [&](const auto& s) { return file(s.first) == file(scene); });
  return same > 1 ? scene : file(scene);
}

std::string Runs::name(const Run& run) const {
  const auto same = std::ranges::count(measured_, run.config, &Run::config);
  return same > 1 ? fmt::format("{}, {}", run.config, short_name(run.scene)) : run.config;
}

std::string Runs::title(const Run& run) const {
  static const std::string kFigure = "patch_fig";
  const std::string scene =
      run.scene.starts_with(kFigure) ? "Fig. " + run.scene.substr(kFigure.size()) : short_name(run.scene);
  const auto same = std::ranges::count(drawn_, run.scene, &Run::scene);
  return same > 1 ? fmt::format("{}, {}", scene, run.config) : scene;
}

}  // namespace wrinkle

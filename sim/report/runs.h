// Which configurations a report measures on which scenes.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "golden/config/config.h"
#include "golden/vertex/scene.h"

namespace wrinkle {

// A configuration on a scene, each by the name or file that the user gave.
struct Run {
  std::string config, scene;
};

// All that is read is read here, so that a file that is wrong is told before anything is measured.
class Runs {
 public:
  // Where `configs` or `scenes` are given, each configuration (else all named ones) on each scene (else the one it is
  // for). Where neither is, each named configuration on the scene that it is for, and pictures of the paper's scenes.
  Runs(const std::vector<std::string>& configs, const std::vector<std::string>& scenes);

  const std::vector<std::string>& configs() const { return configs_; }
  const std::vector<Run>& measured() const { return measured_; }
  // Each run, or each scene with its own configuration where no configurations were given.
  const std::vector<Run>& drawn() const { return drawn_; }

  const Config& config(const std::string& name) const { return loaded_configs_.at(name); }
  const Scene& scene(const std::string& name) const { return loaded_scenes_.at(name); }

  // The configuration, with the scene behind it where it is measured on more than one.
  std::string name(const Run& run) const;
  // "Fig. 6" for patch_fig6, else the scene; with the configuration behind it where more than one draws the scene.
  std::string title(const Run& run) const;

 private:
  // A file without its folders, where no other scene has the same name.
  std::string short_name(const std::string& scene) const;
  void load_config_of(const std::string& name);
  void load_scene_of(const std::string& name);

  std::vector<std::string> configs_;
  std::vector<Run> measured_, drawn_;
  std::map<std::string, Config> loaded_configs_;
  std::map<std::string, Scene> loaded_scenes_;
};

}  // namespace wrinkle

#include "sim/digest/plan.h"

#include <fmt/format.h>

#include "sim/config_file.h"
#include "sim/digest/choices.h"
#include "tb/random_frame.h"

namespace wrinkle {
namespace {

DigestFrame random_line(const char* kind, const Config& config, std::uint64_t seed) {
  return {fmt::format("{}_{}", kind, seed), settings_of(config), fmt::format("random:{}", seed)};
}

// What the other lines are drawn without.
Config without_gloss(Config config) {
  config.gloss_map = 0;
  return config;
}

}  // namespace

std::vector<DigestFrame> planned_frames() {
  constexpr std::uint64_t kRandomConfigs = 100;
  std::vector<DigestFrame> frames;
  for (const std::string& name : named_configs()) {
    const std::string settings = settings_of(load_config(name));
    for (const char* scene : {"patch_fig1", "patch_fig5", "patch_fig6", "teapot", "random:1"})
      frames.push_back({name, settings, scene});
  }
  for (std::uint64_t seed = 1; seed <= kRandomConfigs; ++seed)
    frames.push_back(random_line("random", without_gloss(random_config(seed)), seed));
  // Choices that a hundred configurations drawn at random do not happen to have.
  for (std::uint64_t seed = kRandomConfigs + 1; seed <= kRandomConfigs + 16; ++seed) {
    Config config = without_gloss(random_config(seed));
    const bool shares = seed % 2 != 0;
    shares ? share_units(config) : normalize_after(config);
    frames.push_back(random_line(shares ? "shared" : "after", config, seed));
  }
  int glossy = 0;
  for (std::uint64_t seed = kRandomConfigs + 17; glossy < 16; ++seed) {
    Config config = random_config(seed);
    if (Shape(config).glossy == 0) continue;
    config.gloss_map = 1;
    frames.push_back(random_line("gloss", config, seed));
    ++glossy;
  }
  return frames;
}

}  // namespace wrinkle

#include "sim/digest/plan.h"

#include <fmt/format.h>

#include "sim/config_file.h"
#include "tb/random_frame.h"

namespace wrinkle {

std::vector<DigestFrame> planned_frames() {
  constexpr std::uint64_t kRandomConfigs = 100;
  std::vector<DigestFrame> frames;
  for (const std::string& name : named_configs()) {
    const std::string settings = settings_of(load_config(name));
    for (const char* scene : {"patch_fig1", "patch_fig5", "patch_fig6", "teapot", "random:1"})
      frames.push_back({name, settings, scene});
  }
  for (std::uint64_t seed = 1; seed <= kRandomConfigs; ++seed)
    frames.push_back(
        {fmt::format("random_{}", seed), settings_of(random_config(seed)), fmt::format("random:{}", seed)});
  return frames;
}

}  // namespace wrinkle

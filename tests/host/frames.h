// Small scenes, and what is drawn of them, for the tests of the vertex rate.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "golden/exact/exact.h"
#include "golden/texel/normal_map.h"
#include "golden/texel/quantise.h"
#include "golden/vertex/camera.h"
#include "golden/vertex/scene.h"

namespace wrinkle::test {

inline constexpr int kSize = 128;

inline Object object_of(Mesh mesh) {
  Object object;
  object.mesh = std::move(mesh);
  return object;
}

inline Scene scene_of(Object object) {
  Scene scene;
  scene.width = scene.height = kSize;
  scene.camera.world_to_eye = look_at({0, 0, 5}, {}, {0, 1, 0});
  scene.light.position = {0.3, 0.4, 1};
  scene.objects.push_back(std::move(object));
  return scene;
}

inline std::shared_ptr<const ExactTexture> texture_of(const NormalMap& map) {
  return std::make_shared<ExactTexture>(assemble(normal_mips(map), {}));
}

inline Object bumped(Mesh mesh, NormalMap map) {
  Object object = object_of(std::move(mesh));
  object.space = ShadingSpace::kTangent;
  object.texture = texture_of(map);
  return object;
}

// N.L of each pixel by the exact engine; -1 where nothing is drawn, -2 where a pixel is drawn twice.
inline std::vector<double> draw(const Config& config, const Scene& scene) {
  std::vector<double> image(static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height), -1);
  draw_exact(config, build_frame(config, scene), [&](const ExactFragment& f) {
    double& pixel = image[static_cast<std::size_t>(f.y * scene.width + f.x)];
    pixel = pixel == -1 ? f.nl : -2;
  });
  return image;
}

}  // namespace wrinkle::test

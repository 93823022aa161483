// What a model file holds, before a scene is made of it.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "golden/vertex/scene.h"
#include "sim/scene/notes.h"

namespace wrinkle {

struct PictureSize {
  int width = 512, height = 512;
};

// What the textures of a scene hold besides bumps, any of them.
struct Maps {
  bool decal = false, gloss = false;

  Maps operator|(const Maps& other) const { return {decal || other.decal, gloss || other.gloss}; }
};

struct Model {
  std::vector<Object> objects;  // at least one
  std::optional<Camera> camera;
  std::optional<Light> light;
  PictureSize size;
  Maps maps;
};

Model read_gltf_model(const std::filesystem::path& path, Notes& notes);
Model read_obj_model(const std::filesystem::path& path, Notes& notes);
// By the extension: .gltf, .glb or .obj.
Model read_model(const std::filesystem::path& path, Notes& notes);

}  // namespace wrinkle

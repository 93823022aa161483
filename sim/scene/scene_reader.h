// Scenes from files. docs/formats.md, "Scene file".
#pragma once

#include <filesystem>
#include <string>

#include "golden/vertex/scene.h"
#include "sim/scene/model.h"
#include "sim/scene/notes.h"

namespace wrinkle {

// A scene from .toml, .gltf, .glb or .obj, whose name may also be that of one in sim/scenes ("teapot"). Bad input is an
// InputError with file and place. What was passed over is added to `notes`.
Scene read_scene(const std::filesystem::path& path, Notes* notes = nullptr);

// What the command line says in the place of the scene file; empty for what it does not.
struct SceneOverrides {
  std::string camera, light;  // the keys of the tables of a scene file, in TOML: "eye = [0, 0, 5], fov = 40"
  std::string background;     // "r,g,b" or one number, in [0, 1]
  std::string exposure;       // factor of all light
};
void apply_overrides(const SceneOverrides& overrides, Scene& scene, Notes& notes);

// The names under sim/scenes, sorted.
std::vector<std::string> named_scenes();

// Whether a name is that of a scene: one of ours, a model file, or a .toml file with objects.
bool is_scene(const std::string& name);
// The reader behind it for .toml.
Scene read_toml_scene(const std::filesystem::path& path, Notes& notes);

// The configuration that shows a scene without one of its own: `gloss` where there is a gloss map, `fine` where there
// is a decal, else `perspective` or `standard` by the camera.
std::string fitting_config(const Maps& maps, bool perspective);

}  // namespace wrinkle

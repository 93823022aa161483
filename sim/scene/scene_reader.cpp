#include "sim/scene/scene_reader.h"

#include <algorithm>

#include "sim/scene/defaults.h"
#include "sim/scene/files.h"
#include "sim/scene/model.h"
#include "sim/scene/suggest.h"
#include "sim/scene/toml_table.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

// A bare word that is no file here names a scene of ours.
fs::path resolve(const fs::path& path) {
  std::error_code error;
  if (path.has_parent_path() || path.has_extension() || fs::exists(path, error)) return path;
  const std::vector<std::string> names = named_scenes();
  if (std::find(names.begin(), names.end(), path.string()) != names.end()) {
    return fs::path(WRINKLE_SCENE_DIR) / (path.string() + ".toml");
  }
  const std::vector<std::string_view> views(names.begin(), names.end());
  throw InputError(Place{path.string(), 0, 0, {}}, "neither a file nor a named scene",
                   list_of(views) + ", or a file" + did_you_mean(path.string(), views));
}

// A model by itself: with its own camera and light, or with sensible ones.
Scene scene_of(Model model, const fs::path& path) {
  Scene scene;
  scene.name = path.stem().string();
  scene.width = model.size.width;
  scene.height = model.size.height;
  scene.background = {0.18, 0.19, 0.21};
  scene.camera = model.camera ? *model.camera : framing_camera(bounds_of(model.objects));
  scene.light = model.light ? *model.light : default_light(scene.camera);
  scene.viewer_at_infinity = !scene.camera.perspective;
  scene.config = fitting_config(model.maps, scene.camera.perspective);
  scene.objects = std::move(model.objects);
  return scene;
}

}  // namespace

std::vector<std::string> named_scenes() {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(WRINKLE_SCENE_DIR)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

bool is_scene(const std::string& name) {
  const std::string extension = extension_of(name);
  if (extension == ".gltf" || extension == ".glb" || extension == ".obj") return true;
  if (extension == ".toml") return is_file({}, name) && parse_toml_file(name).contains("objects");
  const std::vector<std::string> names = named_scenes();
  return std::find(names.begin(), names.end(), name) != names.end();
}

Model read_model(const fs::path& path, Notes& notes) {
  const std::string extension = extension_of(path);
  if (extension == ".gltf" || extension == ".glb") return read_gltf_model(path, notes);
  if (extension == ".obj") return read_obj_model(path, notes);
  throw InputError(Place{path.string(), 0, 0, {}}, "a file with the extension \"" + extension + "\"",
                   ".toml, .gltf, .glb or .obj");
}

std::string fitting_config(const Maps& maps, bool perspective) {
  return maps.gloss ? "gloss" : maps.decal ? "fine" : perspective ? "perspective" : "standard";
}

Scene read_scene(const fs::path& given, Notes* notes) {
  Notes passed_over;
  const fs::path path = resolve(given);
  check_file(path, Place{path.string(), 0, 0, {}});
  Scene scene = extension_of(path) == ".toml" ? read_toml_scene(path, passed_over)
                                              : scene_of(read_model(path, passed_over), path);
  if (notes != nullptr) notes->insert(notes->end(), passed_over.begin(), passed_over.end());
  return scene;
}

}  // namespace wrinkle

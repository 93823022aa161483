#include <algorithm>
#include <cmath>
#include <numbers>

#include "golden/vertex/camera.h"
#include "golden/vertex/transform.h"
#include "sim/config_file.h"
#include "sim/scene/defaults.h"
#include "sim/scene/scene_reader.h"
#include "sim/scene/toml_object.h"
#include "sim/scene/toml_table.h"

namespace wrinkle {
namespace {

constexpr double kWorld = 1e6;  // coordinates of cameras and lights

Camera read_camera(const std::string& file, const toml::table& source, const Bounds& bounds) {
  const TomlTable table(file, source, "camera", {"type", "eye", "target", "up", "height", "fov", "near", "far"});
  Camera camera;
  camera.perspective = table.choice("type", {"orthographic", "perspective"}) == 1;
  const Vec3 eye = table.vector("eye", -kWorld, kWorld);
  const Vec3 target = table.vector("target", -kWorld, kWorld, Vec3{});
  const Vec3 up = table.vector("up", -kWorld, kWorld, Vec3{0, 1, 0});
  if (length(eye - target) < 1e-9) throw InputError(table.place("eye"), "eye = target", "two places");
  if (length(cross(normalize(up), normalize(eye - target))) < 1e-6) {
    throw InputError(table.place("up"), "up along the line of sight", "another direction");
  }
  camera.world_to_eye = look_at(eye, target, up);
  const std::string_view wrong = camera.perspective ? "height" : "fov";
  if (table.has(wrong)) {
    throw InputError(table.place(wrong), "\"" + std::string(wrong) + "\"",
                     camera.perspective ? "\"fov\" for a perspective camera" : "\"height\" for an orthographic one");
  }
  camera.half_height = camera.perspective ? std::tan(table.number("fov", 0.01, 179, 35) * std::numbers::pi / 360)
                                          : 0.5 * table.number("height", 1e-6, kWorld, 2.02 * bounds.radius());
  const double distance = -transform_point(camera.world_to_eye, bounds.centre()).z;
  const double radius = 1.01 * bounds.radius() + 1e-6;
  const double standard_near =
      camera.perspective ? std::max(distance - radius, 1e-3 * (distance + radius)) : distance - radius;
  camera.near = table.number("near", camera.perspective ? 1e-6 : -kWorld, kWorld, standard_near);
  camera.far = table.number("far", -kWorld, kWorld, std::max(distance + radius, camera.near + radius));
  if (camera.far <= camera.near) throw InputError(table.place("far"), "far not beyond near", "far > near");
  return camera;
}

Light read_light(const std::string& file, const toml::table& source) {
  const TomlTable table(file, source, "light", {"position", "direction"});
  if (table.has("position") == table.has("direction")) {
    throw InputError(table.place(), table.has("position") ? "both position and direction" : "a light without place",
                     "one of position and direction");
  }
  if (table.has("position")) return {table.vector("position", -kWorld, kWorld), false};
  const Vec3 towards = table.vector("direction", -kWorld, kWorld);
  if (length(towards) < 1e-9) throw InputError(table.place("direction"), "direction = 0", "the way to the light");
  return {normalize(towards), true};
}

// Legal, and as the program can find it from anywhere.
std::string read_config(const TomlTable& table, const std::filesystem::path& folder, const std::string& standard) {
  if (!table.has("config")) return standard;
  const std::string name = table.string("config");
  const bool is_file = name.find('/') != std::string::npos || name.ends_with(".toml");
  try {
    load_config(name, folder);
  } catch (const InputError& error) {
    throw InputError(table.place("config"), std::string("in config: ") + error.what());
  }
  return is_file ? (folder / name).string() : name;
}

}  // namespace

Scene read_toml_scene(const std::filesystem::path& path, Notes& notes) {
  const std::string file = path.string();
  const toml::table parsed = parse_toml_file(file);
  const TomlTable table(file, parsed, "the scene",
                        {"name", "config", "size", "background", "camera", "light", "viewer", "objects"});
  Scene scene;
  scene.name = table.string("name", path.stem().string());
  const std::vector<std::int64_t> size = table.integers("size", 2, 1, 4096, std::vector<std::int64_t>{512, 512});
  scene.width = static_cast<int>(size[0]);
  scene.height = static_cast<int>(size[1]);
  scene.background = table.vector("background", 0, 1, Vec3{});
  bool decal = false;
  for (const toml::table* object : table.tables("objects", kMaximumObjects)) {
    std::vector<Object> read = read_toml_objects(file, *object, notes, decal);
    std::move(read.begin(), read.end(), std::back_inserter(scene.objects));
    check_size(scene.objects, place_of(file, *object));
  }
  const Bounds bounds = bounds_of(scene.objects);
  const toml::table* camera = table.table("camera");
  scene.camera = camera != nullptr ? read_camera(file, *camera, bounds) : framing_camera(bounds);
  const toml::table* light = table.table("light");
  scene.light = light != nullptr ? read_light(file, *light) : default_light(scene.camera);
  scene.viewer_at_infinity = table.choice("viewer", {"local", "infinite"}, scene.camera.perspective ? 0 : 1) == 1;
  scene.config = read_config(table, path.parent_path(), fitting_config(decal, scene.camera.perspective));
  return scene;
}

}  // namespace wrinkle

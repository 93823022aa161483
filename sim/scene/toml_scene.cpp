#include <algorithm>
#include <charconv>
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

constexpr double kWorld = kMaximumCoordinate;  // of cameras and lights

Camera read_camera(const std::string& file, const toml::table& source, const Bounds& bounds) {
  const TomlTable table(file, source, "camera", {"type", "eye", "target", "up", "height", "fov", "near", "far"});
  Camera camera;
  camera.perspective = table.choice("type", {"orthographic", "perspective"}) == 1;
  const Vec3 eye = table.vector("eye", -kWorld, kWorld);
  const Vec3 target = table.vector("target", -kWorld, kWorld, Vec3{});
  const Vec3 up = table.vector("up", -kWorld, kWorld, Vec3{0, 1, 0});
  if (eye == target) throw InputError(table.place("eye"), "eye = target", "two places");
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
                                          : 0.5 * table.number("height", 1e-12, kWorld, 2.02 * bounds.radius());
  const double distance = -transform_point(camera.world_to_eye, bounds.centre()).z;
  const double radius = 1.01 * (bounds.radius() > 0 ? bounds.radius() : 1);
  const double standard_near =
      camera.perspective ? std::max(distance - radius, 1e-3 * (distance + radius)) : distance - radius;
  camera.near = table.number("near", camera.perspective ? 1e-12 : -kWorld, kWorld, standard_near);
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
  if (towards == Vec3{}) throw InputError(table.place("direction"), "direction = 0", "the way to the light");
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

// A table written on the command line, with or without braces.
toml::table parse_option(const std::string& option, const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  const bool braces = first != std::string::npos && text[first] == '{';
  try {
    return *toml::parse("t = " + (braces ? text : "{" + text + "}"))["t"].as_table();
  } catch (const toml::parse_error& error) {
    throw InputError(Place{option + " '" + shortened(text) + "'"}, std::string(error.description()));
  }
}

double parse_number(const std::string& option, const std::string& text, double minimum, double maximum) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) throw InputError(Place{option}, "\"" + text + "\"", "a number");
  return checked_number(value, minimum, maximum, option, Place{option});
}

Vec3 parse_background(const std::string& text) {
  std::vector<double> c;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    c.push_back(parse_number("--background", text.substr(at, end - at), 0, 1));
    at = end + 1;
  }
  if (c.size() != 1 && c.size() != 3) {
    throw InputError(Place{"--background"}, std::to_string(c.size()) + " numbers", "R,G,B or one grey, in [0, 1]");
  }
  return c.size() == 1 ? Vec3{c[0], c[0], c[0]} : Vec3{c[0], c[1], c[2]};
}

// Brighter light is the same as materials that give more of it back, up to all.
void expose(double factor, Scene& scene, Notes& notes) {
  bool limited = false;
  for (Object& object : scene.objects) {
    for (Vec3* colour : {&object.material.ambient, &object.material.diffuse, &object.material.specular}) {
      *colour = factor * *colour;
      limited = limited || std::max({colour->x, colour->y, colour->z}) > 1;
      *colour = {std::min(colour->x, 1.0), std::min(colour->y, 1.0), std::min(colour->z, 1.0)};
    }
  }
  if (limited) notes.push_back("--exposure: materials whose colours come to more than 1 are drawn with 1");
}

}  // namespace

void apply_overrides(const SceneOverrides& overrides, Scene& scene, Notes& notes) {
  if (!overrides.camera.empty()) {
    toml::table camera = parse_option("--camera", overrides.camera);
    if (!camera.contains("type")) camera.insert("type", camera.contains("height") ? "orthographic" : "perspective");
    scene.camera = read_camera("--camera", camera, bounds_of(scene.objects));
    scene.viewer_at_infinity = !scene.camera.perspective;
  }
  if (!overrides.light.empty()) scene.light = read_light("--light", parse_option("--light", overrides.light));
  if (!overrides.background.empty()) scene.background = parse_background(overrides.background);
  if (!overrides.exposure.empty()) {
    expose(parse_number("--exposure", overrides.exposure, 1e-6, 1e6), scene, notes);
  }
}

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
  Maps maps;
  for (const toml::table* object : table.tables("objects", kMaximumObjects)) {
    std::vector<Object> read = read_toml_objects(file, *object, notes, maps);
    std::move(read.begin(), read.end(), std::back_inserter(scene.objects));
    check_size(scene.objects, place_of(file, *object));
  }
  const Bounds bounds = bounds_of(scene.objects);
  const toml::table* camera = table.table("camera");
  scene.camera = camera != nullptr ? read_camera(file, *camera, bounds) : framing_camera(bounds);
  const toml::table* light = table.table("light");
  scene.light = light != nullptr ? read_light(file, *light) : default_light(scene.camera);
  scene.viewer_at_infinity = table.choice("viewer", {"local", "infinite"}, scene.camera.perspective ? 0 : 1) == 1;
  scene.config = read_config(table, path.parent_path(), fitting_config(maps, scene.camera.perspective));
  return scene;
}

}  // namespace wrinkle

#include <algorithm>
#include <cmath>
#include <numbers>

#include "golden/vertex/camera.h"
#include "golden/vertex/transform.h"
#include "sim/scene/gltf_parts.h"
#include "sim/scene/toml_table.h"

namespace wrinkle {
namespace {

// The world-to-eye matrix of a node: its place and axes; scale is no part of a camera.
Mat4 world_to_eye(const GltfFile& file, const GltfInstance& instance) {
  const Vec3 eye = transform_point(instance.to_world, {});
  const Vec3 back = transform_direction(instance.to_world, {0, 0, 1});
  const Vec3 up = transform_direction(instance.to_world, {0, 1, 0});
  if (!(length(cross(normalize(up), normalize(back))) > 1e-6)) {
    throw InputError(file.place(instance.pointer), "a camera scaled to nothing", "a node with an invertible matrix");
  }
  const Vec3 z = normalize(back);
  return look_at(eye, eye - z, up);
}

// Rows of 512 pixels, columns by the shape of the camera's picture.
void set_size(PictureSize& size, double aspect) {
  size.height = 512;
  size.width = std::clamp(static_cast<int>(std::lround(512 * aspect)), 64, 1024);
}

}  // namespace

Camera read_gltf_camera(const GltfFile& file, const GltfInstance& instance, const Bounds& bounds, PictureSize& size) {
  const std::string pointer = "/cameras/" + std::to_string(instance.index);
  const tinygltf::Camera& source = file.model.cameras[static_cast<std::size_t>(instance.index)];
  const auto number = [&](double value, double minimum, double maximum, const std::string& key) {
    return checked_number(value, minimum, maximum, key, file.place(pointer + "/" + source.type));
  };
  Camera camera;
  camera.world_to_eye = world_to_eye(file, instance);
  const Vec3 centre = transform_point(camera.world_to_eye, bounds.centre());
  const double beyond = -centre.z + 1.01 * bounds.radius();  // where the farthest point may be
  if (source.type == "perspective") {
    camera.perspective = true;
    camera.half_height = std::tan(0.5 * number(source.perspective.yfov, 1e-3, std::numbers::pi - 1e-3, "yfov"));
    camera.near = number(source.perspective.znear, 1e-9, kMaximumCoordinate, "znear");
    const double far = source.perspective.zfar;  // 0: not there, infinite
    camera.far = far != 0 ? number(far, camera.near, kMaximumCoordinate, "zfar") : std::max(beyond, 2 * camera.near);
    const double aspect = source.perspective.aspectRatio;
    set_size(size, aspect != 0 ? number(aspect, 0.01, 100, "aspectRatio") : 1);
  } else if (source.type == "orthographic") {
    camera.half_height = number(source.orthographic.ymag, 1e-9, kMaximumCoordinate, "ymag");
    camera.near = number(source.orthographic.znear, 0, kMaximumCoordinate, "znear");
    camera.far = number(source.orthographic.zfar, camera.near, kMaximumCoordinate, "zfar");
    set_size(size, number(source.orthographic.xmag, 1e-9, kMaximumCoordinate, "xmag") / camera.half_height);
  } else {
    throw InputError(file.place(pointer + "/type"), "\"" + source.type + "\"", "\"perspective\" or \"orthographic\"");
  }
  if (!(camera.far > camera.near)) throw InputError(file.place(pointer), "zfar not beyond znear", "zfar > znear");
  return camera;
}

std::optional<Light> read_gltf_light(const GltfFile& file, const GltfNodes& nodes, Notes& notes) {
  const GltfInstance* strongest = nullptr;
  double most = -1;
  for (const GltfInstance& instance : nodes.lights) {
    const tinygltf::Light& light = file.model.lights[static_cast<std::size_t>(instance.index)];
    const std::string pointer = "/extensions/KHR_lights_punctual/lights/" + std::to_string(instance.index);
    if (light.type != "directional" && light.type != "point" && light.type != "spot") {
      throw InputError(file.place(pointer + "/type"), "\"" + light.type + "\"",
                       "\"directional\", \"point\" or \"spot\"");
    }
    const double intensity = checked_number(light.intensity, 0, 1e12, "intensity", file.place(pointer));
    if (intensity > most) {
      most = intensity;
      strongest = &instance;
    }
  }
  if (strongest == nullptr) return std::nullopt;
  const tinygltf::Light& light = file.model.lights[static_cast<std::size_t>(strongest->index)];
  if (nodes.lights.size() > 1) {
    notes.push_back(file.path.string() + ": of " + std::to_string(nodes.lights.size()) +
                    " lights only the strongest, " + strongest->pointer + ", is used");
  }
  if (light.type == "spot") notes.push_back(file.path.string() + ": the spot light shines in all directions");
  if (light.type != "directional") return Light{transform_point(strongest->to_world, {}), false};
  const Vec3 towards = transform_direction(strongest->to_world, {0, 0, 1});  // it shines along the node's -z
  if (length(towards) == 0)
    throw InputError(file.place(strongest->pointer), "a light scaled to nothing", "a direction");
  return Light{normalize(towards), true};
}

}  // namespace wrinkle

// The parts that a glTF scene is read by.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "golden/vertex/scene.h"
#include "sim/scene/defaults.h"
#include "sim/scene/gltf_file.h"
#include "sim/scene/model.h"
#include "sim/scene/notes.h"

namespace wrinkle {

// Texture coordinates scaled, turned and moved (KHR_texture_transform).
struct UvTransform {
  Vec2 offset, scale{1, 1};
  double rotation = 0;  // radians, counter-clockwise as the image is seen

  bool operator==(const UvTransform&) const = default;
  Vec2 operator()(Vec2 uv) const;
};

// A material as objects carry it. Where there is a normal, base or gloss texture, `texture` holds them all.
struct GltfMaterial {
  Material material;
  std::shared_ptr<const ExactTexture> texture;
  bool bump = false;
  Maps maps;
  int uv_set = 0;
  UvTransform uv_transform;
  Wrap wrap_u = Wrap::kRepeat, wrap_v = Wrap::kRepeat;
  bool double_sided = false;
};

// Material `index`, or glTF's default for -1. `pointer` is who refers to it.
GltfMaterial read_gltf_material(const GltfFile& file, int index, const std::string& pointer, PassedOver& passed_over,
                                Notes& notes);

// A primitive of triangles; nothing for points and lines. Normals that are not there are flat, tangents that are not
// there MikkTSpace's; a material without textures needs no tangents.
std::optional<Mesh> read_gltf_primitive(const GltfFile& file, int mesh, int primitive, const GltfMaterial& material,
                                        PassedOver& passed_over, Notes& notes);

// What the nodes of the scene hang in the world.
struct GltfInstance {
  int index = 0;  // of the mesh, camera or light
  Mat4 to_world;
  std::string name;
  std::string pointer;
};
struct GltfNodes {
  std::vector<GltfInstance> meshes, cameras, lights;
};
GltfNodes read_gltf_nodes(const GltfFile& file, Notes& notes);

Camera read_gltf_camera(const GltfFile& file, const GltfInstance& instance, const Bounds& bounds, PictureSize& size);
// The strongest light; the others are noted.
std::optional<Light> read_gltf_light(const GltfFile& file, const GltfNodes& nodes, Notes& notes);

}  // namespace wrinkle

#include <iterator>
#include <map>

#include "golden/vertex/transform.h"
#include "sim/scene/colours.h"
#include "sim/scene/gltf_parts.h"
#include "sim/scene/model.h"

namespace wrinkle {
namespace {

// Materials and meshes are read once, however many nodes show them.
class GltfObjects {
 public:
  GltfObjects(const GltfFile& file, Notes& notes) : file_(file), notes_(notes) {}

  void add(const GltfInstance& instance, std::vector<Object>& objects) {
    const tinygltf::Mesh& mesh = file_.model.meshes[static_cast<std::size_t>(instance.index)];
    for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
      const std::string pointer =
          "/meshes/" + std::to_string(instance.index) + "/primitives/" + std::to_string(p) + "/material";
      const GltfMaterial& material = material_of(mesh.primitives[p].material, pointer);
      const std::optional<Mesh>& read = mesh_of(instance.index, static_cast<int>(p), material);
      if (!read) continue;
      Object object;
      object.name = instance.name.empty() ? mesh.name : instance.name;
      object.mesh = *read;
      object.to_world = instance.to_world;
      object.space = material.bump ? ShadingSpace::kTangent : ShadingSpace::kWorld;
      object.material = material.material;
      object.texture = material.texture;
      object.wrap_u = material.wrap_u;
      object.wrap_v = material.wrap_v;
      object.double_sided = material.double_sided;
      maps_ = maps_ | material.maps;
      if (mesh.primitives[p].attributes.contains("COLOR_0")) {
        std::vector<Object> coloured = split_by_colour(std::move(object), file_.place(instance.pointer), notes_);
        std::move(coloured.begin(), coloured.end(), std::back_inserter(objects));
      } else {
        objects.push_back(std::move(object));
      }
      check_size(objects, file_.place(""));
    }
  }

  const Maps& maps() const { return maps_; }
  const PassedOver& passed_over() const { return passed_over_; }

 private:
  const GltfMaterial& material_of(int index, const std::string& pointer) {
    const auto found = materials_.find(index);
    if (found != materials_.end()) return found->second;
    return materials_.emplace(index, read_gltf_material(file_, index, pointer, passed_over_, notes_)).first->second;
  }

  const std::optional<Mesh>& mesh_of(int mesh, int primitive, const GltfMaterial& material) {
    const auto found = meshes_.find({mesh, primitive});
    if (found != meshes_.end()) return found->second;
    return meshes_
        .emplace(std::pair{mesh, primitive},
                 read_gltf_primitive(file_, mesh, primitive, material, passed_over_, notes_))
        .first->second;
  }

  const GltfFile& file_;
  Notes& notes_;
  PassedOver passed_over_;
  std::map<int, GltfMaterial> materials_;
  std::map<std::pair<int, int>, std::optional<Mesh>> meshes_;
  Maps maps_;
};

}  // namespace

Model read_gltf_model(const std::filesystem::path& path, Notes& notes) {
  const GltfFile file = load_gltf(path, notes);
  const GltfNodes nodes = read_gltf_nodes(file, notes);
  Model model;
  GltfObjects reader(file, notes);
  for (const GltfInstance& instance : nodes.meshes) {
    if (determinant3(instance.to_world) == 0) {
      notes.push_back(file.place(instance.pointer).text() + ": scaled to nothing, not drawn");
      continue;
    }
    reader.add(instance, model.objects);
  }
  if (model.objects.empty()) throw InputError(file.place(""), "no triangles in the scene", "at least one mesh");
  reader.passed_over().add_to(notes);
  if (!file.model.animations.empty()) {
    notes.push_back(file.place("/animations").text() + ": animations are not applied");
  }
  model.maps = reader.maps();
  const Bounds bounds = bounds_of(model.objects);
  if (!nodes.cameras.empty()) {
    model.camera = read_gltf_camera(file, nodes.cameras.front(), bounds, model.size);
    if (nodes.cameras.size() > 1) notes.push_back(path.string() + ": only the first of several cameras is used");
  }
  model.light = read_gltf_light(file, nodes, notes);
  return model;
}

}  // namespace wrinkle

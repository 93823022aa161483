#include <algorithm>

#include "golden/vertex/tessellate.h"
#include "sim/scene/gltf_parts.h"
#include "sim/scene/normals.h"

namespace wrinkle {
namespace {

// Triangles from the corners of a list, strip or fan; those of a strip keep their winding.
std::vector<std::array<std::uint32_t, 3>> assemble_triangles(const std::vector<std::uint32_t>& corners, int mode) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const std::size_t n = corners.size();
  if (mode == TINYGLTF_MODE_TRIANGLES) {
    for (std::size_t i = 0; i + 2 < n; i += 3) triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
  } else if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
    for (std::size_t i = 0; i + 2 < n; ++i) {
      const std::size_t odd = i % 2;
      triangles.push_back({corners[i], corners[i + 1 + odd], corners[i + 2 - odd]});
    }
  } else {
    for (std::size_t i = 1; i + 1 < n; ++i) triangles.push_back({corners[i], corners[i + 1], corners[0]});
  }
  return triangles;
}

class PrimitiveReader {
 public:
  PrimitiveReader(const GltfFile& file, const tinygltf::Primitive& primitive, std::string pointer)
      : file_(file), primitive_(primitive), pointer_(std::move(pointer)) {}

  bool has(const std::string& attribute) const { return primitive_.attributes.contains(attribute); }

  // Attributes that change the picture and are not read.
  void note_attributes(int uv_set, PassedOver& passed_over) const {
    for (const auto& [name, accessor] : primitive_.attributes) {
      const Place place = file_.place(pointer_ + "/attributes/" + name.substr(0, 80));
      if (name.starts_with("JOINTS_") || name.starts_with("WEIGHTS_")) {
        passed_over.see("skins are not applied; the mesh is drawn in its rest pose", place);
      } else if (name.starts_with("COLOR_") && name != "COLOR_0") {
        passed_over.see(name.substr(0, 80) + " is not applied", place);
      }
    }
    if (!primitive_.targets.empty()) {
      passed_over.see("morph targets are not applied", file_.place(pointer_ + "/targets"));
    }
    if (uv_set > 0 && has("TEXCOORD_0")) {
      passed_over.see("of several texture coordinates TEXCOORD_" + std::to_string(uv_set) + " alone is used",
                      file_.place(pointer_ + "/attributes"));
    }
  }

  void read_positions(Mesh& mesh) const {
    if (!has("POSITION")) throw InputError(file_.place(pointer_ + "/attributes"), "no POSITION", "one");
    const AccessorData data = read("POSITION", 3);
    mesh.vertices.resize(data.count);
    for (std::size_t i = 0; i < data.count; ++i) mesh.vertices[i].P = {data.at(i, 0), data.at(i, 1), data.at(i, 2)};
  }

  void read_normals(Mesh& mesh) const {
    const AccessorData data = read_for("NORMAL", 3, mesh);
    for (std::size_t i = 0; i < data.count; ++i) {
      mesh.vertices[i].N = normalize(Vec3{data.at(i, 0), data.at(i, 1), data.at(i, 2)});
    }
  }

  void read_uv(Mesh& mesh, const std::string& attribute, const UvTransform& transform) const {
    const AccessorData data = read_for(attribute, 2, mesh);
    for (std::size_t i = 0; i < data.count; ++i) mesh.vertices[i].uv = transform(Vec2{data.at(i, 0), data.at(i, 1)});
  }

  // Made orthogonal to N, which interpolation in the exporter may have spoilt. Marks those that have a direction and a
  // side; the others are left for the texture coordinates to say.
  std::vector<bool> read_tangents(Mesh& mesh) const {
    const AccessorData data = read_for("TANGENT", 4, mesh);
    std::vector<bool> usable(data.count);
    for (std::size_t i = 0; i < data.count; ++i) {
      Vertex& vertex = mesh.vertices[i];
      const Vec3 T = normalize(Vec3{data.at(i, 0), data.at(i, 1), data.at(i, 2)});
      usable[i] = length(T - dot(T, vertex.N) * vertex.N) > 1e-6 && data.at(i, 3) != 0;
      if (!usable[i]) continue;
      vertex.T = perpendicular(vertex.N, T);
      vertex.sign = data.at(i, 3) < 0 ? -1 : 1;
    }
    return usable;
  }

  // Three or four components; opacity is none of the colour.
  void read_colours(Mesh& mesh) const {
    const std::string attribute = "COLOR_0";
    const int accessor = primitive_.attributes.at(attribute);
    const bool known = accessor >= 0 && static_cast<std::size_t>(accessor) < file_.model.accessors.size();
    const bool opacity = known && file_.model.accessors[static_cast<std::size_t>(accessor)].type == TINYGLTF_TYPE_VEC4;
    const AccessorData data = read_for(attribute, opacity ? 4 : 3, mesh);
    const auto at = [&](std::size_t i, int c) { return std::clamp(data.at(i, c), 0.0, 1.0); };
    for (std::size_t i = 0; i < data.count; ++i) mesh.vertices[i].colour = {at(i, 0), at(i, 1), at(i, 2)};
  }

  std::vector<std::uint32_t> corners(const Mesh& mesh) const {
    if (primitive_.indices != -1) {
      return read_indices(file_, primitive_.indices, mesh.vertices.size(), pointer_ + "/indices");
    }
    std::vector<std::uint32_t> all(mesh.vertices.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint32_t>(i);
    return all;
  }

 private:
  AccessorData read(const std::string& attribute, int components) const {
    return read_accessor(file_, primitive_.attributes.at(attribute), components, pointer_ + "/attributes/" + attribute);
  }
  AccessorData read_for(const std::string& attribute, int components, const Mesh& mesh) const {
    AccessorData data = read(attribute, components);
    if (data.count == mesh.vertices.size()) return data;
    throw InputError(file_.place(pointer_ + "/attributes/" + attribute), std::to_string(data.count) + " elements",
                     std::to_string(mesh.vertices.size()) + ", as many as positions");
  }

  const GltfFile& file_;
  const tinygltf::Primitive& primitive_;
  std::string pointer_;
};

}  // namespace

std::optional<Mesh> read_gltf_primitive(const GltfFile& file, int mesh_index, int primitive_index,
                                        const GltfMaterial& material, PassedOver& passed_over, Notes& notes) {
  const tinygltf::Mesh& source = file.model.meshes[static_cast<std::size_t>(mesh_index)];
  const tinygltf::Primitive& primitive = source.primitives[static_cast<std::size_t>(primitive_index)];
  const std::string pointer =
      "/meshes/" + std::to_string(mesh_index) + "/primitives/" + std::to_string(primitive_index);
  const int mode = primitive.mode == -1 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
  if (mode < 0 || mode > TINYGLTF_MODE_TRIANGLE_FAN) {
    throw InputError(file.place(pointer + "/mode"), std::to_string(mode), "0 to 6");
  }
  if (mode < TINYGLTF_MODE_TRIANGLES) {
    passed_over.see("points and lines are not drawn", file.place(pointer));
    return std::nullopt;
  }
  const PrimitiveReader reader(file, primitive, pointer);
  reader.note_attributes(material.uv_set, passed_over);
  Mesh mesh;
  mesh.name = source.name;
  reader.read_positions(mesh);
  const std::string uv_set = "TEXCOORD_" + std::to_string(material.uv_set);
  if (material.texture != nullptr && !reader.has(uv_set)) {
    throw InputError(file.place(pointer + "/attributes"), "no " + uv_set, "one, for the material has a texture");
  }
  if (reader.has(uv_set)) reader.read_uv(mesh, uv_set, material.uv_transform);
  if (reader.has("COLOR_0")) reader.read_colours(mesh);
  const std::vector<std::uint32_t> corners = reader.corners(mesh);
  mesh.triangles = assemble_triangles(corners, mode);
  if (mode == TINYGLTF_MODE_TRIANGLES && corners.size() % 3 != 0) {
    throw InputError(file.place(pointer), std::to_string(corners.size()) + " corners", "a multiple of 3");
  }
  const bool own_normals = reader.has("NORMAL");
  if (own_normals) {
    reader.read_normals(mesh);
    replace_normals_of_no_length(mesh, file.place(pointer + "/attributes/NORMAL"), notes);
  }
  if (!own_normals) flat_normals(mesh);
  // Without normals a file's tangents are to be ignored (glTF 2.0, section 3.7.2.1).
  std::vector<bool> usable;
  if (own_normals && reader.has("TANGENT")) usable = reader.read_tangents(mesh);
  const auto unusable = std::ranges::count(usable, false);
  if (!material.bump || (!usable.empty() && unusable == 0)) return mesh;
  if (unusable > 0) {
    notes.push_back(file.place(pointer + "/attributes/TANGENT").text() + ": " + std::to_string(unusable) +
                    " tangents of no length, along the normal or without a side are replaced by those of the texture "
                    "coordinates");
  }
  add_noted_tangents(mesh, usable, file.place(pointer), notes);
  return mesh;
}

}  // namespace wrinkle

#include <algorithm>

#include "golden/vertex/tangents.h"
#include "golden/vertex/tessellate.h"
#include "sim/scene/gltf_parts.h"

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

  void read_uv(Mesh& mesh, const std::string& attribute) const {
    const AccessorData data = read_for(attribute, 2, mesh);
    for (std::size_t i = 0; i < data.count; ++i) mesh.vertices[i].uv = {data.at(i, 0), data.at(i, 1)};
  }

  // Made orthogonal to N, which interpolation in the exporter may have spoilt.
  void read_tangents(Mesh& mesh) const {
    const AccessorData data = read_for("TANGENT", 4, mesh);
    for (std::size_t i = 0; i < data.count; ++i) {
      Vertex& vertex = mesh.vertices[i];
      const Vec3 T{data.at(i, 0), data.at(i, 1), data.at(i, 2)};
      vertex.T = perpendicular(vertex.N, T);
      vertex.sign = data.at(i, 3) < 0 ? -1 : 1;
    }
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
                                        const GltfMaterial& material, Notes& notes) {
  const tinygltf::Mesh& source = file.model.meshes[static_cast<std::size_t>(mesh_index)];
  const tinygltf::Primitive& primitive = source.primitives[static_cast<std::size_t>(primitive_index)];
  const std::string pointer =
      "/meshes/" + std::to_string(mesh_index) + "/primitives/" + std::to_string(primitive_index);
  const int mode = primitive.mode == -1 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
  if (mode < 0 || mode > TINYGLTF_MODE_TRIANGLE_FAN) {
    throw InputError(file.place(pointer + "/mode"), std::to_string(mode), "0 to 6");
  }
  if (mode < TINYGLTF_MODE_TRIANGLES) {
    notes.push_back(file.place(pointer).text() + ": points and lines are not drawn");
    return std::nullopt;
  }
  const PrimitiveReader reader(file, primitive, pointer);
  Mesh mesh;
  mesh.name = source.name;
  reader.read_positions(mesh);
  const std::string uv_set = "TEXCOORD_" + std::to_string(material.uv_set);
  if (material.texture != nullptr && !reader.has(uv_set)) {
    throw InputError(file.place(pointer + "/attributes"), "no " + uv_set, "one, for the material has a texture");
  }
  if (reader.has(uv_set)) reader.read_uv(mesh, uv_set);
  const std::vector<std::uint32_t> corners = reader.corners(mesh);
  mesh.triangles = assemble_triangles(corners, mode);
  if (mode == TINYGLTF_MODE_TRIANGLES && corners.size() % 3 != 0) {
    throw InputError(file.place(pointer), std::to_string(corners.size()) + " corners", "a multiple of 3");
  }
  const bool own_normals = reader.has("NORMAL");
  if (own_normals) reader.read_normals(mesh);
  if (!own_normals) flat_normals(mesh);
  // Without normals a file's tangents are to be ignored (glTF 2.0, section 3.7.2.1).
  if (own_normals && reader.has("TANGENT")) {
    reader.read_tangents(mesh);
  } else if (material.bump) {
    add_tangents(mesh);
  }
  return mesh;
}

}  // namespace wrinkle

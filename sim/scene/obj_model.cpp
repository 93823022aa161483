#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include "golden/vertex/tangents.h"
#include "golden/vertex/tessellate.h"
#include "sim/scene/defaults.h"
#include "sim/scene/files.h"
#include "sim/scene/model.h"
#include "sim/scene/obj_check.h"
#include "sim/scene/textures.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

constexpr double kAmbientLight = 0.1;
// A height map's full scale, in repeats of the texture, at -bm 1.
constexpr double kHeightOfBumpMap = 1.0 / 32;

struct ObjMaterial {
  Material material;
  std::shared_ptr<const ExactTexture> texture;
  bool bump = false, decal = false;
  Wrap wrap = Wrap::kRepeat;
};

Vec3 clamped(const tinyobj::real_t (&c)[3]) {
  return {std::clamp(c[0], 0.0, 1.0), std::clamp(c[1], 0.0, 1.0), std::clamp(c[2], 0.0, 1.0)};
}

void note_options(const tinyobj::texture_option_t& option, const std::string& name, const Place& place, Notes& notes) {
  const auto are = [](const tinyobj::real_t(&v)[3], double value) { return std::ranges::count(v, value) == 3; };
  if (are(option.origin_offset, 0) && are(option.scale, 1) && are(option.turbulence, 0)) return;
  notes.push_back(place.text() + ": -o, -s and -t of \"" + name + "\" are not applied");
}

// `norm` is a normal map; `bump` a height map, by Eq. 8-11, unless its image is plainly one of normals.
MipChain read_bump(const tinyobj::material_t& source, const fs::path& folder, const Place& place, Notes& notes) {
  const bool norm = !source.normal_texname.empty();
  const std::string& name = norm ? source.normal_texname : source.bump_texname;
  const tinyobj::texture_option_t& option = norm ? source.normal_texopt : source.bump_texopt;
  note_options(option, name, place, notes);
  const Image image = read_image(find_file(folder, name, place));
  if (norm) return normals_of(image, option.bump_multiplier);
  if (looks_like_normal_map(image)) {
    notes.push_back(place.text() + ": \"" + name + "\" holds normals and is taken as such");
    return normals_of(image, option.bump_multiplier);
  }
  const Grid<double> height = regular_heights(heights_of(image, option.bump_multiplier * kHeightOfBumpMap));
  return normals_from_heights(height, 1.0, MipMethod::kHeights);
}

ObjMaterial convert(const tinyobj::material_t& source, const fs::path& folder, const std::string& file, Notes& notes) {
  const Place place{file, 0, 0, "material \"" + source.name + "\""};
  ObjMaterial material;
  material.material.diffuse = clamped(source.diffuse);
  const Vec3 ambient = clamped(source.ambient);
  material.material.ambient = kAmbientLight * (ambient == Vec3{} ? material.material.diffuse : ambient);
  material.material.specular = clamped(source.specular);
  const double exponent = std::max(source.shininess, 1.0);
  material.material.exponent = 1 << std::clamp(static_cast<int>(std::lround(std::log2(exponent))), 0, 8);
  material.bump = !source.normal_texname.empty() || !source.bump_texname.empty();
  material.decal = !source.diffuse_texname.empty();
  const auto& wrap_option = material.bump ? (source.normal_texname.empty() ? source.bump_texopt : source.normal_texopt)
                                          : source.diffuse_texopt;
  if (wrap_option.clamp) material.wrap = Wrap::kClamp;
  MipChain normals;
  std::optional<Image> decal;
  if (material.bump) normals = read_bump(source, folder, place, notes);
  if (material.decal) {
    note_options(source.diffuse_texopt, source.diffuse_texname, place, notes);
    decal = read_image(find_file(folder, source.diffuse_texname, place));
  }
  if (material.bump || material.decal) material.texture = make_texture(normals, decal);
  return material;
}

// The faces of one shape that have one material.
struct Part {
  Mesh mesh;
  std::map<std::array<int, 3>, std::uint32_t> vertex_of;
  bool all_normals = true, all_uvs = true, all_smooth = true;
};

std::uint32_t vertex(Part& part, const tinyobj::attrib_t& attributes, const tinyobj::index_t& index) {
  const auto [entry, is_new] =
      part.vertex_of.try_emplace({index.vertex_index, index.texcoord_index, index.normal_index},
                                 static_cast<std::uint32_t>(part.mesh.vertices.size()));
  if (!is_new) return entry->second;
  const auto triple = [](const std::vector<tinyobj::real_t>& v, int i) {
    const auto at = 3 * static_cast<std::size_t>(i);
    return Vec3{v[at], v[at + 1], v[at + 2]};
  };
  Vertex v;
  v.P = triple(attributes.vertices, index.vertex_index);
  if (index.normal_index >= 0) v.N = normalize(triple(attributes.normals, index.normal_index));
  if (index.texcoord_index >= 0) {
    const auto at = 2 * static_cast<std::size_t>(index.texcoord_index);
    v.uv = {attributes.texcoords[at], 1 - attributes.texcoords[at + 1]};  // OBJ's v goes up the image
  }
  part.all_normals = part.all_normals && index.normal_index >= 0;
  part.all_uvs = part.all_uvs && index.texcoord_index >= 0;
  part.mesh.vertices.push_back(v);
  return entry->second;
}

// Parts by material, -1 for none.
std::map<int, Part> parts_of(const tinyobj::shape_t& shape, const tinyobj::attrib_t& attributes) {
  std::map<int, Part> parts;
  const tinyobj::mesh_t& mesh = shape.mesh;
  for (std::size_t face = 0; face < mesh.num_face_vertices.size(); ++face) {
    Part& part = parts[mesh.material_ids[face]];
    const tinyobj::index_t* corner = &mesh.indices[3 * face];
    part.mesh.triangles.push_back({vertex(part, attributes, corner[0]), vertex(part, attributes, corner[1]),
                                   vertex(part, attributes, corner[2])});
    part.all_smooth = part.all_smooth && mesh.smoothing_group_ids[face] != 0;
  }
  return parts;
}

Object object_of(Part part, const std::string& name, const ObjMaterial& material, const Place& place, Notes& notes) {
  Object object;
  object.name = name;
  object.mesh = std::move(part.mesh);
  object.mesh.name = name;
  object.material = material.material;
  object.wrap_u = object.wrap_v = material.wrap;
  if (!part.all_normals && part.all_smooth) smooth_normals(object.mesh);
  if (!part.all_normals && !part.all_smooth) flat_normals(object.mesh);
  if (material.texture && !part.all_uvs) {
    notes.push_back(place.text() + ": \"" + name +
                    "\" has corners without texture coordinates and is drawn without texture");
    return object;
  }
  object.texture = material.texture;
  if (material.bump) {
    object.space = ShadingSpace::kTangent;
    add_tangents(object.mesh);
  }
  return object;
}

// The text of all material libraries; one that is not there is noted, as other readers do.
std::string read_libraries(const std::string& obj, const fs::path& path, Notes& notes) {
  std::string text;
  for (const std::string& name : material_libraries(obj)) {
    const fs::path library = path.parent_path() / name;
    std::error_code error;
    if (!fs::exists(library, error)) {
      notes.push_back(path.string() + ": no material library \"" + name + "\"; its materials are the default");
      continue;
    }
    const std::string mtl = read_file(library);
    check_mtl(library.string(), mtl);
    text += mtl + "\n";
  }
  return text;
}

}  // namespace

Model read_obj_model(const fs::path& path, Notes& notes) {
  const Place place{path.string(), 0, 0, {}};
  const std::string text = read_file(path);
  if (check_obj(path.string(), text).triangles == 0) throw InputError(place, "no faces", "at least one");
  tinyobj::ObjReaderConfig config;
  config.vertex_color = false;
  tinyobj::ObjReader reader;
  if (!reader.ParseFromString(text, read_libraries(text, path, notes), config)) {
    std::string error = reader.Error();
    std::replace(error.begin(), error.end(), '\n', ' ');
    throw InputError(place, "no sound OBJ (" + error + ")", "Wavefront OBJ");
  }
  Model model;
  std::map<int, ObjMaterial> materials;
  for (const tinyobj::shape_t& shape : reader.GetShapes()) {
    for (auto& [id, part] : parts_of(shape, reader.GetAttrib())) {
      if (!materials.contains(id)) {
        materials[id] = id < 0 ? ObjMaterial{}
                               : convert(reader.GetMaterials()[static_cast<std::size_t>(id)], path.parent_path(),
                                         path.string(), notes);
      }
      model.objects.push_back(object_of(std::move(part), shape.name, materials[id], place, notes));
      model.decal = model.decal || (materials[id].decal && model.objects.back().texture);
    }
  }
  if (model.objects.empty()) throw InputError(place, "no faces with area", "at least one");
  check_size(model.objects, place);
  return model;
}

}  // namespace wrinkle

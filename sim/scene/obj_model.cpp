#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <tuple>

#include "sim/scene/colours.h"
#include "sim/scene/defaults.h"
#include "sim/scene/files.h"
#include "sim/scene/model.h"
#include "sim/scene/mtl_file.h"
#include "sim/scene/normals.h"
#include "sim/scene/obj_file.h"
#include "sim/scene/polygon.h"
#include "sim/scene/textures.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

constexpr double kAmbientLight = 0.1;
// A height map's full scale, in repeats of the texture, at -bm 1.
constexpr double kHeightOfBumpMap = 1.0 / 32;
// What a material that says nothing of Kd is lit with.
constexpr Vec3 kStandardDiffuse{0.6, 0.6, 0.6};

struct ObjMaterial {
  Material material;
  std::shared_ptr<const ExactTexture> texture;
  bool bump = false;
  Maps maps;
  Wrap wrap = Wrap::kRepeat;
  Vec2 offset, scale{1, 1};  // of texture coordinates, v up
};

fs::path image_file(const fs::path& folder, const MtlMap& map) { return find_file(folder, map.name, map.place); }

// The channel that -imfchan asks for, as grey.
Image heights_image(const Image& image, const MtlMap& map) {
  if (image.channels == 1 || !map.channel) return image;
  const std::string_view kChannels = "rgb";
  const std::size_t channel = kChannels.find(*map.channel);
  Image grey{image.width, image.height, 1, {}};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const float r = image.at(x, y, 0), g = image.at(x, y, 1), b = image.at(x, y, 2);
      grey.pixels.push_back(channel < 3        ? image.at(x, y, static_cast<int>(channel))
                            : r == g && g == b ? r
                                               : luminance(r, g, b));
    }
  }
  return grey;
}

// `norm` is a normal map; `bump` a height map, by Eq. 8-11, unless its image is plainly one of normals.
MipChain read_bump(const MtlMaterial& source, Wraps wraps, const fs::path& folder, Notes& notes) {
  if (source.normal_map) {
    return normals_of(read_normal_map(image_file(folder, *source.normal_map), notes), source.normal_map->multiplier,
                      wraps);
  }
  const MtlMap& map = *source.bump_map;
  const Image image = read_image(image_file(folder, map));
  if (looks_like_normal_map(image)) {
    notes.push_back(map.place.text() + ": \"" + map.name + "\" holds normals and is taken as such");
    return normals_of(image, map.multiplier, wraps);
  }
  const double scale = map.multiplier * map.gain * kHeightOfBumpMap;
  const Grid<double> height = regular_heights(heights_of(heights_image(image, map), scale), wraps);
  return normals_from_heights(height, 1.0, MipMethod::kHeights, wraps);
}

Image read_values(const MtlMap& map, const fs::path& folder) {
  Image image = read_image(image_file(folder, map));
  if (map.base == 0 && map.gain == 1) return image;
  for (float& c : image.pixels) c = static_cast<float>(map.base + map.gain * static_cast<double>(c));
  return image;
}

Image read_gloss(const MtlMap& map, const fs::path& folder, Notes& notes) {
  return gloss_of(heights_image(read_values(map, folder), map), map.place.text() + ": \"" + map.name + "\"", notes);
}

Material material_of(const MtlMaterial& source) {
  Material material;
  material.diffuse = source.diffuse.value_or(kStandardDiffuse);
  const Vec3 ambient = source.ambient.value_or(Vec3{});
  material.ambient = kAmbientLight * (ambient == Vec3{} ? material.diffuse : ambient);
  material.specular = source.specular.value_or(source.gloss_map ? Vec3{1, 1, 1} : Vec3{});
  const double exponent = std::max(source.exponent.value_or(1), 1.0);
  material.exponent = 1 << std::clamp(static_cast<int>(std::lround(std::log2(exponent))), 0, 8);
  return material;
}

ObjMaterial convert(const MtlMaterial& source, const fs::path& folder, Notes& notes) {
  ObjMaterial material;
  material.material = material_of(source);
  material.bump = source.normal_map || source.bump_map;
  material.maps = {source.colour_map.has_value(), source.gloss_map.has_value()};
  if (!material.bump && !material.maps.decal && !material.maps.gloss) return material;

  const MtlMap& leading = source.normal_map   ? *source.normal_map
                          : source.bump_map   ? *source.bump_map
                          : source.colour_map ? *source.colour_map
                                              : *source.gloss_map;
  if (source.normal_map && source.bump_map) {
    notes.push_back(source.bump_map->place.text() + ": beside norm; the height map is not applied");
  }
  material.wrap = leading.clamp ? Wrap::kClamp : Wrap::kRepeat;
  material.offset = leading.offset;
  material.scale = leading.scale;
  for (const auto& map : {source.colour_map, source.gloss_map}) {
    if (!map || (map->offset == leading.offset && map->scale == leading.scale && map->clamp == leading.clamp)) continue;
    notes.push_back(map->place.text() + ": -o, -s and -clamp of " + (material.bump ? "the bump map" : "map_Kd") +
                    " are taken for it too");
  }
  const Wraps wraps{material.wrap, material.wrap};
  MipChain normals;
  std::optional<Image> decal, gloss;
  if (material.bump) normals = read_bump(source, wraps, folder, notes);
  if (source.colour_map) decal = read_values(*source.colour_map, folder);
  if (source.gloss_map) gloss = read_gloss(*source.gloss_map, folder, notes);
  material.texture = make_texture(normals, decal, gloss, wraps);
  return material;
}

// The libraries behind one mtllib: one name that may hold blanks, or several names.
std::vector<std::string> library_names(const fs::path& folder, const std::string& text) {
  if (is_file(folder, text)) return {text};
  std::vector<std::string> names;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \t", at), text.size());
    if (end > at) names.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  const bool any = std::ranges::any_of(names, [&](const std::string& name) { return is_file(folder, name); });
  return any ? names : std::vector<std::string>{text};
}

// The materials of all libraries; one that is not there is noted, as other readers do.
std::vector<MtlMaterial> read_libraries(const ObjFile& obj, const fs::path& folder, Notes& notes) {
  std::vector<MtlMaterial> materials;
  std::vector<std::string> done;
  for (const ObjName& line : obj.libraries) {
    for (const std::string& name : library_names(folder, line.name)) {
      if (std::ranges::count(done, name) > 0) continue;
      done.push_back(name);
      if (!is_file(folder, name)) {
        notes.push_back(line.place.text() + ": no material library \"" + shortened(name) +
                        "\"; its materials are the default");
        continue;
      }
      const fs::path path = find_file(folder, name, line.place);
      std::vector<MtlMaterial> read = parse_mtl(path.string(), read_text_file(path), notes);
      std::move(read.begin(), read.end(), std::back_inserter(materials));
    }
  }
  return materials;
}

// What a corner of the mesh is told apart by: position, uv and normal of the file, where the file has no normal of use,
// what the computed one is of, and the material that scales or moves its texture coordinates, if any.
using CornerKey = std::tuple<std::int32_t, std::int32_t, std::int32_t, std::uint64_t, const ObjMaterial*>;

// All faces as one mesh, with the material and shape of each triangle.
struct WholeMesh {
  Mesh mesh;
  std::vector<std::uint32_t> face_of;  // per triangle
  std::vector<bool> has_uv;            // per triangle
};

class MeshBuilder {
 public:
  // `material_of` gives the material of a face.
  using MaterialOf = std::function<const ObjMaterial&(const ObjFace&)>;
  MeshBuilder(const ObjFile& obj, MaterialOf material_of, const Place& place, Notes& notes)
      : obj_(obj), material_of_(std::move(material_of)), place_(place), notes_(notes) {}

  WholeMesh build() {
    for (std::uint32_t face = 0; face < obj_.faces.size(); ++face) add_triangles(face);
    std::vector<Vec3> positions;
    for (const ObjCorner& corner : corners_) {
      positions.push_back(obj_.positions[static_cast<std::size_t>(corner.position)]);
    }
    const std::vector<Vec3> normals = corner_normals(positions, groups_);
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (i % 3 == 0) whole_.mesh.triangles.emplace_back();
      whole_.mesh.triangles.back()[i % 3] = vertex(i, normals[i]);
    }
    if (of_no_length_ > 0) {
      notes_.push_back(place_.text() + ": " + std::to_string(of_no_length_) +
                       " corners with normals of no length get those of the faces");
    }
    return std::move(whole_);
  }

 private:
  void add_triangles(std::uint32_t number) {
    const ObjFace& face = obj_.faces[number];
    const ObjCorner* corners = &obj_.corners[face.first];
    std::vector<Vec3> outline;
    bool has_uv = true;
    for (std::uint32_t i = 0; i < face.count; ++i) {
      outline.push_back(obj_.positions[static_cast<std::size_t>(corners[i].position)]);
      has_uv = has_uv && corners[i].uv >= 0;
    }
    // Groups are numbered within an object: across materials and g, but not across o.
    const std::uint64_t group =
        face.smoothing == 0 ? 0 : std::uint64_t{face.object} << 32 | std::uint64_t{face.smoothing};
    for (const auto& triangle : triangulate(outline)) {
      for (const std::uint32_t corner : triangle) {
        corners_.push_back(corners[corner]);
        groups_.push_back(group);
      }
      whole_.face_of.push_back(number);
      whole_.has_uv.push_back(has_uv);
    }
  }

  std::uint32_t vertex(std::size_t i, Vec3 computed) {
    const ObjCorner& corner = corners_[i];
    Vec3 N;
    if (corner.normal >= 0) N = normalize(obj_.normals[static_cast<std::size_t>(corner.normal)]);
    const bool usable = N != Vec3{};
    if (corner.normal >= 0 && !usable) ++of_no_length_;
    // Flat corners are each triangle's own; so are smooth ones of triangles that cancel out, which N tells apart.
    const std::uint64_t own = usable ? 0 : groups_[i] != 0 ? groups_[i] : ~(std::uint64_t{i} / 3);
    const ObjMaterial& material = material_of_(obj_.faces[whole_.face_of[i / 3]]);
    const bool moved = material.scale != Vec2{1, 1} || material.offset != Vec2{};
    auto& candidates =
        vertex_of_[{corner.position, corner.uv, usable ? corner.normal : -1, own, moved ? &material : nullptr}];
    for (const std::uint32_t index : candidates) {
      if (whole_.mesh.vertices[index].N == (usable ? N : computed)) return index;
    }
    candidates.push_back(static_cast<std::uint32_t>(whole_.mesh.vertices.size()));
    Vertex& v = whole_.mesh.vertices.emplace_back();
    v.P = obj_.positions[static_cast<std::size_t>(corner.position)];
    v.N = usable ? N : computed;
    if (!obj_.colours.empty()) v.colour = obj_.colours[static_cast<std::size_t>(corner.position)];
    if (corner.uv >= 0) {
      const Vec2 uv = obj_.uvs[static_cast<std::size_t>(corner.uv)];
      const Vec2 scaled{material.scale.x * uv.x, material.scale.y * uv.y};
      v.uv = {scaled.x + material.offset.x, 1 - (scaled.y + material.offset.y)};  // OBJ's v goes up the image
    }
    return candidates.back();
  }

  const ObjFile& obj_;
  MaterialOf material_of_;
  const Place& place_;
  Notes& notes_;
  WholeMesh whole_;
  std::vector<ObjCorner> corners_;     // three a triangle
  std::vector<std::uint64_t> groups_;  // of corners_; 0 for flat
  std::map<CornerKey, std::vector<std::uint32_t>> vertex_of_;
  std::size_t of_no_length_ = 0;
};

// The triangles of one shape that have one material.
struct Part {
  Mesh mesh;
  std::map<std::uint32_t, std::uint32_t> vertex_of;
  bool all_uvs = true;

  void add(const WholeMesh& whole, std::size_t triangle) {
    auto& t = mesh.triangles.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) {
      const auto [entry, is_new] =
          vertex_of.try_emplace(whole.mesh.triangles[triangle][c], static_cast<std::uint32_t>(mesh.vertices.size()));
      if (is_new) mesh.vertices.push_back(whole.mesh.vertices[entry->first]);
      t[c] = entry->second;
    }
    all_uvs = all_uvs && whole.has_uv[triangle];
  }
};

Object object_of(Part part, const std::string& name, const ObjMaterial& material, const Place& place, Notes& notes) {
  Object object;
  object.name = name;
  object.mesh = std::move(part.mesh);
  object.mesh.name = name;
  object.material = material.material;
  object.wrap_u = object.wrap_v = material.wrap;
  if (material.texture && !part.all_uvs) {
    notes.push_back(place.text() + ": \"" + name +
                    "\" has corners without texture coordinates and is drawn without texture");
    return object;
  }
  object.texture = material.texture;
  if (material.bump) object.space = ShadingSpace::kTangent;
  return object;
}

class ObjReader {
 public:
  ObjReader(const fs::path& path, Notes& notes) : path_(path), notes_(notes) {}

  Model read() {
    obj_ = parse_obj(path_.string(), read_text_file(path_), notes_);
    if (obj_.faces.empty()) throw InputError(place_, "no faces", "at least one");
    find_materials();
    read_materials();
    const auto material = [&](const ObjFace& face) -> const ObjMaterial& { return materials_.at(material_of(face)); };
    WholeMesh whole = MeshBuilder(obj_, material, place_, notes_).build();
    // Over the whole mesh, so that tangents do not change where the material or the group does.
    if (std::ranges::any_of(materials_, [](const auto& entry) { return entry.second.bump; })) {
      add_noted_tangents(whole.mesh, {}, place_, notes_);
    }
    add_objects(whole);
    check_size(model_.objects, place_);
    return std::move(model_);
  }

 private:
  // Which of the libraries' materials each name is; those that none has are noted.
  void find_materials() {
    library_ = read_libraries(obj_, path_.parent_path(), notes_);
    std::vector<const ObjName*> missing;
    for (const ObjName& used : obj_.materials) {
      const auto found = std::ranges::find_if(library_, [&](const MtlMaterial& m) { return m.name == used.name; });
      material_of_.push_back(found == library_.end() ? -1 : static_cast<int>(found - library_.begin()));
      if (found == library_.end()) missing.push_back(&used);
    }
    if (missing.empty()) return;
    constexpr std::size_t kShown = 8;
    std::string names;
    for (std::size_t i = 0; i < std::min(missing.size(), kShown); ++i) {
      names += (i > 0 ? ", \"" : "\"") + shortened(missing[i]->name) + "\"";
    }
    if (missing.size() > kShown) names += " and " + std::to_string(missing.size() - kShown) + " more";
    notes_.push_back(missing[0]->place.text() + ": no material " + names + " in the libraries; drawn with the default");
  }
  int material_of(const ObjFace& face) const {
    return face.material < 0 ? -1 : material_of_[static_cast<std::size_t>(face.material)];
  }
  // In the order in which shapes show them.
  void read_materials() {
    materials_[-1] = {};
    for (const ObjFace& face : obj_.faces) {
      const int id = material_of(face);
      if (!materials_.contains(id)) {
        materials_[id] = convert(library_[static_cast<std::size_t>(id)], path_.parent_path(), notes_);
      }
    }
  }
  void add_objects(const WholeMesh& whole) {
    std::map<std::pair<std::uint32_t, int>, Part> parts;
    for (std::size_t i = 0; i < whole.face_of.size(); ++i) {
      const ObjFace& face = obj_.faces[whole.face_of[i]];
      parts[{face.shape, material_of(face)}].add(whole, i);
    }
    for (auto& [key, part] : parts) {
      const ObjMaterial& material = materials_[key.second];
      Object object = object_of(std::move(part), obj_.shapes[key.first], material, place_, notes_);
      if (object.texture) model_.maps = model_.maps | material.maps;
      if (obj_.colours.empty()) {
        model_.objects.push_back(std::move(object));
        continue;
      }
      std::vector<Object> coloured = split_by_colour(std::move(object), place_, notes_);
      std::move(coloured.begin(), coloured.end(), std::back_inserter(model_.objects));
    }
  }

  fs::path path_;
  Place place_{path_.string(), 0, 0, {}};
  Notes& notes_;
  ObjFile obj_;
  std::vector<MtlMaterial> library_;
  std::vector<int> material_of_;  // of ObjFile::materials, -1 for none
  std::map<int, ObjMaterial> materials_;
  Model model_;
};

}  // namespace

Model read_obj_model(const fs::path& path, Notes& notes) { return ObjReader(path, notes).read(); }

}  // namespace wrinkle

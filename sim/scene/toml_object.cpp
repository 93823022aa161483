#include "sim/scene/toml_object.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "golden/texel/height.h"
#include "golden/vertex/surfaces.h"
#include "golden/vertex/tessellate.h"
#include "golden/vertex/transform.h"
#include "sim/scene/built_in.h"
#include "sim/scene/defaults.h"
#include "sim/scene/files.h"
#include "sim/scene/model.h"
#include "sim/scene/normals.h"
#include "sim/scene/textures.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string_view> kObjectKeys = {
    "name",  "mesh",       "tessellation", "size",     "radius",       "radii", "translate", "rotate",       "scale",
    "space", "normal_map", "normal_scale", "height",   "method",       "k",     "mip",       "height_scale", "repeat",
    "wrap",  "decal",      "gloss_map",    "material", "double_sided", "shadow"};

constexpr double kLargestScale = 1e12;

fs::path folder_of(const TomlTable& table) { return fs::path(table.file()).parent_path(); }

// Keys that say something only where `condition` holds.
void only_where(const TomlTable& table, bool condition, std::initializer_list<std::string_view> keys,
                const std::string& where) {
  for (const std::string_view key : keys) {
    if (!condition && table.has(key)) {
      throw InputError(table.place(key), "\"" + std::string(key) + "\"", "it only " + where);
    }
  }
}

// Scaled, turned about x, then y, then z, then moved.
Mat4 read_transform(const TomlTable& table) {
  const Vec3 t = table.vector("translate", -kMaximumCoordinate, kMaximumCoordinate, Vec3{});
  const Vec3 degrees = table.vector("rotate", -3600, 3600, Vec3{});
  Vec3 s{1, 1, 1};
  if (table.is_array("scale")) {
    s = table.vector("scale", -kLargestScale, kLargestScale);
  } else {
    s = table.number("scale", -kLargestScale, kLargestScale, 1) * s;
  }
  for (const double factor : {s.x, s.y, s.z}) {
    if (std::abs(factor) < 1 / kLargestScale)
      throw InputError(table.place("scale"), "a scale of almost 0", "1e-12 to 1e12 in magnitude");
  }
  const Vec3 r = std::numbers::pi / 180 * degrees;
  return translation(t) * rotation({0, 0, 1}, r.z) * rotation({0, 1, 0}, r.y) * rotation({1, 0, 0}, r.x) * scaling(s);
}

Material read_material(const std::string& file, const toml::table& source, Material material) {
  const TomlTable table(file, source, "material", {"ambient", "diffuse", "specular", "exponent"});
  const auto colour = [&](std::string_view key, Vec3 standard) {
    if (table.has(key) && !table.is_array(key)) {
      const double grey = table.number(key, 0, 1);
      return Vec3{grey, grey, grey};
    }
    return table.vector(key, 0, 1, standard);
  };
  material.ambient = colour("ambient", material.ambient);
  material.diffuse = colour("diffuse", material.diffuse);
  material.specular = colour("specular", material.specular);
  material.exponent = static_cast<int>(table.integer("exponent", 0, 256, material.exponent));
  if ((material.exponent & (material.exponent - 1)) != 0) {
    throw InputError(table.place("exponent"), "exponent = " + std::to_string(material.exponent), "0 or a power of two");
  }
  return material;
}

Wrap wrap_of(int choice) { return static_cast<Wrap>(choice); }

void read_wrap(const TomlTable& table, Object& object) {
  if (!table.has("wrap")) return;
  if (!table.is_array("wrap")) {
    object.wrap_u = object.wrap_v = wrap_of(table.choice("wrap", {"repeat", "clamp", "mirror"}));
    return;
  }
  const std::vector<int> each = table.choices("wrap", 2, {"repeat", "clamp", "mirror"});
  object.wrap_u = wrap_of(each[0]);
  object.wrap_v = wrap_of(each[1]);
}

// What the perturbed normals come from.
struct Bump {
  std::optional<Image> normals;
  double normal_scale = 1;
  std::optional<Grid<double>> heights;
  bool by_surface = false;  // Eq. 3-6; else Eq. 8-11
  std::optional<double> k;
  MipMethod mip = MipMethod::kNormals;

  bool any() const { return normals || heights; }
};

Bump read_bump(const TomlTable& table, Notes& notes) {
  Bump bump;
  only_where(table, table.has("normal_map"), {"normal_scale"}, "goes with normal_map");
  only_where(table, table.has("height"), {"height_scale", "method", "k", "mip"}, "goes with height");
  if (table.has("normal_map") && table.has("height")) {
    throw InputError(table.place("height"), "\"height\" beside \"normal_map\"", "one of them");
  }
  if (table.has("normal_map")) {
    bump.normal_scale = table.number("normal_scale", -100, 100, 1);
    const fs::path file = find_file(folder_of(table), table.string("normal_map"), table.place("normal_map"));
    bump.normals = read_normal_map(file, notes);
  }
  if (table.has("height")) {
    bump.by_surface = table.choice("method", {"eq3-6", "eq8-11"}, 0) == 0;
    if (table.has("k")) bump.k = table.number("k", 1e-12, 1e12);
    only_where(table, !bump.by_surface, {"k"}, "goes with method = \"eq8-11\"");
    bump.mip = table.choice("mip", {"normals", "heights"}, 0) == 0 ? MipMethod::kNormals : MipMethod::kHeights;
    const std::string source = table.string("height");
    const double scale = table.number("height_scale", -1e12, 1e12, source == "pinwheel" ? 0.02 : 0.05);
    bump.heights = source == "pinwheel"
                       ? pinwheel(512, scale)
                       : heights_of(read_image(find_file(folder_of(table), source, table.place("height"))), scale);
  }
  return bump;
}

// A height field that is repeated over a surface: (u, v) of the surface to (u, v) of the field, image rows downwards.
class RepeatedHeightField : public HeightField {
 public:
  RepeatedHeightField(std::shared_ptr<const HeightField> field, Vec2 repeat)
      : field_(std::move(field)), repeat_(repeat) {}
  Vec2 gradient(double u, double v) const override {
    const Vec2 g = field_->gradient(repeat_.x * u, 1 - repeat_.y * (1 - v));
    return {repeat_.x * g.x, repeat_.y * g.y};
  }

 private:
  std::shared_ptr<const HeightField> field_;
  Vec2 repeat_;
};

// Whether a matrix turns, moves and scales all directions alike, without a mirror.
bool is_similarity(const Mat4& m) {
  const auto column = [&](int j) { return Vec3{m(0, j), m(1, j), m(2, j)}; };
  const Vec3 x = column(0), y = column(1), z = column(2);
  const double square = dot(x, x), tolerance = 1e-9 * square;
  const bool even = std::abs(dot(y, y) - square) < tolerance && std::abs(dot(z, z) - square) < tolerance;
  const bool square_on =
      std::abs(dot(x, y)) < tolerance && std::abs(dot(y, z)) < tolerance && std::abs(dot(z, x)) < tolerance;
  return even && square_on && determinant3(m) > 0;
}

// The k of Eq. 8-11 for a mesh in the world: the square root of its area by the area of its texture coordinates.
double scale_of(const Object& object) {
  double area = 0, uv_area = 0;
  for (const auto& t : object.mesh.triangles) {
    const Vertex &a = object.mesh.vertices[t[0]], &b = object.mesh.vertices[t[1]], &c = object.mesh.vertices[t[2]];
    const Vec3 p = transform_direction(object.to_world, b.P - a.P), q = transform_direction(object.to_world, c.P - a.P);
    const Vec2 s = b.uv - a.uv, r = c.uv - a.uv;
    area += length(cross(p, q));
    uv_area += std::abs(s.x * r.y - s.y * r.x);
  }
  return uv_area > 0 && area > 0 ? std::sqrt(area / uv_area) : 1;
}

// Reads one table.
class ObjectReader {
 public:
  ObjectReader(const TomlTable& table, Notes& notes) : table_(table), notes_(notes) {}

  std::vector<Object> read(Maps& maps) {
    Bump bump = read_bump(table_, notes_);
    std::vector<Object> objects = bare_objects(bump.by_surface && bump.heights);
    for (Object& object : objects) read_wrap(table_, object);
    wraps_ = {objects.front().wrap_u, objects.front().wrap_v};
    if (bump.heights) bump.heights = regular_heights(*bump.heights, wraps_);
    if (table_.has("decal")) base_ = read_map("decal");
    if (table_.has("gloss_map")) gloss_ = gloss_of(read_map("gloss_map"), table_.place("gloss_map").text(), notes_);
    MipChain normals;
    if (bump.normals) normals = normals_of(*bump.normals, bump.normal_scale, wraps_);
    if (bump.heights && !bump.by_surface) normals = square_normals(bump, objects);
    std::shared_ptr<const ExactTexture> shared;
    if (!normals.empty() || base_ || gloss_) shared = make_texture(normals, base_, gloss_, wraps_);
    note_lost_maps(bump);
    maps = maps | model_maps_ | Maps{base_.has_value(), gloss_.has_value()};
    for (Object& object : objects) finish(object, bump, shared);
    return objects;
  }

 private:
  // Meshes in their places, with the materials of their files.
  std::vector<Object> bare_objects(bool one_per_surface) {
    const Mat4 to_world = read_transform(table_);
    std::vector<Object> objects;
    if (is_model_file()) {
      only_where(table_, false, {"tessellation", "size", "radius", "radii"}, "goes with a built-in mesh");
      const fs::path path = find_file(folder_of(table_), table_.string("mesh"), table_.place("mesh"));
      Model model = read_model(path, notes_);
      model_maps_ = model.maps;
      objects = std::move(model.objects);
    } else {
      objects = read_built_in(table_, one_per_surface);
    }
    const Vec2 repeat = read_repeat();
    for (Object& object : objects) {
      object.to_world = to_world * object.to_world;
      for (Vertex& vertex : object.mesh.vertices) vertex.uv = {repeat.x * vertex.uv.x, repeat.y * vertex.uv.y};
    }
    return objects;
  }

  bool is_model_file() const {
    const std::string mesh = table_.string("mesh");
    const std::string extension = extension_of(mesh);
    return extension == ".gltf" || extension == ".glb" || extension == ".obj";
  }

  Vec2 read_repeat() const {
    const std::vector<double> r = table_.numbers("repeat", 2, 1.0 / 64, 64, std::vector<double>{1, 1});
    return {r[0], r[1]};
  }

  Image read_map(std::string_view key) const {
    return read_image(find_file(folder_of(table_), table_.string(key), table_.place(key)));
  }

  // A texture of the table stands in the place of the model's, base colour, gloss and all.
  void note_lost_maps(const Bump& bump) {
    if (!base_ && !gloss_ && !bump.any()) return;
    const Maps lost = std::exchange(model_maps_, {});
    const std::string rest = " of the model are not drawn with " +
                             std::string(bump.any() ? "a normal map or height"
                                         : base_    ? "a decal"
                                                    : "a gloss map") +
                             " of the scene file";
    if (lost.decal && !base_) notes_.push_back(table_.place("mesh").text() + ": the base colours" + rest);
    if (lost.gloss && !gloss_) notes_.push_back(table_.place("mesh").text() + ": the gloss maps" + rest);
  }
  // One map for all objects of the table: k is theirs on the average.
  MipChain square_normals(const Bump& bump, const std::vector<Object>& objects) const {
    double k = 0;
    for (const Object& object : objects) k += scale_of(object) / static_cast<double>(objects.size());
    return normals_from_heights(*bump.heights, bump.k.value_or(k), bump.mip, wraps_);
  }

  void finish(Object& object, const Bump& bump, const std::shared_ptr<const ExactTexture>& shared) const {
    if (table_.has("name")) object.name = table_.string("name");
    const toml::table* material = table_.table("material");
    if (material != nullptr) object.material = read_material(table_.file(), *material, object.material);
    object.double_sided = table_.boolean("double_sided", object.double_sided);
    object.shadow = table_.boolean("shadow", object.shadow);
    if (shared) object.texture = shared;
    if (bump.any()) {
      object.space = ShadingSpace::kTangent;
      if (object.mesh.surfaces.empty()) add_noted_tangents(object.mesh, {}, table_.place("mesh"), notes_);
    }
    if (bump.heights) add_heights(object, bump);
    set_space(object, bump);
  }

  void add_heights(Object& object, const Bump& bump) const {
    const Vec2 repeat = read_repeat();
    object.heights = std::make_shared<Grid<double>>(*bump.heights);
    object.repeat = repeat;
    if (bump.by_surface) {
      if (object.mesh.surfaces.empty()) {
        throw InputError(table_.place("mesh"), "a mesh without analytic surface",
                         "a built-in one for method = \"eq3-6\"");
      }
      if (repeat != Vec2{1, 1}) {
        throw InputError(table_.place("repeat"), "repeat other than 1",
                         "[1, 1] for method = \"eq3-6\", whose normals fit one place of the surface only");
      }
      object.texture = make_texture(surface_normals(object, bump), base_, gloss_, wraps_);
    }
    if (object.mesh.surfaces.empty()) return;
    object.height = std::make_shared<SampledHeightField>(*bump.heights, wraps_);
    if (repeat != Vec2{1, 1}) object.height = std::make_shared<RepeatedHeightField>(object.height, repeat);
  }

  bool in_object_space() const {
    return table_.has("space") && table_.choice("space", {"world", "tangent", "object"}) == 2;
  }

  // Heights are lengths in the world. Normals in object space are those of the object before it was scaled, turned and
  // moved, which the surface under the scale alone has too.
  MipChain surface_normals(const Object& object, const Bump& bump) const {
    const auto& surface = object.mesh.surfaces.front();
    if (!in_object_space()) {
      return normals_from_heights(*bump.heights, *transformed(surface, object.to_world), bump.mip, wraps_);
    }
    const double scale = std::cbrt(determinant3(object.to_world));
    return object_normals_from_heights(*bump.heights, *transformed(surface, scaling({scale, scale, scale})), bump.mip,
                                       wraps_);
  }

  void set_space(Object& object, const Bump& bump) const {
    if (!table_.has("space")) return;
    if (in_object_space()) {
      if (!bump.by_surface || !bump.heights) {
        throw InputError(table_.place("space"), "space = \"object\" without normals in object space",
                         "height and method = \"eq3-6\" beside it");
      }
      if (!is_similarity(object.to_world)) {
        throw InputError(table_.place("space"), "space = \"object\" of a mesh that is mirrored or scaled unevenly",
                         "one scale for all directions, greater than 0");
      }
      object.space = ShadingSpace::kObject;
      return;
    }
    const bool tangent = table_.choice("space", {"world", "tangent", "object"}) == 1;
    if (tangent && !bump.any() && object.space != ShadingSpace::kTangent) {
      throw InputError(table_.place("space"), "space = \"tangent\" without normals to light",
                       "normal_map or height beside it");
    }
    object.space = tangent ? ShadingSpace::kTangent : ShadingSpace::kWorld;
  }

  const TomlTable& table_;
  Notes& notes_;
  std::optional<Image> base_, gloss_;
  Wraps wraps_;
  Maps model_maps_;  // that are drawn
};

}  // namespace

std::vector<Object> read_toml_objects(const std::string& file, const toml::table& source, Notes& notes, Maps& maps) {
  const TomlTable table(file, source, "an object", kObjectKeys);
  return ObjectReader(table, notes).read(maps);
}

}  // namespace wrinkle

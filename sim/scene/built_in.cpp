#include "sim/scene/built_in.h"

#include <array>
#include <memory>

#include "golden/vertex/bezier.h"
#include "golden/vertex/surfaces.h"
#include "golden/vertex/teapot.h"
#include "golden/vertex/tessellate.h"
#include "sim/scene/defaults.h"

namespace wrinkle {
namespace {

enum Kind { kPatch, kTeapot, kSphere, kTorus, kRevolution, kRectangle, kCube, kFloor, kWall };
constexpr std::array<std::string_view, 9> kNames = {"patch",     "teapot", "sphere", "torus", "revolution",
                                                    "rectangle", "cube",   "floor",  "wall"};

// A vase between its foot at height -1 and its rim at 1: radius and height.
std::vector<Vec2> vase() {
  return {{0.42, -1}, {0.62, -0.7}, {0.78, -0.35}, {0.72, 0}, {0.5, 0.35}, {0.38, 0.65}, {0.46, 0.9}, {0.56, 1}};
}

// A measure of another mesh is an error.
void reject(const TomlTable& table, bool condition, std::string_view key, const std::string& meshes) {
  if (!condition || !table.has(key)) return;
  throw InputError(table.place(key), "\"" + std::string(key) + "\" for mesh = \"" + table.string("mesh") + "\"",
                   "it only for " + meshes);
}

Surfaces surfaces_of(const TomlTable& table, Kind kind) {
  reject(table, kind != kFloor && kind != kWall, "size", "floor and wall");
  reject(table, kind != kSphere, "radius", "sphere");
  reject(table, kind != kTorus, "radii", "torus");
  const auto size = [&] { return table.numbers("size", 2, 1e-9, 1e9, std::vector<double>{1, 1}); };
  switch (kind) {
    case kPatch:
      return {stretched_patch()};
    case kTeapot:
      return teapot();
    case kSphere:
      return {std::make_shared<Sphere>(table.number("radius", 1e-9, 1e9, 1))};
    case kTorus: {
      const auto radii = table.numbers("radii", 2, 1e-9, 1e9, std::vector<double>{1, 0.4});
      if (radii[1] >= radii[0]) {
        throw InputError(table.place("radii"), "a tube as wide as its ring", "radii = [ring, tube] with tube < ring");
      }
      return {std::make_shared<Torus>(radii[0], radii[1])};
    }
    case kRevolution:
      return {std::make_shared<Revolution>(vase())};
    case kRectangle:
      return make_rectangle();
    case kCube:
      return make_cube();
    case kFloor:
      return make_floor(size()[0], size()[1]);
    case kWall:
      return make_wall(size()[0], size()[1]);
  }
  return {};
}

// Divisions along u and v: one number, or one each.
std::array<int, 2> read_tessellation(const TomlTable& table, Kind kind) {
  const bool round = kind == kSphere || kind == kTorus || kind == kRevolution;
  const bool flat = kind >= kRectangle;
  const int standard = round ? 48 : flat ? 1 : kStandardDivisions;
  if (!table.is_array("tessellation")) {
    const int n = static_cast<int>(table.integer("tessellation", 1, 1024, standard));
    return {n, n};
  }
  const std::vector<std::int64_t> n = table.integers("tessellation", 2, 1, 1024);
  return {static_cast<int>(n[0]), static_cast<int>(n[1])};
}

}  // namespace

std::vector<Object> read_built_in(const TomlTable& table, bool one_per_surface) {
  const auto kind = static_cast<Kind>(table.choice("mesh", kNames));
  const Surfaces surfaces = surfaces_of(table, kind);
  const std::array<int, 2> n = read_tessellation(table, kind);
  const std::size_t triangles = surfaces.size() * 2 * static_cast<std::size_t>(n[0]) * static_cast<std::size_t>(n[1]);
  if (triangles > kMaximumTriangles) {
    throw InputError(table.place("tessellation"), std::to_string(triangles) + " triangles",
                     "at most " + std::to_string(kMaximumTriangles));
  }
  std::vector<Object> objects;
  const auto add = [&](const Surfaces& part) {
    Object& object = objects.emplace_back();
    object.name = table.string("mesh");
    object.mesh = tessellate(part, n[0], n[1]);
    object.mesh.name = object.name;
  };
  if (!one_per_surface) add(surfaces);
  for (std::size_t i = 0; one_per_surface && i < surfaces.size(); ++i) add({surfaces[i]});
  return objects;
}

}  // namespace wrinkle

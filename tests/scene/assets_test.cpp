// The real models in ../shared/assets, used in place; without it these tests are skipped.
#include <array>
#include <cmath>
#include <optional>

#include "golden/vertex/scene.h"
#include "golden/vertex/transform.h"
#include "sim/config_file.h"
#include "sim/scene/scene_reader.h"
#include "support.h"

namespace wrinkle::test {
namespace {

struct Asset {
  const char* path;
  std::size_t objects, triangles, vertices;
  const char* config;
};

class Assets : public ::testing::TestWithParam<Asset> {};

TEST_P(Assets, AreReadAndDrawn) {
  const fs::path path = shared(GetParam().path);
  if (!fs::exists(path)) GTEST_SKIP() << "no ../shared/assets/" << GetParam().path;
  const Scene scene = read_scene(path);
  std::size_t triangles = 0, vertices = 0;
  for (const Object& object : scene.objects) {
    triangles += object.mesh.triangles.size();
    vertices += object.mesh.vertices.size();
    for (const Vertex& v : object.mesh.vertices) ASSERT_NEAR(length(v.N), 1, 1e-6);
  }
  EXPECT_EQ(scene.objects.size(), GetParam().objects);
  EXPECT_EQ(triangles, GetParam().triangles);
  EXPECT_EQ(vertices, GetParam().vertices);
  EXPECT_EQ(scene.config, GetParam().config);
  std::size_t drawn = 0;
  for (const Draw& draw : build_frame(load_config(scene.config), scene).draws) drawn += draw.triangles.size();
  EXPECT_GT(drawn, 0U);
  EXPECT_LE(drawn, triangles);
}

INSTANTIATE_TEST_SUITE_P(
    Shared, Assets,
    ::testing::Values(Asset{"gltf/Avocado/glTF/Avocado.gltf", 1, 682, 406, "fine"},
                      Asset{"gltf/NormalTangentTest/glTF/NormalTangentTest.gltf", 1, 7774, 3983, "fine"},
                      Asset{"gltf/NormalTangentTest/glTF-Binary/NormalTangentTest.glb", 1, 7774, 3983, "fine"},
                      Asset{"gltf/TextureCoordinateTest/glTF/TextureCoordinateTest.gltf", 5, 10, 20, "fine"},
                      Asset{"gltf/TextureSettingsTest/glTF/TextureSettingsTest.gltf", 10, 72, 144, "fine"},
                      Asset{"gltf/TextureSettingsTest/glTF-Binary/TextureSettingsTest.glb", 10, 72, 144, "fine"},
                      Asset{"gltf/TwoSidedPlane/glTF/TwoSidedPlane.gltf", 1, 2, 6, "fine"},
                      Asset{"mesh/materialx/cube.obj", 1, 12, 36, "perspective"},
                      Asset{"mesh/materialx/plane.obj", 1, 1800, 961, "perspective"},
                      Asset{"mesh/materialx/sphere.obj", 1, 7080, 14280, "perspective"},
                      Asset{"mesh/materialx/teapot.obj", 1, 25200, 12993, "perspective"}),
    [](const auto& asset) {
      std::string name = fs::path(asset.param.path).filename().string();
      std::replace(name.begin(), name.end(), '.', '_');
      return name;
    });

using Corners = std::array<Vertex, 3>;

// In the world: a converter may have put the transforms of nodes into the vertices.
std::vector<Corners> triangles_of(const Scene& scene) {
  std::vector<Corners> list;
  for (const Object& object : scene.objects) {
    std::vector<Vertex> v = object.mesh.vertices;
    for (Vertex& vertex : v) {
      vertex.P = transform_point(object.to_world, vertex.P);
      vertex.N = normalize(transform_normal(object.to_world, vertex.N));
      vertex.T = normalize(transform_direction(object.to_world, vertex.T));
    }
    for (const auto& t : object.mesh.triangles) list.push_back({v[t[0]], v[t[1]], v[t[2]]});
  }
  return list;
}

// The OBJ files have nine digits, so each number is that of the glTF file, in single precision, to half a unit of its
// last place.
bool same_corner(const Vertex& a, const Vertex& b) {
  return length(a.P - b.P) < 1e-7 && std::abs(a.uv.x - b.uv.x) < 1e-6 && std::abs(a.uv.y - b.uv.y) < 1e-6;
}

// `t` with its corners in the order that `like` has, where they are the same corners.
std::optional<Corners> matched(const Corners& like, const Corners& t) {
  for (std::size_t turn = 0; turn < 3; ++turn) {
    const Corners turned{t[turn], t[(turn + 1) % 3], t[(turn + 2) % 3]};
    if (same_corner(like[0], turned[0]) && same_corner(like[1], turned[1]) && same_corner(like[2], turned[2])) {
      return turned;
    }
  }
  return std::nullopt;
}

struct Twin {
  const char* name;
  double tangents;  // how far apart unit tangents may be: those of the Avocado are supplied, and the exporter's
};

class Twins : public ::testing::TestWithParam<Twin> {};

// Triangles may have changed their order.
TEST_P(Twins, ObjHasTheFramesOfGltf) {
  const std::string name = GetParam().name;
  const fs::path gltf = shared("gltf/" + name + "/glTF/" + name + ".gltf");
  const fs::path obj = shared("obj/" + name + "_assimp/" + name + ".obj");
  if (!fs::exists(gltf) || !fs::exists(obj)) GTEST_SKIP() << "no ../shared/assets for " << name;
  const std::vector<Corners> a = triangles_of(read_scene(gltf)), b = triangles_of(read_scene(obj));
  ASSERT_EQ(a.size(), b.size());
  std::size_t same_tangent = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::optional<Corners> twin = matched(a[i], b[i]);
    for (std::size_t j = 0; j < b.size() && !twin; ++j) twin = matched(a[i], b[j]);
    ASSERT_TRUE(twin) << "triangle " << i;
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_LT(length(a[i][c].N - (*twin)[c].N), 1e-5) << "triangle " << i;
      same_tangent += length(a[i][c].T - (*twin)[c].T) < GetParam().tangents && a[i][c].sign == (*twin)[c].sign ? 1 : 0;
    }
  }
  // Rounding to decimals moves welds, and so groups, at a few corners.
  const double share = static_cast<double>(same_tangent) / static_cast<double>(3 * a.size());
  RecordProperty("same_tangent", std::to_string(share));
  EXPECT_GT(share, 0.95);
}

INSTANTIATE_TEST_SUITE_P(Shared, Twins, ::testing::Values(Twin{"Avocado", 0.25}, Twin{"NormalTangentTest", 0.02}),
                         CaseName());

}  // namespace
}  // namespace wrinkle::test

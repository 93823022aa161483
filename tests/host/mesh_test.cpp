// Tessellation and mesh utilities.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "golden/vertex/bezier.h"
#include "golden/vertex/surfaces.h"
#include "golden/vertex/teapot.h"
#include "golden/vertex/tessellate.h"

namespace wrinkle {
namespace {

using Key = std::tuple<double, double, double>;
Key key(Vec3 p) { return {p.x, p.y, p.z}; }

// How many triangles have each edge, by its two positions in the direction in which the triangle has it.
std::map<std::pair<Key, Key>, int> directed_edges(const Mesh& mesh) {
  std::map<std::pair<Key, Key>, int> edges;
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      ++edges[{key(mesh.vertices[t[i]].P), key(mesh.vertices[t[(i + 1) % 3]].P)}];
    }
  }
  return edges;
}

// Every edge is met by as many triangles from one side as from the other.
void expect_closed(const Mesh& mesh) {
  const auto edges = directed_edges(mesh);
  for (const auto& [edge, count] : edges) {
    const auto opposite = edges.find({edge.second, edge.first});
    ASSERT_NE(opposite, edges.end());
    ASSERT_EQ(opposite->second, count);
  }
}

double volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    sum += dot(mesh.vertices[t[0]].P, cross(mesh.vertices[t[1]].P, mesh.vertices[t[2]].P)) / 6;
  }
  return sum;
}

TEST(Mesh, ThePaperHas128Triangles) {
  const Mesh mesh = tessellate({stretched_patch()});
  EXPECT_EQ(mesh.triangles.size(), 128u);
  EXPECT_EQ(mesh.triangle_surface.size(), 128u);
  EXPECT_EQ(mesh.vertices.size(), 81u);
}

TEST(Mesh, ClosedSurfacesAreWatertight) {
  expect_closed(tessellate({std::make_shared<Sphere>(1)}, 12, 7));
  expect_closed(tessellate({std::make_shared<Torus>(2, 0.5)}, 9, 5));
  expect_closed(tessellate(make_cube(), 3, 3));
}

// Rim, body and lid join their neighbours all around: no edge inside a ring of four patches is open.
TEST(Mesh, TeapotHasNoCracks) {
  const auto patches = teapot();
  const std::vector<std::shared_ptr<const Surface>> body(patches.begin() + 4, patches.begin() + 12);
  const Mesh mesh = tessellate(body, 8, 8);
  const auto edges = directed_edges(mesh);
  int open = 0;
  for (const auto& [edge, count] : edges) open += edges.count({edge.second, edge.first}) == 0 ? count : 0;
  EXPECT_EQ(open, 2 * 4 * 8);  // the upper and the lower rim, nothing between them
}

TEST(Mesh, TrianglesTurnAsTheNormalsSay) {
  std::vector<Surfaces> all{
      {stretched_patch()},          teapot(), make_cube(), make_wall(2, 3), make_floor(4, 5), make_rectangle(),
      {std::make_shared<Sphere>(1)}};
  for (const Surfaces& surfaces : all) {
    const Mesh mesh = tessellate(surfaces, 8, 8);
    for (const auto& t : mesh.triangles) {
      const Vertex &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
      ASSERT_GT(dot(cross(b.P - a.P, c.P - a.P), a.N + b.N + c.N), 0);
    }
  }
  EXPECT_NEAR(volume(tessellate({std::make_shared<Sphere>(1)}, 64, 64)), 4.18879, 0.02);
  EXPECT_NEAR(volume(tessellate(make_cube(), 2, 2)), 1, 1e-12);
  EXPECT_GT(volume(tessellate(teapot(), 8, 8)), 0.5);
}

// Handle and spout are tubes, so their normals point away from their middle line.
TEST(Mesh, HandleAndSpoutFaceOutwards) {
  const auto patches = teapot();
  for (std::size_t first : {12u, 14u, 16u, 18u}) {
    for (double v = first == 18 ? 0.5 : 0.1; v < 1; v += 0.2) {  // the spout's lip turns inwards
      Vec3 middle;
      for (std::size_t half = 0; half < 2; ++half) {
        for (double u = 0.05; u < 1; u += 0.1) middle = middle + 0.05 * patches[first + half]->at(u, v).P;
      }
      for (std::size_t half = 0; half < 2; ++half) {
        const SurfacePoint s = patches[first + half]->at(0.5, v);
        EXPECT_GT(dot(s.N, s.P - middle), 0) << first << " " << v;
      }
    }
  }
}

TEST(Mesh, FramesAreOrthonormalPolesIncluded) {
  for (const Surfaces& surfaces : {Surfaces{std::make_shared<Sphere>(1)}, Surfaces(teapot())}) {
    for (const Vertex& v : tessellate(surfaces, 8, 8).vertices) {
      ASSERT_NEAR(length(v.N), 1, 1e-12);
      ASSERT_NEAR(length(v.T), 1, 1e-12);
      ASSERT_NEAR(dot(v.N, v.T), 0, 1e-12);
      ASSERT_EQ(v.sign, 1);
      ASSERT_EQ(v.uv.x, v.parameter.x);
      ASSERT_EQ(v.uv.y, 1 - v.parameter.y);
    }
  }
  // Pu vanishes at the pole; its direction is that of the circles of latitude nearby.
  const Sphere sphere(1);
  const Vec3 T = surface_tangent(sphere, 0.25, 1, {0, 1, 0});
  EXPECT_NEAR(length(T - Vec3{0, 0, -1}), 0, 1e-9);
}

TEST(Mesh, FacesOfTheCubeAreUpright) {
  const Mesh cube = tessellate(make_cube(), 1, 1);
  for (std::size_t i = 0; i < 16; ++i) {  // the four sides
    const Vertex& v = cube.vertices[i];
    EXPECT_EQ(v.uv.y, v.P.y > 0 ? 0 : 1);  // top of the image on top
    EXPECT_NEAR(length(cross(v.N, v.T) - Vec3{0, 1, 0}), 0, 1e-12);
  }
}

TEST(Mesh, FlatNormalsAreThoseOfTheTriangles) {
  Mesh cube = tessellate(make_cube(), 1, 1);
  const Mesh before = cube;
  for (Vertex& v : cube.vertices) v.N = {};
  flat_normals(cube);
  EXPECT_EQ(cube.vertices.size(), 3 * cube.triangles.size());
  for (std::size_t n = 0; n < cube.triangles.size(); ++n) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vertex &now = cube.vertices[cube.triangles[n][i]], &then = before.vertices[before.triangles[n][i]];
      EXPECT_EQ(now.P, then.P);
      EXPECT_NEAR(length(now.N - then.N), 0, 1e-12);
    }
  }
}

TEST(Mesh, DegenerateTrianglesGetFiniteNormals) {
  Mesh mesh;
  mesh.vertices.resize(4);
  mesh.vertices[1].P = {1, 0, 0};
  mesh.vertices[2].P = {2, 0, 0};
  mesh.triangles = {{0, 1, 2}};
  flat_normals(mesh);
  for (const Vertex& v : mesh.vertices) EXPECT_EQ(v.N, (Vec3{0, 0, 1}));
}

TEST(Mesh, PerpendicularIsPerpendicularWhateverTheWish) {
  for (const Vec3 n : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, normalize({1, 2, 3})}) {
    for (const Vec3 wish : {Vec3{}, n, -n, Vec3{0, 0, 1}, Vec3{1e-300, 0, 0}}) {
      const Vec3 t = perpendicular(n, wish);
      EXPECT_NEAR(length(t), 1, 1e-12);
      EXPECT_NEAR(dot(t, n), 0, 1e-12);
    }
  }
}

}  // namespace
}  // namespace wrinkle

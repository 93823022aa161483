#include "golden/vertex/tessellate.h"

#include <algorithm>

#include "golden/vertex/surfaces.h"

namespace wrinkle {
namespace {

Vertex surface_vertex(const Surface& surface, double u, double v) {
  const SurfacePoint s = surface.at(u, v);
  return {s.P, s.N, surface_tangent(surface, u, v, s.N), 1, {u, 1 - v}, {u, v}, s.Pu, s.Pv, {1, 1, 1}};
}

void add_triangle(Mesh& mesh, std::uint32_t surface, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const Vec3 A = mesh.vertices[a].P, B = mesh.vertices[b].P, C = mesh.vertices[c].P;
  if (A == B || B == C || C == A) return;
  mesh.triangles.push_back({a, b, c});
  mesh.triangle_surface.push_back(surface);
}

void add_vertices(Mesh& mesh, const Surface& surface, int nu, int nv) {
  for (int j = 0; j <= nv; ++j) {
    for (int i = 0; i <= nu; ++i) {
      mesh.vertices.push_back(surface_vertex(surface, static_cast<double>(i) / nu, static_cast<double>(j) / nv));
    }
  }
}

// A border that two surfaces share is computed in two ways, apart by rounding errors. Rounded to 2^-44 of the extent of
// the mesh, the two are one.
void join_positions(Mesh& mesh) {
  double extent = 0;
  for (const Vertex& v : mesh.vertices) {
    extent = std::max({extent, std::abs(v.P.x), std::abs(v.P.y), std::abs(v.P.z)});
  }
  const double unit = std::ldexp(1, std::ilogb(std::max(extent, 1e-280)) - 44);
  const auto round = [&](double x) { return std::round(x / unit) * unit; };
  for (Vertex& v : mesh.vertices) v.P = {round(v.P.x), round(v.P.y), round(v.P.z)};
}

void add_triangles(Mesh& mesh, std::uint32_t surface, int nu, int nv) {
  const auto first = surface * static_cast<std::uint32_t>((nu + 1) * (nv + 1));
  const auto corner = [&](int i, int j) { return first + static_cast<std::uint32_t>(j * (nu + 1) + i); };
  for (int j = 0; j < nv; ++j) {
    for (int i = 0; i < nu; ++i) {
      add_triangle(mesh, surface, corner(i, j), corner(i + 1, j), corner(i + 1, j + 1));
      add_triangle(mesh, surface, corner(i, j), corner(i + 1, j + 1), corner(i, j + 1));
    }
  }
}

}  // namespace

Mesh tessellate(const Surfaces& surfaces, int nu, int nv) {
  Mesh mesh;
  mesh.surfaces = surfaces;
  for (const auto& surface : surfaces) add_vertices(mesh, *surface, nu, nv);
  join_positions(mesh);
  for (std::uint32_t i = 0; i < surfaces.size(); ++i) add_triangles(mesh, i, nu, nv);
  return mesh;
}

Vec3 surface_tangent(const Surface& surface, double u, double v, Vec3 N) {
  constexpr double kStep = 1e-4;
  constexpr double kPole = 1e-9;
  const SurfacePoint s = surface.at(u, v);
  if (length(s.Pu) > kPole * length(s.Pv)) return perpendicular(N, s.Pu);
  return perpendicular(N, surface.at(u, v < 0.5 ? v + kStep : v - kStep).Pu);
}

Vec3 perpendicular(Vec3 n, Vec3 wish) {
  const Vec3 w = normalize(wish);
  const Vec3 t = w - dot(w, n) * n;
  // What is left of a direction along n is rounding noise.
  if (length(t) > 1e-6) return normalize(t);
  const Vec3 other = std::abs(n.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  return normalize(other - dot(other, n) * n);
}

Surfaces make_rectangle() { return {std::make_shared<Rectangle>(Vec3{-0.5, -0.5, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0})}; }

Surfaces make_wall(double width, double height) {
  return {std::make_shared<Rectangle>(Vec3{-width / 2, 0, 0}, Vec3{width, 0, 0}, Vec3{0, height, 0})};
}

Surfaces make_floor(double width, double depth) {
  return {std::make_shared<Rectangle>(Vec3{-width / 2, 0, depth / 2}, Vec3{width, 0, 0}, Vec3{0, 0, -depth})};
}

Surfaces make_cube() {
  struct Face {
    Vec3 right, up;
  };
  constexpr Face kFaces[] = {{{1, 0, 0}, {0, 1, 0}}, {{-1, 0, 0}, {0, 1, 0}}, {{0, 0, -1}, {0, 1, 0}},
                             {{0, 0, 1}, {0, 1, 0}}, {{1, 0, 0}, {0, 0, -1}}, {{1, 0, 0}, {0, 0, 1}}};
  Surfaces faces;
  for (const Face& face : kFaces) {
    const Vec3 origin = 0.5 * (cross(face.right, face.up) - face.right - face.up);
    faces.push_back(std::make_shared<Rectangle>(origin, face.right, face.up));
  }
  return faces;
}

double corner_angle(Vec3 at, Vec3 a, Vec3 b) {
  const Vec3 x = a - at, y = b - at;
  return std::atan2(length(cross(x, y)), dot(x, y));
}

void flat_normals(Mesh& mesh) {
  std::vector<Vertex> corners;
  corners.reserve(3 * mesh.triangles.size());
  for (auto& triangle : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(corners.size());
    for (const std::uint32_t index : triangle) corners.push_back(mesh.vertices[index]);
    Vertex* v = &corners[first];
    const Vec3 n = normalize(cross(v[1].P - v[0].P, v[2].P - v[0].P));
    for (int i = 0; i < 3; ++i) v[i].N = n == Vec3{} ? Vec3{0, 0, 1} : n;
    triangle = {first, first + 1, first + 2};
  }
  mesh.vertices = std::move(corners);
}

}  // namespace wrinkle

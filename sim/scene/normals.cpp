#include "sim/scene/normals.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "golden/vertex/tangents.h"
#include "golden/vertex/tessellate.h"

namespace wrinkle {
namespace {

// Directions of the triangles around a position, weighted by their angles there.
struct AngleSum {
  Vec3 sum;
  double weight = 0;
  bool cancels() const { return !(length(sum) > 1e-9 * weight); }
};

Vec3 direction_of(const Vec3* p) { return normalize(cross(p[1] - p[0], p[2] - p[0])); }

}  // namespace

std::vector<Vec3> corner_normals(std::span<const Vec3> positions, std::span<const std::uint64_t> groups) {
  using Key = std::tuple<std::uint64_t, double, double, double>;
  const auto key = [&](std::size_t i) { return Key{groups[i], positions[i].x, positions[i].y, positions[i].z}; };
  std::map<Key, AngleSum> sums;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (groups[i] == 0) continue;
    const Vec3* p = &positions[i - i % 3];
    const double angle = corner_angle(positions[i], p[(i + 1) % 3], p[(i + 2) % 3]);
    const Vec3 n = direction_of(p);
    AngleSum& sum = sums[key(i)];
    sum.sum = sum.sum + angle * n;
    sum.weight += n == Vec3{} ? 0 : angle;
  }
  std::vector<Vec3> normals;
  normals.reserve(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Vec3 flat = direction_of(&positions[i - i % 3]);
    const AngleSum* sum = groups[i] == 0 ? nullptr : &sums[key(i)];
    const Vec3 n = sum == nullptr || sum->cancels() ? flat : normalize(sum->sum);
    normals.push_back(n == Vec3{} ? Vec3{0, 0, 1} : n);
  }
  return normals;
}

void replace_normals_of_no_length(Mesh& mesh, const Place& place, Notes& notes) {
  const auto has_none = [](const Vertex& v) { return v.N == Vec3{}; };
  const auto count = std::ranges::count_if(mesh.vertices, has_none);
  if (count == 0) return;
  std::vector<Vec3> positions;
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t index : t) positions.push_back(mesh.vertices[index].P);
  }
  const std::vector<std::uint64_t> groups(positions.size(), 1);
  const std::vector<Vec3> normals = corner_normals(positions, groups);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    Vertex& vertex = mesh.vertices[mesh.triangles[i / 3][i % 3]];
    if (has_none(vertex)) vertex.N = normals[i];
  }
  for (Vertex& vertex : mesh.vertices) {
    if (has_none(vertex)) vertex.N = {0, 0, 1};  // in no triangle
  }
  notes.push_back(place.text() + ": " + std::to_string(count) +
                  " normals of no length are replaced by smooth ones of the triangles");
}

void add_noted_tangents(Mesh& mesh, const std::vector<bool>& keep, const Place& place, Notes& notes) {
  std::size_t without = 0;
  for (const auto& t : mesh.triangles) {
    const bool kept = !keep.empty() && keep[t[0]] && keep[t[1]] && keep[t[2]];
    const Vec2 a = mesh.vertices[t[0]].uv, b = mesh.vertices[t[1]].uv, c = mesh.vertices[t[2]].uv;
    if (!kept && (b.x - a.x) * (c.y - a.y) == (b.y - a.y) * (c.x - a.x)) ++without;
  }
  if (without > 0) {
    notes.push_back(place.text() + ": the texture coordinates of " + std::to_string(without) +
                    " triangles have no area; the bumps on them take their direction from a neighbour, or any");
  }
  add_tangents(mesh, keep);
}

}  // namespace wrinkle

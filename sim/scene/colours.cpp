#include "sim/scene/colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace wrinkle {
namespace {

using Colour = std::array<double, 3>;
constexpr std::size_t kMostColours = 1024;  // of one object

Colour mean_of(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
  const Vec3 a = mesh.vertices[t[0]].colour, b = mesh.vertices[t[1]].colour, c = mesh.vertices[t[2]].colour;
  if (a == b && b == c) return {a.x, a.y, a.z};
  return {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, (a.z + b.z + c.z) / 3};
}

// Triangles by colour, in order of first appearance within a colour; colours in steps of 1 / `steps`, exact for 0.
std::map<Colour, std::vector<std::size_t>> by_colour(const Mesh& mesh, double steps) {
  std::map<Colour, std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    Colour colour = mean_of(mesh, mesh.triangles[i]);
    for (double& c : colour) c = steps > 0 ? std::round(c * steps) / steps : c;
    groups[colour].push_back(i);
  }
  return groups;
}

Mesh part_of(const Mesh& mesh, const std::vector<std::size_t>& triangles) {
  Mesh part;
  part.name = mesh.name;
  std::map<std::uint32_t, std::uint32_t> index_of;
  for (const std::size_t i : triangles) {
    auto& t = part.triangles.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) {
      const auto [entry, is_new] =
          index_of.try_emplace(mesh.triangles[i][c], static_cast<std::uint32_t>(part.vertices.size()));
      if (is_new) part.vertices.push_back(mesh.vertices[entry->first]);
      t[c] = entry->second;
    }
  }
  return part;
}

Vec3 product(Vec3 a, const Colour& b) { return {a.x * b[0], a.y * b[1], a.z * b[2]}; }

}  // namespace

std::vector<Object> split_by_colour(Object object, const Place& place, Notes& notes) {
  const Mesh& mesh = object.mesh;
  std::map<Colour, std::vector<std::size_t>> groups;
  for (const double steps : {0.0, 63.0, 31.0, 15.0, 7.0}) {
    groups = by_colour(mesh, steps);
    if (groups.size() <= kMostColours) break;
  }
  const bool vary = std::ranges::any_of(mesh.triangles, [&](const auto& t) {
    return mesh.vertices[t[0]].colour != mesh.vertices[t[1]].colour ||
           mesh.vertices[t[0]].colour != mesh.vertices[t[2]].colour;
  });
  if (vary) {
    notes.push_back(place.text() + ": vertex colours are not interpolated; each triangle has one of " +
                    std::to_string(groups.size()) + " colours, about the mean of its corners");
  }
  std::vector<Object> parts;
  for (const auto& [colour, triangles] : groups) {
    Object part = object;
    if (groups.size() > 1) part.mesh = part_of(mesh, triangles);
    part.material.ambient = product(object.material.ambient, colour);
    part.material.diffuse = product(object.material.diffuse, colour);
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace wrinkle

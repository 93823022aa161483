// Normals and tangents of files, where they are missing or of no use.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "golden/vertex/mesh.h"
#include "sim/scene/notes.h"

namespace wrinkle {

// Unit normals of the corners of triangles: smooth over corners with one position and one group, flat in group 0 and
// where the triangles at a corner cancel out. Corners 3i to 3i + 2 are those of triangle i.
std::vector<Vec3> corner_normals(std::span<const Vec3> positions, std::span<const std::uint64_t> groups);

// Gives every vertex whose normal has no length a smooth one of the triangles at its position, and notes how many.
void replace_normals_of_no_length(Mesh& mesh, const Place& place, Notes& notes);

// Tangents of the texture coordinates for all vertices but those of `keep`, which may be empty. Triangles whose
// coordinates give no direction are noted.
void add_noted_tangents(Mesh& mesh, const std::vector<bool>& keep, const Place& place, Notes& notes);

}  // namespace wrinkle

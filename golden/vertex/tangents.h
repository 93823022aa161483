// Tangents for meshes that come without, as MikkTSpace makes them [Mikkelsen08, "Simulation of Wrinkled Surfaces
// Revisited", section 3; the same answers as its reference implementation for triangles at 180 degrees].
#pragma once

#include <span>
#include <vector>

#include "golden/vector.h"
#include "golden/vertex/mesh.h"

namespace wrinkle {

// One corner of a triangle list. `uv` has v growing up in the image: glTF's (u, v) is fed as (u, 1 - v).
struct TangentCorner {
  Vec3 P;
  Vec3 N;  // unit
  Vec2 uv;
};

struct Tangent {
  Vec3 T{1, 0, 0};   // unit, along increasing u, at right angles to N; (1, 0, 0) where uv give no direction
  double sign = -1;  // B = sign * (N x T), along increasing v of TangentCorner::uv
};

// Tangents of a triangle list, three corners a triangle. Corners share a tangent where position, normal and uv are
// equal and the triangles are joined by edges and turned the same way in uv.
std::vector<Tangent> generate_tangents(std::span<const TangentCorner> corners);

// Gives T and sign to every vertex of the mesh from its uv (v growing down in the image), but for those marked in
// `keep`, which may be empty; a vertex whose corners get different tangents is split.
void add_tangents(Mesh& mesh, const std::vector<bool>& keep = {});

}  // namespace wrinkle

// Triangle meshes from analytic surfaces, and normals for meshes that come without.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "golden/vertex/mesh.h"
#include "golden/vertex/surface.h"

namespace wrinkle {

using Surfaces = std::vector<std::shared_ptr<const Surface>>;

// The paper's 8 x 8 x 2 triangles.
inline constexpr int kStandardDivisions = 8;

// Each surface as nu x nv x 2 triangles, counter-clockwise as seen from outside; those drawn together to a line at a
// pole are left out. Every corner carries N, T = Pu / |Pu| (its limit at a pole), sign = +1, parameter = (u, v) and
// uv = (u, 1 - v): parameters go up as seen from outside, image rows go down, and B = N x T goes up, as in glTF.
Mesh tessellate(const Surfaces& surfaces, int nu = kStandardDivisions, int nv = kStandardDivisions);

// The unit tangent along u at (u, v), at right angles to `N`; from nearby where Pu vanishes.
Vec3 surface_tangent(const Surface& surface, double u, double v, Vec3 N);

// Flat faces of size 1, each with a whole copy of the texture, centred at the origin.
Surfaces make_rectangle();                        // in the plane z = 0, facing +z
Surfaces make_wall(double width, double height);  // facing +z, standing on y = 0
Surfaces make_floor(double width, double depth);  // in the plane y = 0, facing up; the image's top is far away (-z)
Surfaces make_cube();                             // six faces, seen upright from outside, lid and base by the x axis

// The angle at `at` of a triangle with the other corners a and b.
double corner_angle(Vec3 at, Vec3 a, Vec3 b);
// Normals of the triangles themselves: every triangle gets corners of its own.
void flat_normals(Mesh& mesh);

// A unit vector at right angles to the unit vector n; as near to `wish` as can be, if that is not along n.
Vec3 perpendicular(Vec3 n, Vec3 wish);

}  // namespace wrinkle

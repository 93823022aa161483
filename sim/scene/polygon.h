// Polygons of files as triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "golden/vector.h"

namespace wrinkle {

// The triangles of a polygon in space, as indices of its corners, turned as it is. It need not be convex or flat and
// may touch itself (slits, bridges to holes, corners in line); it must not cross itself. Every corner is kept, so that
// neighbours meet it without a crack.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const Vec3> corners);

}  // namespace wrinkle

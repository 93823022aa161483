// Triangles with a tangent frame at every corner.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "golden/vector.h"
#include "golden/vertex/surface.h"

namespace wrinkle {

struct Vertex {
  Vec3 P;                // position
  Vec3 N;                // unit normal
  Vec3 T;                // unit tangent, direction of increasing u
  double sign = 1;       // B = sign * (N x T), up the image (to smaller uv.v); -1 where the image is seen mirrored
  Vec2 uv;               // texture coordinate in repeats; v grows downwards in the image, as in glTF
  Vec2 parameter;        // (u, v) on `surface`, where there is one; v grows upwards: uv = (u, 1 - v)
  Vec3 Pu, Pv;           // derivatives of P by `parameter`; 0 where there is no surface
  Vec3 colour{1, 1, 1};  // of the file, for the reader of the scene: nothing interpolates it
};

struct Mesh {
  std::string name;
  std::vector<Vertex> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  // Per triangle an index into `surfaces`; empty where the mesh has no analytic surface.
  std::vector<std::uint32_t> triangle_surface;
  std::vector<std::shared_ptr<const Surface>> surfaces;
};

}  // namespace wrinkle

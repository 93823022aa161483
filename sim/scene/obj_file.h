// A Wavefront OBJ file as it is written, every number and every reference checked.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "golden/vector.h"
#include "sim/input_error.h"
#include "sim/scene/notes.h"

namespace wrinkle {

// Indices counted from 0; -1 for none.
struct ObjCorner {
  std::int32_t position = -1, uv = -1, normal = -1;
};

struct ObjFace {
  std::uint32_t first = 0, count = 0;  // of corners
  std::int32_t material = -1;          // index into `materials`
  std::uint32_t smoothing = 0;         // group; 0 for off
  std::uint32_t shape = 0;             // the run of faces between two of o and g
  std::uint32_t object = 0;            // the run between two of o
};

struct ObjName {
  std::string name;
  Place place;  // where it is first
};

struct ObjFile {
  std::vector<Vec3> positions, normals;
  std::vector<Vec3> colours;  // of positions, in [0, 1]; empty where the file has none
  std::vector<Vec2> uvs;      // v grows up the image
  std::vector<ObjCorner> corners;
  std::vector<ObjFace> faces;
  std::vector<std::string> shapes;  // names
  std::vector<ObjName> materials;   // as used
  std::vector<ObjName> libraries;   // what stands behind mtllib
};

// What changes the picture and is not read is noted. Bad numbers and references are InputErrors with line and column.
ObjFile parse_obj(const std::string& file, std::string_view text, Notes& notes);

}  // namespace wrinkle

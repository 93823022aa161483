// Wavefront OBJ and MTL files, line by line, before tinyobjloader sees them: it takes what is no number for 0 and
// reports no lines.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace wrinkle {

struct ObjCounts {
  std::size_t positions = 0, uvs = 0, normals = 0, triangles = 0;
};

// Every v, vt, vn has its finite numbers, every corner of f exists, the counts are within the limits of a scene.
// Otherwise InputError with file, line and column.
ObjCounts check_obj(const std::string& file, std::string_view text);

// Colours, exponents and -bm multipliers are finite and in range; options and map names are tinyobjloader's to read.
void check_mtl(const std::string& file, std::string_view text);

// The names after mtllib, in order.
std::vector<std::string> material_libraries(std::string_view text);

}  // namespace wrinkle

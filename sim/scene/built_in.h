// The meshes that need no file: patch, teapot, sphere, torus, rectangle, cube, floor, wall.
#pragma once

#include <vector>

#include "golden/vertex/scene.h"
#include "sim/scene/toml_table.h"

namespace wrinkle {

// The object named by `mesh` with its tessellation and measures; as one object for each surface if so asked.
std::vector<Object> read_built_in(const TomlTable& table, bool one_per_surface);

}  // namespace wrinkle

// One [[objects]] table of a scene file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "golden/vertex/scene.h"
#include "sim/scene/model.h"
#include "sim/scene/notes.h"
#include "sim/scene/toml_table.h"

namespace wrinkle {

// The objects that the table stands for: one; as many as a model file has; or, with Eq. 3-6, one for each surface,
// since each has normals of its own. `maps` gets what their textures hold.
std::vector<Object> read_toml_objects(const std::string& file, const toml::table& table, Notes& notes, Maps& maps);

}  // namespace wrinkle

// Colours of vertices, which the datapaths do not interpolate.
#pragma once

#include <vector>

#include "golden/vertex/scene.h"
#include "sim/scene/notes.h"

namespace wrinkle {

// One object for each colour that the triangles of `object` have (Vertex::colour, the mean of the corners), its
// material multiplied by it; the object itself where all are white. That a triangle has one colour is noted where its
// corners differ.
std::vector<Object> split_by_colour(Object object, const Place& place, Notes& notes);

}  // namespace wrinkle

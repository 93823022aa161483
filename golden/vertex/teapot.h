// Martin Newell's teapot (1975).
#pragma once

#include <memory>
#include <vector>

#include "golden/vertex/surface.h"

namespace wrinkle {

// Its 28 bicubic patches: rim 0-3, body 4-11, handle 12-15, spout 16-19, lid 20-27. y is up, the base at y = 0, the
// tip of the lid at y = 0.85, the spout towards +x. The lid's tip is a pole (v = 1).
std::vector<std::shared_ptr<const Surface>> teapot();

}  // namespace wrinkle

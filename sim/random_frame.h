// Frames of seeded random triangles: every size, both windings, off-screen, slivers; several draws and textures.
#pragma once

#include <cstdint>

#include "golden/config.h"
#include "golden/triangle/draw.h"

namespace wrinkle {

// About `fragments` of them, at least one draw. The same seed gives the same frame.
Frame random_frame(const Config& config, std::uint64_t seed, std::uint64_t fragments);

}  // namespace wrinkle

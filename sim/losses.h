// What a configuration takes from a scene, and why a picture is empty: in words, for the user.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "golden/config/config.h"
#include "golden/triangle/draw.h"
#include "golden/vertex/scene.h"

namespace wrinkle {

// What the scene has and the configuration does not draw, each with the parameter that it is for.
std::vector<std::string> losses(const Config& config, const Scene& scene);

// Why no pixel was drawn: everything turned away, outside of the picture, too near, too far or too small.
std::string why_empty(const Scene& scene);

// Runs `draw`. Where set-up refuses a triangle of the frame of `scene`, the error becomes an InputError that names the
// object and what to do.
void with_objects_named(const Config& config, const Scene& scene, const Frame& frame,
                        const std::function<void()>& draw);

}  // namespace wrinkle

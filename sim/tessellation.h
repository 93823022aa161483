// Method error against tessellation: what the per-vertex part of the method costs, and what more triangles buy.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace wrinkle {

// Draws the paper's patch, smooth (Fig. 1) and with the pinwheel (Fig. 6), in 4x4 to 32x32 squares of two triangles by
// ideal, exact and golden; prints a row for each and returns them as an array of {scene, divisions, triangles,
// psnr_method_db, max_error_method, psnr_precision_db}.
nlohmann::json tessellation_table();

}  // namespace wrinkle

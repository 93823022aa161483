// Method error against tessellation: what the per-vertex part of the method costs, and what more triangles buy.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "golden/config/config.h"
#include "golden/triangle/draw.h"

namespace wrinkle {

// How much of the filtering of a map is in the picture.
enum class Filtering {
  kConfigured,  // as the scene and its configuration say
  // Level 0 alone, bilinear, not repeated, and no self-shadow, which `ideal` takes from the true surface. So the
  // error is that of the arithmetic at the pixel alone.
  kLevelZero,
};

// A scene of the paper's patch, divided anew.
struct DividedPatch {
  std::string scene;
  std::string config;  // empty: what the scene names
  int divisions = 8;   // squares along each side, two triangles each
  int size = 512;      // of the square picture, in pixels
  Filtering filtering = Filtering::kConfigured;
};

struct DividedFrame {
  std::string config_name;
  Config config;
  Frame frame;
  std::size_t triangles = 0;
};
DividedFrame divided_frame(const DividedPatch& patch);

// {scene, config, divisions, triangles, psnr_method_db, max_error_method, psnr_precision_db}: exact against ideal, and
// golden against exact, over covered pixels.
nlohmann::json method_error(const DividedPatch& patch);

// Draws the paper's patch, smooth (Fig. 1) and with the pinwheel (Fig. 6), in 4x4 to 32x32 squares of two triangles, at
// 1024 by 1024; prints a row for each and returns what method_error() says of them.
nlohmann::json tessellation_table();

// Every datapath of the paper in 4x4 to 32x32 squares, with both filterings, `size` pixels wide: an array of what
// method_error() says, with `method` (fig1, fig2, fig2_held, fig3_eq3-6, fig3_eq8-11) and `filtering` (configured,
// level0).
nlohmann::json method_table(int size);

}  // namespace wrinkle

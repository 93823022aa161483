#include "sim/datapaths.h"

namespace wrinkle {

std::vector<DatapathFrame> datapath_frames() {
  return {
      {0, {"phong", "patch_fig1", "phong", {}}},
      {0, {"normal_map", "patch_fig6", "standard", {}}},
      {0, {"after", "patch_fig6", "standard", {"normalize_order=after", "self_shadow=off"}}},
      {0, {"no_normalizer", "patch_fig6", "standard", {"normalizer_l=none", "normalizer_h=none"}}},
      {0, {"compact", "patch_fig6", "compact", {}}},
      {0, {"lite", "patch_fig6", "standard", {"normalizer_n=lite", "normalizer_l=lite", "normalizer_h=lite"}}},
      {0, {"near", "patch_fig6", "standard", {"normalizer_l=near", "normalizer_h=near"}}},
      {0, {"sharing", "patch_fig6", "standard", {"sharing=on"}}},
      {0, {"single_buffering", "patch_fig6", "standard", {"buffering=single"}}},
      {0, {"smallest", "patch_fig6", "smallest", {}}},
      {0, {"offset", "patch_offset", "offset", {}}},
      {1, {"blinn", "patch_fig5", "blinn", {}}},
      {1, {"blinn_draw_exponent", "patch_fig5", "blinn", {"block_exponent=draw"}}},
      {1, {"blinn_constant", "patch_fig5", "blinn_constant", {}}},
      {2, {"object_space", "patch_object", "standard", {}}},
      {2, {"object_space_constant", "patch_object", "object_constant", {}}},
      {3, {"independence_patch", "independence_patch", "", {}}},
      {3, {"independence_rectangle", "independence_rectangle", "", {}}},
      {3, {"independence_sphere", "independence_sphere", "", {}}},
      {3, {"independence_torus", "independence_torus", "", {}}},
      {3, {"independence_revolution", "independence_revolution", "", {}}},
      {4, {"rotated", "patch_rotated", "rotated", {}}},
      {5, {"reflection", "patch_reflection", "reflection", {}}},
      {5, {"pixel_halfangle", "patch_pixel_halfangle", "pixel_halfangle", {}}},
      {5, {"gloss", "patch_gloss", "gloss", {}}},
      {6, {"fig5", "patch_fig5", "blinn", {}}},
      {6, {"fig6", "patch_fig6", "standard", {}}},
      {6, {"fig7", "patch_fig7", "standard", {}}},
  };
}

}  // namespace wrinkle

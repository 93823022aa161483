// A Wavefront MTL file as it is written.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "golden/vector.h"
#include "sim/input_error.h"
#include "sim/scene/notes.h"

namespace wrinkle {

// A map and those of its options that are applied.
struct MtlMap {
  std::string name;
  Place place;
  double multiplier = 1;        // -bm
  double base = 0, gain = 1;    // -mm: a value c is read as base + gain * c
  Vec2 offset, scale{1, 1};     // -o, -s: of texture coordinates, v up
  std::optional<char> channel;  // -imfchan: r, g, b, m (matte), l (luminance) or z
  bool clamp = false;
};

struct MtlMaterial {
  std::string name;
  Place place;
  std::optional<Vec3> ambient, diffuse, specular;  // within [0, 1]
  std::optional<double> exponent;
  std::optional<MtlMap> colour_map, gloss_map, bump_map, normal_map;
};

// What changes the picture and is not applied, and keywords without values, are noted.
std::vector<MtlMaterial> parse_mtl(const std::string& file, std::string_view text, Notes& notes);

}  // namespace wrinkle

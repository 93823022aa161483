// The twins in the order of the stages.
#pragma once

#include <optional>

#include "golden/exact/exact.h"
#include "golden/exact/interpolate.h"
#include "golden/exact/output.h"
#include "golden/triangle/corners.h"

namespace wrinkle::exact {

// What the stages of one draw need to know.
struct DrawContext {
  const Config& config;
  DrawWords words;
  Reflectance reflectance;
  Vec3 l, h;                              // constant light vectors
  const ExactTexture* texture = nullptr;  // null where no texel is fetched
};
DrawContext draw_context(const Config& config, const Frame& frame, const Draw& draw);

// `interpolate`, `perspective` and `texture`: fills the fragment up to texture_n and decal.
void fetch(const DrawContext& draw, const Attributes& attributes, const Weights& weights, ExactFragment& fragment);

// `perturb` to `output`.
void shade(const DrawContext& draw, ExactFragment& fragment);

// Calls visit(draw, triangle, corners, weights, fragment) for every pixel of a frame, in order of triangles and, within
// one, of rows; the fragment is filled as by fetch().
template <class Visit>
void for_each_fragment(const Config& config, const Frame& frame, Visit&& visit) {
  for (std::uint32_t index = 0; index < frame.draws.size(); ++index) {
    const DrawContext draw = draw_context(config, frame, frame.draws[index]);
    for (const ScreenTriangle& triangle : frame.draws[index].triangles) {
      const Corners corners = sort_corners(config, triangle);
      const Barycentric barycentric(config, corners);
      std::optional<Attributes> attributes;  // made at the first pixel: what covers none need not fit the formats
      scan(config, corners, frame.width, frame.height, [&](int y, int first, int end) {
        if (!attributes) attributes.emplace(config, corners, draw.words);
        for (int x = first; x < end; ++x) {
          ExactFragment fragment;
          fragment.x = x;
          fragment.y = y;
          fragment.triangle = triangle.id;
          fragment.draw = index;
          const Weights weights = barycentric.at(x, y);
          fetch(draw, *attributes, weights, fragment);
          visit(draw, triangle, corners, weights, fragment);
        }
      });
    }
  }
}

}  // namespace wrinkle::exact

// The twins in the order of the stages, over fragments in columns.
#pragma once

#include <optional>

#include "golden/exact/exact.h"
#include "golden/exact/fragments.h"
#include "golden/exact/interpolate.h"
#include "golden/exact/output.h"
#include "golden/stages.h"
#include "golden/triangle/corners.h"

namespace wrinkle::exact {

// What the stages of one draw need to know.
struct DrawContext {
  const Shape& config;
  DrawWords words;
  Reflectance reflectance;
  Vec3 l, h;                              // constant light vectors
  const ExactTexture* texture = nullptr;  // null where no texel is fetched
};
DrawContext draw_context(const Shape& config, const Frame& frame, const Draw& draw);

// One triangle, ready to be interpolated. What its corners hold is made at the first pixel: a triangle that covers none
// need not fit the formats.
class Interpolator {
 public:
  Interpolator(const Shape& config, const ScreenTriangle& triangle);

  const ScreenTriangle& triangle() const { return *triangle_; }
  const Corners& corners() const { return corners_; }
  Weights weights(int x, int y) const { return barycentric_.at(x, y); }
  bool covers(int x, int y) const;

  // `scan` and `interpolate` of the pixel (x, y): the fragment i, which has all other values as fragment.def has them.
  void put(const DrawContext& draw, int x, int y, std::size_t i, Fragments& batch);

 private:
  const Shape* config_;
  const ScreenTriangle* triangle_;
  Corners corners_;
  Barycentric barycentric_;
  std::optional<Attributes> attributes_;
};

// The stages behind `interpolate`, each of all fragments of a batch: what it reads must be there. `light` is its dot
// products and all that follows them.
void perspective(const DrawContext& draw, Fragments& batch);
void texture(const DrawContext& draw, const ExactTexture* texels, Fragments& batch);
void perturb(const DrawContext& draw, Fragments& batch);
void normalize(const DrawContext& draw, Fragments& batch);
void dots(const DrawContext& draw, Fragments& batch);
void power(const DrawContext& draw, Fragments& batch);
void output(const DrawContext& draw, Fragments& batch);

// Runs those of the `stages` that are behind `interpolate`.
void run_stages(const DrawContext& draw, unsigned stages, Fragments& batch);

// Calls put(draw, triangle, x, y, i, batch) for every pixel of a frame, in order of triangles and, within one, of rows,
// to fill in fragment i; and done(draw, batch) for each full or final batch of a draw.
template <class Put, class Done>
void for_each_batch(const Shape& config, const Frame& frame, Put&& put, Done&& done) {
  Fragments batch;
  for (std::uint32_t index = 0; index < frame.draws.size(); ++index) {
    const DrawContext draw = draw_context(config, frame, frame.draws[index]);
    const auto flush = [&] {
      if (batch.count > 0) done(draw, batch);
      batch.count = 0;
    };
    batch.draw = index;
    for (const ScreenTriangle& triangle : frame.draws[index].triangles) {
      Interpolator interpolator(config, triangle);
      scan(config, interpolator.corners(), frame.width, frame.height, [&](int y, int first, int end) {
        for (int x = first; x < end; ++x) {
          if (batch.count == kColumnLength) flush();
          put(draw, interpolator, x, y, static_cast<std::size_t>(batch.count++), batch);
        }
      });
    }
    flush();
  }
}

}  // namespace wrinkle::exact

#include "golden/exact/exact.h"

#include "golden/exact/pipeline.h"

namespace wrinkle {

void draw_exact(const Config& config, const Frame& frame, const ExactSink& sink) {
  exact::for_each_fragment(config, frame,
                           [&](const exact::DrawContext& draw, const ScreenTriangle&, const Corners&,
                               const exact::Weights&, ExactFragment& fragment) {
                             exact::shade(draw, fragment);
                             sink(fragment);
                           });
}

}  // namespace wrinkle

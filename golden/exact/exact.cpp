#include "golden/exact/exact.h"

#include "golden/exact/pipeline.h"

namespace wrinkle {

void draw_exact(const Config& config, const Frame& frame, const ExactSink& sink) {
  const auto put = [](const exact::DrawContext& draw, exact::Interpolator& triangle, int x, int y, std::size_t i,
                      exact::Fragments& batch) { triangle.put(draw, x, y, i, batch); };
  exact::for_each_batch(Shape(config), frame, put, [&](const exact::DrawContext& draw, exact::Fragments& batch) {
    exact::run_stages(draw, kAllStages, batch);
    for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i) sink(batch.fragment(i));
  });
}

}  // namespace wrinkle

// The stages in pipeline order.
#if defined(GOLDEN_PIXEL_STAGES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOLDEN_PIXEL_STAGES_INL_H_
#undef GOLDEN_PIXEL_STAGES_INL_H_
#else
#define GOLDEN_PIXEL_STAGES_INL_H_
#endif

#include "golden/pixel/interpolate-inl.h"
#include "golden/pixel/light-inl.h"
#include "golden/pixel/normalize-inl.h"
#include "golden/pixel/output-inl.h"
#include "golden/pixel/perspective-inl.h"
#include "golden/pixel/perturb-inl.h"
#include "golden/pixel/scan-inl.h"
#include "golden/pixel/stages.h"
#include "golden/pixel/texture-inl.h"

HWY_BEFORE_NAMESPACE();
namespace wrinkle {
namespace HWY_NAMESPACE {

template <class L>
void run(const L& l, const Context& c, unsigned stages, const Spans<typename L::Int>& spans,
         Batch<typename L::Int>& batch) {
  if (stages & kScan) scan(l, c, spans, batch);
  if (stages & kInterpolate) interpolate(l, c, spans, batch);
  if (stages & kPerspective) perspective(l, c, batch);
  if (stages & kTexture) texture(l, c, batch);
  if (stages & kPerturb) perturb(l, c, batch);
  if (stages & kNormalize) normalize(l, c, batch);
  if (stages & kLight) light(l, c, batch);
  if (stages & kOutput) output(l, c, batch);
}

}  // namespace HWY_NAMESPACE
}  // namespace wrinkle
HWY_AFTER_NAMESPACE();

#endif  // GOLDEN_PIXEL_STAGES_INL_H_

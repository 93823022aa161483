// perturb: the multiplexer of [Peercy97 fig. 3].
#if defined(GOLDEN_PIXEL_PERTURB_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOLDEN_PIXEL_PERTURB_INL_H_
#undef GOLDEN_PIXEL_PERTURB_INL_H_
#else
#define GOLDEN_PIXEL_PERTURB_INL_H_
#endif

#include "golden/pixel/context.h"
#include "golden/pixel/lanes-inl.h"
#include "golden/pixel/pixel.h"

HWY_BEFORE_NAMESPACE();
namespace wrinkle {
namespace HWY_NAMESPACE {

template <class L>
void perturb(const L& l, const Context& c, Batch<typename L::Int>& batch) {
  const auto& n = c.config.has_bump() && c.draw.bump ? batch.texture_n : batch.interpolate_n;
  for (std::size_t k = 0; k < 3; ++k)
    for (int i = 0; i < batch.count; i += l.size())
      l.store(l.load(&n[k][static_cast<std::size_t>(i)]), &batch.perturb_n[k][static_cast<std::size_t>(i)]);
}

}  // namespace HWY_NAMESPACE
}  // namespace wrinkle
HWY_AFTER_NAMESPACE();

#endif  // GOLDEN_PIXEL_PERTURB_INL_H_

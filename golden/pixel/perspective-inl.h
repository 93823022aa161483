// perspective: u = (u q) / q, v = (v q) / q by the table of reciprocal.h.
#if defined(GOLDEN_PIXEL_PERSPECTIVE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOLDEN_PIXEL_PERSPECTIVE_INL_H_
#undef GOLDEN_PIXEL_PERSPECTIVE_INL_H_
#else
#define GOLDEN_PIXEL_PERSPECTIVE_INL_H_
#endif

#include "golden/pixel/context.h"
#include "golden/pixel/lanes-inl.h"
#include "golden/pixel/pixel.h"

HWY_BEFORE_NAMESPACE();
namespace wrinkle {
namespace HWY_NAMESPACE {

// reciprocal() of golden/pixel/reciprocal.h, lane by lane.
template <class L>
HWY_INLINE typename L::V reciprocal(const L& l, const Constants<typename L::Int>& c, typename L::V m) {
  const ReciprocalGeometry& g = c.reciprocal;
  const int n = g.offset_bits();
  const auto index = l.and_(l.sar(m, n), l.set((1 << g.segment_bits()) - 1));
  const auto dx = l.and_(m, l.set((1 << n) - 1));
  const auto base = l.lookup(c.reciprocal_base, index);
  const auto slope = l.lookup(c.reciprocal_slope, index);
  const auto r = l.sar(l.sub(l.shl(base, n), l.mul_half(slope, dx)), n + kReciprocalGuard);
  return l.min(r, l.set((2 << g.output_bits) - 1));
}

template <class L>
void perspective(const L& l, const Context& context, Batch<typename L::Int>& batch) {
  const auto c = context.constants<typename L::Int>();
  if (!c.config.textured || c.config.perspective == 0) return;
  const int wrap = L::kBits - c.config.uv_width;
  for (int i = 0; i < batch.count; i += l.size()) {
    const auto q = l.max(l.load(&batch.interpolate_q[0][static_cast<std::size_t>(i)]), l.set(1));
    const auto leading_zeros = l.sub(l.set(c.config.q_bits - 1), l.floor_log2(q));
    const auto r = reciprocal(l, c, l.shl_each(q, leading_zeros));
    // R - lz may be 0: doubled, every shift is at least 1.
    const auto shift = l.sub(l.set(c.config.reciprocal_bits + 1), leading_zeros);
    const auto divide = [&](const auto& in, auto& out) HWY_ATTR {
      const auto product = l.mul(l.load(&in[0][static_cast<std::size_t>(i)]), r);
      const auto rounded = round_half_up_each(l, l.shl(product, 1), shift);
      l.store(l.sar_modular(l.shl_modular(rounded, wrap), wrap), &out[0][static_cast<std::size_t>(i)]);
    };
    divide(batch.interpolate_u, batch.perspective_u);
    divide(batch.interpolate_v, batch.perspective_v);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace wrinkle
HWY_AFTER_NAMESPACE();

#endif  // GOLDEN_PIXEL_PERSPECTIVE_INL_H_

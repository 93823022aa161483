// perturb: the multiplexer of [Peercy97 fig. 3], or the two scalings and the sum of fig. 2.
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
void select_normal(const L& l, const Context& c, Batch<typename L::Int>& batch) {
  const auto& n = c.config.bump_components != 0 && c.draw.bump ? batch.texture_n : batch.interpolate_n;
  for (std::size_t k = 0; k < 3; ++k)
    for (int i = 0; i < batch.count; i += l.size())
      l.store(l.load(&n[k][static_cast<std::size_t>(i)]), &batch.perturb_n[k][static_cast<std::size_t>(i)]);
}

// N' = A - fu B - fv C [Peercy97 eq. 1-2].
template <class L>
void displace_normal(const L& l, const Context& context, Batch<typename L::Int>& batch) {
  const auto c = context.constants<typename L::Int>();
  const int gb = c.config.gradient_bits;
  const typename L::Int limit = typename L::Int{4} << c.config.wide_bits;
  for (int first = 0; first < batch.count; first += l.size()) {
    const auto i = static_cast<std::size_t>(first);
    const auto slope = [&](std::size_t k)
                           HWY_ATTR { return c.draw.bump ? l.load(&batch.texture_gradient[k][i]) : l.set(0); };
    const auto fu = slope(0), fv = slope(1);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto along_u = l.mul(l.load(&batch.interpolate_b[k][i]), fu);
      const auto along_v = l.mul(l.load(&batch.interpolate_c[k][i]), fv);
      const auto n = l.sub(l.sub(l.shl(l.load(&batch.interpolate_a[k][i]), gb), along_u), along_v);
      l.store(saturate(l, round_half_up(l, n, gb), -limit, limit - 1), &batch.perturb_n[k][i]);
    }
  }
}

template <class L>
void perturb(const L& l, const Context& c, Batch<typename L::Int>& batch) {
  if (c.config.frame_vectors > 1)
    displace_normal(l, c, batch);
  else if (c.config.normal_width != 0)
    select_normal(l, c, batch);
}

}  // namespace HWY_NAMESPACE
}  // namespace wrinkle
HWY_AFTER_NAMESPACE();

#endif  // GOLDEN_PIXEL_PERTURB_INL_H_

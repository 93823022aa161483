// light: N.L, N.H, (N.H)^n by squarings, self-shadow.
#if defined(GOLDEN_PIXEL_LIGHT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOLDEN_PIXEL_LIGHT_INL_H_
#undef GOLDEN_PIXEL_LIGHT_INL_H_
#else
#define GOLDEN_PIXEL_LIGHT_INL_H_
#endif

#include "golden/pixel/context.h"
#include "golden/pixel/lanes-inl.h"
#include "golden/pixel/pixel.h"

HWY_BEFORE_NAMESPACE();
namespace wrinkle {
namespace HWY_NAMESPACE {

template <class L, class Columns>
HWY_INLINE typename L::V clamped_dot(const L& l, const Config& c, const Columns& a, const Columns& b, std::size_t i) {
  const auto element = [&](const Columns& v, std::size_t k) HWY_ATTR { return l.load(&v[k][i]); };
  const auto signed_dot =
      l.dot(element(a, 0), element(a, 1), element(a, 2), element(b, 0), element(b, 1), element(b, 2));
  const auto dot = l.max(signed_dot, l.set(0));
  return l.min(round_half_up(l, dot, 2 * c.unit_bits - c.dot_bits), l.set(1 << c.dot_bits));
}

template <class L>
HWY_INLINE typename L::V power(const L& l, const Constants<typename L::Int>& c, typename L::V nh) {
  if (c.draw.exponent_zero) return l.set(1 << c.config.power_bits);
  auto p = l.shl(nh, c.config.power_bits - c.config.dot_bits);
  for (int k = 0; k < c.draw.squarings; ++k) p = round_half_up(l, l.mul_half(p, p), c.config.power_bits);
  return p;
}

// The factor of light that the unperturbed surface lets through, u1.DF.
template <class L>
HWY_INLINE typename L::V shadow_factor(const L& l, const Constants<typename L::Int>& c, typename L::V lz,
                                       typename L::V nl) {
  const auto one = l.set(1 << c.config.dot_bits);
  const auto zero = l.set(0);
  const auto tangent = l.min(round_half_up(l, l.max(lz, zero), c.config.unit_bits - c.config.dot_bits), one);
  const auto source = c.config.has_bump() && c.draw.bump ? tangent : nl;
  if (c.config.self_shadow == static_cast<int>(SelfShadow::kHard)) return l.select(l.less(zero, source), one, zero);
  return l.min(l.shl(source, 3), one);
}

template <class L>
void light(const L& l, const Context& context, Batch<typename L::Int>& batch) {
  const auto c = context.constants<typename L::Int>();
  const bool shadow = c.draw.shadow && c.config.self_shadow != static_cast<int>(SelfShadow::kOff);
  const int df = c.config.dot_bits;
  for (int first = 0; first < batch.count; first += l.size()) {
    const auto i = static_cast<std::size_t>(first);
    const auto nl = clamped_dot(l, c.config, batch.normalize_n, batch.normalize_l, i);
    const auto factor = shadow ? shadow_factor(l, c, l.load(&batch.normalize_l[2][i]), nl) : l.set(1 << df);
    l.store(nl, &batch.light_nl[0][i]);
    l.store(shadow ? round_half_up(l, l.mul_half(nl, factor), df) : nl, &batch.light_diffuse[0][i]);
    if (!c.config.has_halfangle()) continue;
    const auto nh = clamped_dot(l, c.config, batch.normalize_n, batch.normalize_h, i);
    const auto p = power(l, c, nh);
    l.store(nh, &batch.light_nh[0][i]);
    if (!shadow) {
      l.store(p, &batch.light_specular[0][i]);
    } else {
      const auto lit = round_half_up(l, l.mul_half(p, factor), df);
      l.store(l.select(l.less(l.set(0), nl), lit, l.set(0)), &batch.light_specular[0][i]);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace wrinkle
HWY_AFTER_NAMESPACE();

#endif  // GOLDEN_PIXEL_LIGHT_INL_H_

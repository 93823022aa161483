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

// Exact, 2F fraction bits.
template <class L>
HWY_INLINE typename L::V dot_product(const L& l, Columns<typename L::Int> a, Columns<typename L::Int> b,
                                     std::size_t i) {
  const auto element = [&](Columns<typename L::Int> v, std::size_t k) HWY_ATTR { return l.load(&v[k][i]); };
  return l.dot(element(a, 0), element(a, 1), element(a, 2), element(b, 0), element(b, 1), element(b, 2));
}

// A cosine with 2F fraction bits to u1.DF.
template <class L>
HWY_INLINE typename L::V clamped(const L& l, const Shape& c, typename L::V cosine) {
  const auto positive = round_half_up(l, l.max(cosine, l.set(0)), 2 * c.unit_bits - c.dot_bits);
  return l.min(positive, l.set(1 << c.dot_bits));
}

// The cosine of two vectors that are not of unit length: their mantissas' dot product by the product of their scales.
template <class L, class Batch>
HWY_INLINE typename L::V scaled_dot(const L& l, const Shape& c, const Batch& batch, bool is_h, std::size_t i) {
  const auto dot = dot_product(l, batch.normalize_n, is_h ? batch.normalize_h : batch.normalize_l, i);
  const int bits = c.dot_bits;
  const auto d = round_half_up(l, l.max(dot, l.set(0)), 2 * c.unit_bits - bits);
  const auto product =
      l.mul_half(l.load(&batch.normalize_scale[0][i]), l.load(&batch.normalize_scale[is_h ? 2 : 1][i]));
  const auto scale = round_half_up(l, product, 2 * c.scale_bits - bits);
  return l.min(round_half_up(l, l.mul_half(d, scale), bits), l.set(1 << bits));
}

// R.E of the reflection R = 2 (N.L) N - L of the light; 0 where the light is below the surface.
template <class L, class Batch>
HWY_INLINE typename L::V reflected(const L& l, const Shape& c, const Batch& batch, std::size_t i) {
  const auto n_l = dot_product(l, batch.normalize_n, batch.normalize_l, i);
  const auto n_e = dot_product(l, batch.normalize_n, batch.normalize_h, i);
  const auto l_e = dot_product(l, batch.normalize_l, batch.normalize_h, i);
  const typename L::Int one = typename L::Int{1} << c.unit_bits;
  const auto unit = [&](typename L::V x) HWY_ATTR { return saturate(l, round_half_up(l, x, c.unit_bits), -one, one); };
  const auto r = l.sub(l.shl(l.mul(unit(n_l), unit(n_e)), 1), l_e);
  return l.select(l.less(l.set(0), n_l), clamped(l, c, r), l.set(0));
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
  const auto source = c.config.surface_is_z != 0 && c.draw.bump ? tangent : nl;
  if (c.config.self_shadow == static_cast<int>(SelfShadow::kHard)) return l.select(l.less(zero, source), one, zero);
  return l.min(l.shl(source, 3), one);
}

template <class L>
void light(const L& l, const Context& context, Batch<typename L::Int>& batch) {
  const auto c = context.constants<typename L::Int>();
  const bool shadow = c.draw.shadow && c.config.self_shadow != static_cast<int>(SelfShadow::kOff);
  const bool reflection = c.config.is(Lighting::kReflection);
  const bool after = c.config.normalizes_after;
  const int df = c.config.dot_bits;
  for (int first = 0; first < batch.count; first += l.size()) {
    const auto i = static_cast<std::size_t>(first);
    const auto nl = after ? scaled_dot(l, c.config, batch, false, i)
                          : clamped(l, c.config, dot_product(l, batch.normalize_n, batch.normalize_l, i));
    const auto factor = shadow ? shadow_factor(l, c, l.load(&batch.normalize_l[2][i]), nl) : l.set(1 << df);
    l.store(nl, &batch.light_nl[0][i]);
    l.store(shadow ? round_half_up(l, l.mul_half(nl, factor), df) : nl, &batch.light_diffuse[0][i]);
    if (!c.config.glossy) continue;
    const auto nh = after        ? scaled_dot(l, c.config, batch, true, i)
                    : reflection ? reflected(l, c.config, batch, i)
                                 : clamped(l, c.config, dot_product(l, batch.normalize_n, batch.normalize_h, i));
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

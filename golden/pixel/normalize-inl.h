// normalize: N, L and H to unit length, each by its own unit.
#if defined(GOLDEN_PIXEL_NORMALIZE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOLDEN_PIXEL_NORMALIZE_INL_H_
#undef GOLDEN_PIXEL_NORMALIZE_INL_H_
#else
#define GOLDEN_PIXEL_NORMALIZE_INL_H_
#endif

#include <algorithm>

#include "golden/pixel/compact-inl.h"
#include "golden/pixel/context.h"
#include "golden/pixel/lanes-inl.h"
#include "golden/pixel/pixel.h"

HWY_BEFORE_NAMESPACE();
namespace wrinkle {
namespace HWY_NAMESPACE {

// rsqrt() of golden/pixel/rsqrt.h, lane by lane.
template <bool kIsSmall, class L>
HWY_INLINE typename L::V rsqrt(const L& l, const Constants<typename L::Int>& c, typename L::V t) {
  const RsqrtGeometry& g = c.rsqrt;
  const int n = g.offset_bits(), k = g.segment_bits;
  const auto half = l.sar(t, g.input_bits - 1);
  const auto x = l.select(l.equal(half, l.set(0)), l.shl(t, 1), t);
  const auto index = l.or_(l.shl(half, k), l.and_(l.sar(x, n), l.set((1 << k) - 1)));
  const auto dx = l.and_(x, l.set((1 << n) - 1));
  const auto segment = kIsSmall ? l.lookup32(c.rsqrt_table, index) : l.lookup(c.rsqrt_table, index);
  const auto base = l.add(l.shr_modular(segment, kSlopeBits), l.set(1 << (g.output_bits + g.guard_bits)));
  const auto slope = l.and_(segment, l.set((1 << kSlopeBits) - 1));
  const auto r = l.sar(l.sub(l.shl(base, n), l.mul_half(slope, dx)), n + g.guard_bits);
  return l.min(r, l.set((2 << g.output_bits) - 1));
}

// A unit takes vectors in s1.V and hands on unit vectors in s1.F.
struct UnitShape {
  int input_bits;  // V
  int unit_bits;   // F

  int magnitude_bits() const { return input_bits + 1; }
  // Bits of the mantissa of a vector that is normalized after: of the magnitude the leading F.
  int mantissa_bits() const { return std::min(magnitude_bits(), unit_bits); }
};

template <bool kIsSmall, class L>
HWY_INLINE Triple<L> normalize_faithful(const L& l, const Constants<typename L::Int>& c, UnitShape unit,
                                        const Triple<L>& v) {
  const RsqrtGeometry& g = c.rsqrt;
  const int p = unit.magnitude_bits();
  const auto limit = l.set((1 << p) - 1);
  const auto zero = l.set(0);
  const auto magnitude = [&](typename L::V a) HWY_ATTR { return l.min(l.abs(a), limit); };
  Triple<L> m{magnitude(v.x), magnitude(v.y), magnitude(v.z)};
  const auto any = l.or_(l.or_(m.x, m.y), m.z);
  const auto shift = l.sub(l.set(p - 1), l.floor_log2(l.max(any, l.set(1))));
  m = {l.shl_each(m.x, shift), l.shl_each(m.y, shift), l.shl_each(m.z, shift)};
  const auto sum = l.add(l.add(l.mul_half(m.x, m.x), l.mul_half(m.y, m.y)), l.mul_half(m.z, m.z));
  const auto one = l.set(1);
  const auto e = l.select(l.less(sum, l.shl(one, 2 * p)), zero, one);
  const int dropped = 2 * p + 2 - g.input_bits;
  const int padded = std::max(-dropped, 0);
  const auto aligned = l.shl_each(sum, l.sub(l.set(2 + padded), l.add(e, e)));
  const auto r = rsqrt<kIsSmall>(l, c, l.sar(aligned, std::max(dropped, 0)));
  const int down = p + g.output_bits - unit.unit_bits;
  const auto half = l.shl_each(l.set(1 << (down - 1)), e);
  const auto shift_down = l.add(l.set(down), e);
  const auto scale = [&](typename L::V a, typename L::V sign_of) HWY_ATTR {
    const auto n = l.sar_each(l.add(l.mul_half(a, r), half), shift_down);
    return l.select(l.less(sign_of, zero), l.sub(zero, n), n);
  };
  return {scale(m.x, v.x), scale(m.y, v.y), scale(m.z, v.z)};
}

// A vector as s * m: mantissas of F fraction bits, the greatest in [1/2, 1), and the reciprocal of their length.
template <class L>
struct Deferred {
  Triple<L> m;
  typename L::V s;  // u1.RB
};

template <bool kIsSmall, class L>
HWY_INLINE Deferred<L> mantissa_and_scale(const L& l, const Constants<typename L::Int>& c, UnitShape unit,
                                          const Triple<L>& v) {
  const RsqrtGeometry& g = c.rsqrt;
  const int p = unit.magnitude_bits(), bits = unit.mantissa_bits();
  const auto limit = l.set((1 << p) - 1), one = l.set(1), zero = l.set(0);
  const auto magnitude = [&](typename L::V a) HWY_ATTR { return l.min(l.abs(a), limit); };
  const Triple<L> whole{magnitude(v.x), magnitude(v.y), magnitude(v.z)};
  const auto any = l.or_(l.or_(whole.x, whole.y), whole.z);
  const auto shift = l.sub(l.set(p - 1), l.floor_log2(l.max(any, one)));
  const auto leading = [&](typename L::V a) HWY_ATTR { return l.sar(l.shl_each(a, shift), p - bits); };
  const Triple<L> m{leading(whole.x), leading(whole.y), leading(whole.z)};
  const auto sum = l.add(l.add(l.mul_half(m.x, m.x), l.mul_half(m.y, m.y)), l.mul_half(m.z, m.z));
  const auto e = l.select(l.less(sum, l.shl(one, 2 * bits)), zero, one);
  const int dropped = 2 * bits + 2 - g.input_bits;
  const int padded = std::max(-dropped, 0);
  const auto aligned = l.shl_each(sum, l.sub(l.set(2 + padded), l.add(e, e)));
  const auto s = l.sar_each(rsqrt<kIsSmall>(l, c, l.sar(aligned, std::max(dropped, 0))), e);
  const auto with_sign = [&](typename L::V a, typename L::V sign_of) HWY_ATTR {
    const auto n = l.shl(a, unit.unit_bits - bits);
    return l.select(l.less(sign_of, zero), l.sub(zero, n), n);
  };
  return {{with_sign(m.x, v.x), with_sign(m.y, v.y), with_sign(m.z, v.z)}, s};
}

template <class L>
HWY_INLINE Triple<L> normalize_none(const L& l, UnitShape unit, const Triple<L>& v) {
  const int shift = unit.input_bits - unit.unit_bits;
  const typename L::Int limit = typename L::Int{2} << unit.unit_bits;
  const auto scale = [&](typename L::V a)
                         HWY_ATTR { return saturate(l, round_half_up(l, a, shift), -limit, limit - 1); };
  return {scale(v.x), scale(v.y), scale(v.z)};
}

// The vectors of the lanes from fragment i on. `zero` collects the fragments whose vector has no direction.
template <class L, class Normalize>
HWY_INLINE void normalize_at(const L& l, Columns<typename L::Int> in, Columns<typename L::Int> out,
                             Column<typename L::Int>& zero, std::size_t i, const Normalize& to_unit) {
  const Triple<L> v{l.load(&in[0][i]), l.load(&in[1][i]), l.load(&in[2][i])};
  const Triple<L> n = to_unit(v);
  l.store(n.x, &out[0][i]);
  l.store(n.y, &out[1][i]);
  l.store(n.z, &out[2][i]);
  const auto none = l.equal(l.or_(l.or_(v.x, v.y), v.z), l.set(0));
  l.store(l.select(none, l.set(1), l.load(&zero[i])), &zero[i]);
}

// One unit over the batch.
template <class L, class Normalize>
HWY_INLINE void normalize_columns(const L& l, Columns<typename L::Int> in, Columns<typename L::Int> out,
                                  Column<typename L::Int>& zero, int count, const Normalize& to_unit) {
  for (int first = 0; first < count; first += l.size())
    normalize_at(l, in, out, zero, static_cast<std::size_t>(first), to_unit);
}

template <Normalizer kKind, class L>
void normalize_columns_compact(const L& l, const Constants<typename L::Int>& c, UnitShape unit,
                               Columns<typename L::Int> in, Columns<typename L::Int> out, Column<typename L::Int>& zero,
                               int count) {
  const CompactGeometry g = compact_geometry(kKind, unit.unit_bits, unit.input_bits);
  const auto* table = kKind == Normalizer::kLite ? c.lite_rsqrt_table : c.compact_rsqrt_table;
  if ((std::size_t{2} << g.rsqrt.segment_bits) <= kSmallTable)
    normalize_columns(l, in, out, zero, count,
                      [&](const Triple<L>& v) HWY_ATTR { return normalize_compact<kKind, true>(l, g, table, v); });
  else
    normalize_columns(l, in, out, zero, count,
                      [&](const Triple<L>& v) HWY_ATTR { return normalize_compact<kKind, false>(l, g, table, v); });
}

// The kind of unit is chosen outside of its loop.
template <class L>
void normalize_unit(const L& l, const Context& context, int normalizer, int input_bits, Columns<typename L::Int> in,
                    Columns<typename L::Int> out, Column<typename L::Int>& zero, int count) {
  const auto c = context.constants<typename L::Int>();
  const UnitShape unit{input_bits, c.config.unit_bits};
  switch (static_cast<Normalizer>(normalizer)) {
    case Normalizer::kNone:
      normalize_columns(l, in, out, zero, count,
                        [&](const Triple<L>& v) HWY_ATTR { return normalize_none(l, unit, v); });
      return;
    case Normalizer::kFaithful:
      if ((std::size_t{2} << c.rsqrt.segment_bits) <= kSmallTable)
        normalize_columns(l, in, out, zero, count,
                          [&](const Triple<L>& v) HWY_ATTR { return normalize_faithful<true>(l, c, unit, v); });
      else
        normalize_columns(l, in, out, zero, count,
                          [&](const Triple<L>& v) HWY_ATTR { return normalize_faithful<false>(l, c, unit, v); });
      return;
    case Normalizer::kCompact:
      return normalize_columns_compact<Normalizer::kCompact>(l, c, unit, in, out, zero, count);
    case Normalizer::kLite:
      return normalize_columns_compact<Normalizer::kLite>(l, c, unit, in, out, zero, count);
    case Normalizer::kNear:
      return normalize_columns_compact<Normalizer::kNear>(l, c, unit, in, out, zero, count);
  }
}

// The same of a vector that is normalized after the dot products.
template <class L>
void defer_unit(const L& l, const Context& context, int input_bits, Columns<typename L::Int> in,
                Columns<typename L::Int> out, Column<typename L::Int>& scale, Column<typename L::Int>& zero,
                int count) {
  const auto c = context.constants<typename L::Int>();
  const UnitShape unit{input_bits, c.config.unit_bits};
  const bool is_small = (std::size_t{2} << c.rsqrt.segment_bits) <= kSmallTable;
  for (int first = 0; first < count; first += l.size()) {
    const auto i = static_cast<std::size_t>(first);
    const auto to_scale = [&](const Triple<L>& v) HWY_ATTR {
      const Deferred<L> d =
          is_small ? mantissa_and_scale<true>(l, c, unit, v) : mantissa_and_scale<false>(l, c, unit, v);
      l.store(d.s, &scale[i]);
      return d.m;
    };
    normalize_at(l, in, out, zero, i, to_scale);
  }
}

template <class L>
void fill_constant(const L& l, const std::array<int, 3>& v, Columns<typename L::Int> out, int count) {
  for (std::size_t k = 0; k < 3; ++k)
    for (int i = 0; i < count; i += l.size()) l.store(l.set(v[k]), &out[k][static_cast<std::size_t>(i)]);
}

// H of every pixel from unit L and E, in place of E [Peercy97 section 4]: L + E is s2.F. No flag: opposite to the light
// there is no highlight to be missed.
template <class L>
void normalize_halfangle(const L& l, const Context& c, Batch<typename L::Int>& batch) {
  std::array<Column<typename L::Int>, 3> sum;
  Column<typename L::Int> ignored{};
  for (std::size_t k = 0; k < 3; ++k)
    for (int first = 0; first < batch.count; first += l.size()) {
      const auto i = static_cast<std::size_t>(first);
      l.store(l.add(l.load(&batch.normalize_l[k][i]), l.load(&batch.normalize_h[k][i])), &sum[k][i]);
    }
  normalize_unit(l, c, c.config.normalizer_h, c.config.unit_bits + 1, Columns<typename L::Int>(sum), batch.normalize_h,
                 ignored, batch.count);
}

template <class L>
void defer(const L& l, const Context& c, Batch<typename L::Int>& batch) {
  const Shape& config = c.config;
  auto& zero = batch.normalize_zero[0];
  const auto scale = batch.normalize_scale;
  const int count = batch.count;
  defer_unit(l, c, config.normal_input_bits, batch.perturb_n, batch.normalize_n, scale[0], zero, count);
  defer_unit(l, c, config.vector_bits, batch.interpolate_l, batch.normalize_l, scale[1], zero, count);
  if (!config.glossy) return;
  defer_unit(l, c, config.vector_bits, batch.interpolate_h, batch.normalize_h, scale[2], zero, count);
}

template <class L>
void normalize(const L& l, const Context& c, Batch<typename L::Int>& batch) {
  const Shape& config = c.config;
  const int count = batch.count;
  auto& zero = batch.normalize_zero[0];
  std::fill_n(zero.begin(), count, 0);
  if (config.normalizes_after) return defer(l, c, batch);
  if (config.normal_width != 0)
    normalize_unit(l, c, config.normalizer_n, config.normal_input_bits, batch.perturb_n, batch.normalize_n, zero,
                   count);
  else
    fill_constant(l, {0, 0, 1 << config.unit_bits}, batch.normalize_n, count);
  if (config.has_light_planes) {
    normalize_unit(l, c, config.normalizer_l, config.vector_bits, batch.interpolate_l, batch.normalize_l, zero, count);
    if (config.glossy)
      normalize_unit(l, c, config.third_normalizer, config.vector_bits, batch.interpolate_h, batch.normalize_h, zero,
                     count);
  } else {
    fill_constant(l, c.draw.l, batch.normalize_l, count);
    if (config.glossy) fill_constant(l, c.draw.h, batch.normalize_h, count);
  }
  if (config.is(Lighting::kPixelHalfangle)) normalize_halfangle(l, c, batch);
}

}  // namespace HWY_NAMESPACE
}  // namespace wrinkle
HWY_AFTER_NAMESPACE();

#endif  // GOLDEN_PIXEL_NORMALIZE_INL_H_

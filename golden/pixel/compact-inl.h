// The normalizers `compact`, `lite` and `near`: squares and products without their lowest dots.
#if defined(GOLDEN_PIXEL_COMPACT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOLDEN_PIXEL_COMPACT_INL_H_
#undef GOLDEN_PIXEL_COMPACT_INL_H_
#else
#define GOLDEN_PIXEL_COMPACT_INL_H_
#endif

#include "golden/pixel/compact_geometry.h"
#include "golden/pixel/context.h"
#include "golden/pixel/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace wrinkle {
namespace HWY_NAMESPACE {

template <class L>
struct Triple {
  typename L::V x, y, z;
};

// compact_rsqrt() of golden/pixel/compact_rsqrt.h, lane by lane; `down` is added to the last shift.
template <bool kIsSmall, class L>
HWY_INLINE typename L::V compact_rsqrt(const L& l, const CompactRsqrtGeometry& g, const typename L::Int* table,
                                       typename L::V t, typename L::V down) {
  const int n = g.offset_bits(), k = g.segment_bits;
  const auto half = l.sar(t, g.input_bits - 1);
  const auto x = l.sar_each(t, half);
  const auto index = l.or_(l.shl(half, k), l.and_(l.sar(x, n), l.set((1 << k) - 1)));
  const auto segment = kIsSmall ? l.lookup32(table, index) : l.lookup(table, index);
  const auto base = l.add(l.shr_modular(segment, kSlopeBits), l.set(1 << (g.output_bits + g.guard_bits)));
  const auto slope = l.and_(segment, l.set((1 << kSlopeBits) - 1));
  const auto last = l.set((1 << n) - 1);
  const auto dx = l.sub(last, l.and_(x, last));
  auto line = l.add(l.shl(base, n), l.mul_half(slope, dx));
  const auto dropped = l.set((1 << g.dropped_columns) - 1);
  for (int i = 0; i < std::min(n, g.dropped_columns); ++i)
    line = l.sub(line, l.and_(l.mul_half(slope, l.and_(dx, l.set(1 << i))), dropped));
  return l.sar_each(line, l.add(l.set(n + g.guard_bits), down));
}

// m r >> Q: the rows' parts below the cut are taken out of the whole product.
template <class L>
HWY_INLINE typename L::V truncated_product(const L& l, const CompactGeometry& g, typename L::V m, typename L::V r) {
  auto product = l.add(l.mul_half(m, r), l.set(static_cast<typename L::Int>(g.product_constant)));
  const auto dropped = l.set((1 << g.product_cut) - 1);
  for (int i = 0; i < g.product_cut; i += 2)
    product = l.sub(product, l.and_(l.mul_half(l.and_(m, l.set(3 << i)), r), dropped));
  return l.sar(product, g.product_shift());
}

// m^2 without the square of its low bits.
template <class L>
HWY_INLINE typename L::V truncated_square(const L& l, const CompactGeometry& g, typename L::V m) {
  const auto low = l.and_(m, l.set((1 << g.square_cut) - 1));
  return l.sub(l.mul_half(m, m), l.mul_half(low, low));
}

// T of the sum of squares, and 1 where r is halved after. [docs/architecture.md, normalize]
template <Normalizer kKind, class L>
HWY_INLINE typename L::V leading_bits(const L& l, const CompactGeometry& g, typename L::V sum, typename L::V& e) {
  using Int = typename L::Int;
  const int p = g.square_bits, input_bits = g.rsqrt.input_bits;
  if constexpr (kKind == Normalizer::kNear) {
    e = l.set(0);
    const Int least = Int{1} << (input_bits - 2);
    return l.min(l.max(l.sar(sum, 2 * p - input_bits), l.set(least)), l.set(4 * least - 1));
  }
  e = l.select(l.less(sum, l.shl(l.set(1), 2 * p)), l.set(0), l.set(1));
  return l.sar_each(sum, l.add(l.set(2 * p - input_bits), l.add(e, e)));
}

// Not for `none` and `faithful`.
template <Normalizer kKind, bool kIsSmall, class L>
HWY_INLINE Triple<L> normalize_compact(const L& l, const CompactGeometry& g, const typename L::Int* table,
                                       const Triple<L>& v) {
  using Int = typename L::Int;
  const int p = g.magnitude_bits;
  const auto limit = l.set(static_cast<Int>((Int{1} << (p - g.padding)) - 1));
  const auto magnitude = [&](typename L::V a) HWY_ATTR { return l.shl(l.min(l.abs(a), limit), g.padding); };
  Triple<L> m{magnitude(v.x), magnitude(v.y), magnitude(v.z)};
  if constexpr (kKind == Normalizer::kNear) {
    const auto most = l.set(static_cast<Int>((Int{1} << p) - 1));
    const auto twice = [&](typename L::V a) HWY_ATTR { return l.min(l.shl(a, 1), most); };
    m = {twice(m.x), twice(m.y), twice(m.z)};
  } else {
    const auto any = l.or_(l.or_(m.x, m.y), m.z);
    const auto shift = l.sub(l.set(p - 1), l.floor_log2(l.max(any, l.set(1))));
    m = {l.shl_each(m.x, shift), l.shl_each(m.y, shift), l.shl_each(m.z, shift)};
  }
  const auto squared = [&](typename L::V a) HWY_ATTR { return truncated_square(l, g, l.sar(a, p - g.square_bits)); };
  const auto sum =
      l.add(l.add(squared(m.x), squared(m.y)), l.add(squared(m.z), l.set(static_cast<Int>(g.square_constant))));
  auto e = l.set(0);
  const auto t = leading_bits<kKind>(l, g, sum, e);
  const auto r = compact_rsqrt<kIsSmall>(l, g.rsqrt, table, t, e);
  const auto component = [&](typename L::V a, typename L::V sign_of) HWY_ATTR {
    const auto n = truncated_product(l, g, a, r);
    return l.select(l.less(sign_of, l.set(0)), l.sub(l.set(0), n), n);
  };
  return {component(m.x, v.x), component(m.y, v.y), component(m.z, v.z)};
}

}  // namespace HWY_NAMESPACE
}  // namespace wrinkle
HWY_AFTER_NAMESPACE();

#endif  // GOLDEN_PIXEL_COMPACT_INL_H_

// normalize: N, L and H to unit length, each by its own unit.
#if defined(GOLDEN_PIXEL_NORMALIZE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOLDEN_PIXEL_NORMALIZE_INL_H_
#undef GOLDEN_PIXEL_NORMALIZE_INL_H_
#else
#define GOLDEN_PIXEL_NORMALIZE_INL_H_
#endif

#include "golden/pixel/context.h"
#include "golden/pixel/lanes-inl.h"
#include "golden/pixel/pixel.h"

HWY_BEFORE_NAMESPACE();
namespace wrinkle {
namespace HWY_NAMESPACE {

template <class L>
struct Triple {
  typename L::V x, y, z;
};

// rsqrt() of golden/pixel/rsqrt.h, lane by lane; `down` is added to the last shift.
template <bool kIsSmall, class L>
HWY_INLINE typename L::V rsqrt(const L& l, const RsqrtGeometry& g, const typename L::Int* table, typename L::V t,
                               typename L::V down) {
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
HWY_INLINE typename L::V scale(const L& l, const NormalizerGeometry& g, typename L::V m, typename L::V r) {
  auto product = l.add(l.mul_half(m, r), l.set(static_cast<typename L::Int>(g.product_constant)));
  const auto dropped = l.set((1 << g.product_cut) - 1);
  for (int i = 0; i < g.product_cut; i += 2)
    product = l.sub(product, l.and_(l.mul_half(l.and_(m, l.set(3 << i)), r), dropped));
  return l.sar(product, g.product_shift());
}

// m^2 without the square of its low bits.
template <class L>
HWY_INLINE typename L::V square(const L& l, const NormalizerGeometry& g, typename L::V m) {
  const auto low = l.and_(m, l.set((1 << g.square_cut) - 1));
  return l.sub(l.mul_half(m, m), l.mul_half(low, low));
}

// T of the sum of squares, and 1 where r is halved after. [docs/architecture.md, normalize]
template <Normalizer kKind, class L>
HWY_INLINE typename L::V leading_bits(const L& l, const NormalizerGeometry& g, typename L::V sum, typename L::V& e) {
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

// Any kind but `none`.
template <Normalizer kKind, bool kIsSmall, class L>
HWY_INLINE Triple<L> normalize_scaled(const L& l, const NormalizerGeometry& g, const typename L::Int* table,
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
  const auto squared = [&](typename L::V a) HWY_ATTR { return square(l, g, l.sar(a, p - g.square_bits)); };
  const auto sum =
      l.add(l.add(squared(m.x), squared(m.y)), l.add(squared(m.z), l.set(static_cast<Int>(g.square_constant))));
  auto e = l.set(0);
  const auto t = leading_bits<kKind>(l, g, sum, e);
  const auto r = rsqrt<kIsSmall>(l, g.rsqrt, table, t, e);
  const auto component = [&](typename L::V a, typename L::V sign_of) HWY_ATTR {
    const auto n = scale(l, g, a, r);
    return l.select(l.less(sign_of, l.set(0)), l.sub(l.set(0), n), n);
  };
  return {component(m.x, v.x), component(m.y, v.y), component(m.z, v.z)};
}

template <class L>
HWY_INLINE Triple<L> normalize_none(const L& l, const Constants<typename L::Int>& c, const Triple<L>& v) {
  const int shift = c.config.vector_bits - c.config.unit_bits;
  const typename L::Int limit = typename L::Int{2} << c.config.unit_bits;
  const auto scale = [&](typename L::V a)
                         HWY_ATTR { return saturate(l, round_half_up(l, a, shift), -limit, limit - 1); };
  return {scale(v.x), scale(v.y), scale(v.z)};
}

// One unit over the batch. `zero` collects the fragments whose vector has no direction.
template <class L, class Columns, class Normalize>
HWY_INLINE void normalize_columns(const L& l, const Columns& in, Columns& out, typename Columns::value_type& zero,
                                  int count, const Normalize& to_unit) {
  for (int first = 0; first < count; first += l.size()) {
    const auto i = static_cast<std::size_t>(first);
    const Triple<L> v{l.load(&in[0][i]), l.load(&in[1][i]), l.load(&in[2][i])};
    const Triple<L> n = to_unit(v);
    l.store(n.x, &out[0][i]);
    l.store(n.y, &out[1][i]);
    l.store(n.z, &out[2][i]);
    const auto none = l.equal(l.or_(l.or_(v.x, v.y), v.z), l.set(0));
    l.store(l.select(none, l.set(1), l.load(&zero[i])), &zero[i]);
  }
}

template <Normalizer kKind, class L, class Columns>
void normalize_columns_scaled(const L& l, const Constants<typename L::Int>& c, int input_bits, const Columns& in,
                              Columns& out, typename Columns::value_type& zero, int count) {
  const NormalizerGeometry g = normalizer_geometry(kKind, c.config.unit_bits, input_bits);
  const auto* table = kKind == Normalizer::kLite ? c.lite_table : c.rsqrt_table;
  if ((std::size_t{2} << g.rsqrt.segment_bits) <= kSmallTable)
    normalize_columns(l, in, out, zero, count,
                      [&](const Triple<L>& v) HWY_ATTR { return normalize_scaled<kKind, true>(l, g, table, v); });
  else
    normalize_columns(l, in, out, zero, count,
                      [&](const Triple<L>& v) HWY_ATTR { return normalize_scaled<kKind, false>(l, g, table, v); });
}

// The kind of unit is chosen outside of its loop. Its input is s1.V with V = `input_bits`.
template <class L, class Columns>
void normalize_unit(const L& l, const Context& context, int normalizer, int input_bits, const Columns& in, Columns& out,
                    typename Columns::value_type& zero, int count) {
  auto c = context.constants<typename L::Int>();
  c.config.vector_bits = input_bits;
  switch (static_cast<Normalizer>(normalizer)) {
    case Normalizer::kNone:
      normalize_columns(l, in, out, zero, count, [&](const Triple<L>& v) HWY_ATTR { return normalize_none(l, c, v); });
      return;
    case Normalizer::kFaithful:
      return normalize_columns_scaled<Normalizer::kFaithful>(l, c, input_bits, in, out, zero, count);
    case Normalizer::kLite:
      return normalize_columns_scaled<Normalizer::kLite>(l, c, input_bits, in, out, zero, count);
    case Normalizer::kNear:
      return normalize_columns_scaled<Normalizer::kNear>(l, c, input_bits, in, out, zero, count);
  }
}

template <class L, class Columns>
void fill_constant(const L& l, const std::array<int, 3>& v, Columns& out, int count) {
  for (std::size_t k = 0; k < 3; ++k)
    for (int i = 0; i < count; i += l.size()) l.store(l.set(v[k]), &out[k][static_cast<std::size_t>(i)]);
}

// H of every pixel from unit L and E, in place of E [Peercy97 section 4]: L + E is s2.F. No flag: opposite to the light
// there is no highlight to be missed.
template <class L>
void normalize_halfangle(const L& l, const Context& c, Batch<typename L::Int>& batch) {
  alignas(64) std::array<typename Batch<typename L::Int>::Column, 3> sum;
  alignas(64) typename Batch<typename L::Int>::Column ignored{};
  for (std::size_t k = 0; k < 3; ++k)
    for (int first = 0; first < batch.count; first += l.size()) {
      const auto i = static_cast<std::size_t>(first);
      l.store(l.add(l.load(&batch.normalize_l[k][i]), l.load(&batch.normalize_h[k][i])), &sum[k][i]);
    }
  normalize_unit(l, c, c.config.normalizer_h, c.config.unit_bits + 1, sum, batch.normalize_h, ignored, batch.count);
}

template <class L>
void normalize(const L& l, const Context& c, Batch<typename L::Int>& batch) {
  const Config& config = c.config;
  const int count = batch.count;
  auto& zero = batch.normalize_zero[0];
  std::fill_n(zero.begin(), count, 0);
  if (config.has_normal())
    normalize_unit(l, c, config.normalizer_n, config.normal_unit_input_bits(), batch.perturb_n, batch.normalize_n, zero,
                   count);
  else
    fill_constant(l, {0, 0, 1 << config.unit_bits}, batch.normalize_n, count);
  if (config.has_light_planes()) {
    normalize_unit(l, c, config.normalizer_l, config.vector_bits, batch.interpolate_l, batch.normalize_l, zero, count);
    if (config.has_specular())
      normalize_unit(l, c, config.third_normalizer(), config.vector_bits, batch.interpolate_h, batch.normalize_h, zero,
                     count);
  } else {
    fill_constant(l, c.draw.l, batch.normalize_l, count);
    if (config.has_specular()) fill_constant(l, c.draw.h, batch.normalize_h, count);
  }
  if (config.is(Lighting::kPixelHalfangle)) normalize_halfangle(l, c, batch);
}

}  // namespace HWY_NAMESPACE
}  // namespace wrinkle
HWY_AFTER_NAMESPACE();

#endif  // GOLDEN_PIXEL_NORMALIZE_INL_H_

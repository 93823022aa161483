// texture: address, fetch, filter. Each goes over the whole batch before the next begins.
#if defined(GOLDEN_PIXEL_TEXTURE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOLDEN_PIXEL_TEXTURE_INL_H_
#undef GOLDEN_PIXEL_TEXTURE_INL_H_
#else
#define GOLDEN_PIXEL_TEXTURE_INL_H_
#endif

#include "golden/pixel/context.h"
#include "golden/pixel/fetch.h"
#include "golden/pixel/lanes-inl.h"
#include "golden/pixel/pixel.h"

HWY_BEFORE_NAMESPACE();
namespace wrinkle {
namespace HWY_NAMESPACE {

// i wrapped, as a stored position of BoundTexture: wrap(i + 1) is stored beside it.
template <class L>
HWY_INLINE typename L::V wrapped(const L& l, typename L::V i, typename L::V log2_size, int mode) {
  const auto one = l.set(1);
  const auto size = l.shl_each(one, log2_size);
  switch (static_cast<Wrap>(mode)) {
    case Wrap::kClamp:
      return l.add(l.min(l.max(i, l.set(-1)), l.sub(size, one)), one);
    case Wrap::kMirror:
      return l.and_(i, l.sub(l.add(size, size), one));
    default:
      return l.and_(i, l.sub(size, one));
  }
}

template <class L>
struct Coordinate {
  typename L::V position, weight;
};

// One coordinate at one level.
template <class L>
HWY_INLINE Coordinate<L> coordinate(const L& l, const Shape& c, typename L::V u, typename L::V level, int log2_size,
                                    int mode) {
  const int b = c.weight_fraction_bits;
  const auto w = l.max(l.sub(l.set(log2_size), level), l.set(0));
  const auto scaled = l.shl(u, c.coordinate_shift);
  const auto shift = l.sub(l.set(c.uv_bits + c.coordinate_shift - b), w);
  if (b == 0) return {wrapped(l, l.sar_each(scaled, shift), w, mode), l.set(0)};
  const auto t = l.sub(round_half_up_each(l, scaled, shift), l.set(1 << (b - 1)));
  return {wrapped(l, l.sar(t, b), w, mode), l.and_(t, l.set((1 << b) - 1))};
}

template <class L>
HWY_INLINE void address(const L& l, const Constants<typename L::Int>& c, typename L::V u, typename L::V v,
                        typename L::V level, TexelAddresses<typename L::Int>& out, std::size_t i) {
  const Coordinate<L> x = coordinate(l, c.config, u, level, c.draw.log2_width, c.draw.wrap_u);
  const Coordinate<L> y = coordinate(l, c.config, v, level, c.draw.log2_height, c.draw.wrap_v);
  const auto stride = l.lookup16(c.level_stride, level);
  const auto row = l.add(l.mul_half(y.position, stride), x.position);
  l.store(l.add(l.lookup16(c.level_offset, level), row), &out.position[i]);
  l.store(x.weight, &out.weight_u[i]);
  l.store(y.weight, &out.weight_v[i]);
}

// Level a, level b and the fraction between them, 0 outside the chain.
template <class L>
struct Levels {
  typename L::V a, b, weight;
};
template <class L>
HWY_INLINE Levels<L> mip_levels(const L& l, const Constants<typename L::Int>& c, typename L::V lod) {
  const int bits = c.config.lod_fraction_bits;
  const auto top = l.set(c.draw.max_level);
  const auto zero = l.set(0);
  const auto level = l.sar(lod, bits);
  const auto a = l.max(l.min(level, top), zero);
  const auto inside = l.select(l.less(level, top), l.and_(lod, l.set((1 << bits) - 1)), zero);
  return {a, l.max(l.min(l.add(level, l.set(1)), top), zero), l.select(l.less(lod, zero), zero, inside)};
}

template <class L>
HWY_INLINE typename L::V interpolated(const L& l, typename L::V p, typename L::V q, typename L::V weight, int bits) {
  return l.add(l.shl(p, bits), l.mul(l.sub(q, p), weight));
}

// The four texels of fragments i... of one level, and the weights between them.
template <class L>
struct Quad {
  typename L::V upper_left, lower_left, upper_right, lower_right, weights_u, weight_v;
};
template <class L>
HWY_INLINE Quad<L> load_quad(const L& l, const Shape& c, const TexelQuads& quads,
                             const TexelAddresses<typename L::Int>& addresses, std::size_t i) {
  const auto four = l.load_fours(&quads.texels[4 * i]);
  const auto weights_u = l.weights(l.load(&addresses.weight_u[i]), c.weight_fraction_bits);
  return {four[0], four[1], four[2], four[3], weights_u, l.load(&addresses.weight_v[i])};
}

// Component k filtered along both rows of a quad; B fraction bits.
template <class L>
struct Rows {
  typename L::V upper, lower;
};
template <int k, class L>
HWY_INLINE Rows<L> filter_rows(const L& l, const Shape& c, const Quad<L>& quad) {
  const int b = c.weight_fraction_bits;
  return {l.template weigh_fields<k>(quad.upper_left, quad.upper_right, c.texel_bits, quad.weights_u, b),
          l.template weigh_fields<k>(quad.lower_left, quad.lower_right, c.texel_bits, quad.weights_u, b)};
}

// The same filtered within the level; 2B fraction bits.
template <int k, class L>
HWY_INLINE typename L::V filter_quad(const L& l, const Shape& c, const Quad<L>& quad) {
  const int b = c.weight_fraction_bits;
  if (b == 0) return l.and_(l.sar(quad.upper_left, k * c.texel_bits), l.set((1 << c.texel_bits) - 1));
  const Rows<L> rows = filter_rows<k>(l, c, quad);
  if (c.texel_bits + b <= 16) return l.weigh16(rows.upper, rows.lower, l.weights(quad.weight_v, b), b);
  return interpolated(l, rows.upper, rows.lower, quad.weight_v, b);
}

// What is kept of a draw's samples between address and filter.
template <class Int>
struct Samples {
  TexelAddresses<Int> a, b;
  Column<Int> weight;
  TexelQuads quads_a, quads_b;
};

// Filters `components` (one to three): hand_on(component, fragment, f) takes each with D fraction bits.
template <class L, class HandOn>
HWY_INLINE void filter_any(const L& l, const Shape& c, int components, int count, const Samples<typename L::Int>& s,
                           const HandOn& hand_on) {
  const bool trilinear = c.trilinear;
  for (int first = 0; first < count; first += l.size()) {
    const auto i = static_cast<std::size_t>(first);
    const Quad<L> a = load_quad(l, c, s.quads_a, s.a, i);
    const Quad<L> b = trilinear ? load_quad(l, c, s.quads_b, s.b, i) : a;
    const auto weight = l.load(&s.weight[i]);
    const auto component = [&](auto k) HWY_ATTR {
      auto f = filter_quad<k>(l, c, a);
      if (trilinear) f = interpolated(l, f, filter_quad<k>(l, c, b), weight, c.lod_fraction_bits);
      hand_on(k, i, f);
    };
    component(std::integral_constant<int, 0>());
    if (components > 1) component(std::integral_constant<int, 1>());
    if (components > 2) component(std::integral_constant<int, 2>());
  }
}

// The same, trilinear, where the weights of a fragment's eight texels fit the halves of a lane.
inline bool has_short_weights(const Shape& c) {
  return c.trilinear && c.texel_bits + c.weight_bits <= 16 && c.weight_bits + c.lod_bits <= 14;
}
template <class L, class HandOn>
HWY_INLINE void filter_short(const L& l, const Shape& c, int components, int count, const Samples<typename L::Int>& s,
                             const HandOn& hand_on) {
  const int bits = c.weight_bits, lod_bits = c.lod_bits;
  for (int first = 0; first < count; first += l.size()) {
    const auto i = static_cast<std::size_t>(first);
    const Quad<L> a = load_quad(l, c, s.quads_a, s.a, i), b = load_quad(l, c, s.quads_b, s.b, i);
    const auto weights = l.two_weights(a.weight_v, b.weight_v, bits, l.load(&s.weight[i]), lod_bits);
    const auto component = [&](auto k) HWY_ATTR {
      const Rows<L> f = filter_rows<k>(l, c, a), g = filter_rows<k>(l, c, b);
      hand_on(k, i, l.weigh_twice16(f.upper, f.lower, g.upper, g.lower, weights, bits, lod_bits));
    };
    component(std::integral_constant<int, 0>());
    if (components > 1) component(std::integral_constant<int, 1>());
    if (components > 2) component(std::integral_constant<int, 2>());
  }
}

// `components` (one to three) that lie in one plane of the bound texture.
template <class L, class HandOn>
HWY_INLINE void sample(const L& l, const Constants<typename L::Int>& c, const std::vector<std::uint32_t>& texels,
                       int components, int count, Samples<typename L::Int>& s, const HandOn& hand_on) {
  fetch(texels.data(), s.a, count, s.quads_a);
  if (c.config.trilinear) fetch(texels.data(), s.b, count, s.quads_b);
  has_short_weights(c.config) ? filter_short(l, c.config, components, count, s, hand_on)
                              : filter_any(l, c.config, components, count, s, hand_on);
}

// The components from `first` on, which begins a plane, counted from there.
template <class L, class HandOn>
HWY_INLINE void sample_all(const L& l, const Constants<typename L::Int>& c, const BoundTexture& texture, int first,
                           int components, int count, Samples<typename L::Int>& s, const HandOn& hand_on) {
  for (int done = 0; done < components; done += kPlaneComponents)
    sample(l, c, texture.plane_of(first + done), std::min(components - done, kPlaneComponents), count, s,
           [&](std::size_t k, std::size_t i, typename L::V f)
               HWY_ATTR { hand_on(k + static_cast<std::size_t>(done), i, f); });
}

// A draw without texels: bump map 0, decal white, gloss full.
template <class L>
void texture_absent(const L& l, const Constants<typename L::Int>& c, Batch<typename L::Int>& batch) {
  const auto fill = [&](auto& column, typename L::Int value) HWY_ATTR {
    for (int i = 0; i < batch.count; i += l.size()) l.store(l.set(value), &column[static_cast<std::size_t>(i)]);
  };
  for (auto& column : batch.texture_bump) fill(column, 0);
  const auto full = (typename L::Int{1} << c.config.texel_bits) - 1;
  for (auto& column : batch.texture_decal) fill(column, full);
  for (auto& column : batch.texture_gloss) fill(column, full);
}

// The bump map: code c stands for (2c - offset) 2^-T.
template <class L>
void texture_bump(const L& l, const Constants<typename L::Int>& c, const BoundTexture& texture,
                  Samples<typename L::Int>& s, Batch<typename L::Int>& batch) {
  const int d = c.config.filter_fraction_bits;
  const auto offset = l.shl(l.set(c.config.bump_offset), d);
  const int shift = d + c.config.texel_bits - c.config.bump_fraction;
  const bool saturates = c.config.bump_saturates != 0;
  const typename L::Int limit = typename L::Int{1} << (c.config.bump_width - 1);
  const auto out = batch.texture_bump;
  sample_all(l, c, texture, 0, c.config.bump_components, batch.count, s,
             [&](std::size_t k, std::size_t i, typename L::V f) HWY_ATTR {
               const auto value = round_half_up(l, l.sub(l.shl(f, 1), offset), shift);
               l.store(saturates ? saturate(l, value, -limit, limit - 1) : value, &out[k][i]);
             });
}

// A base colour or a gloss: `components` of a texel from `first` on into columns of codes.
template <class L, class Columns>
HWY_INLINE void texture_codes(const L& l, const Constants<typename L::Int>& c, const BoundTexture& texture, int first,
                              int components, Samples<typename L::Int>& s, int count, const Columns out) {
  const int d = c.config.filter_fraction_bits;
  sample_all(l, c, texture, first, components, count, s, [&](std::size_t k, std::size_t i, typename L::V f) HWY_ATTR {
    l.store(round_half_up(l, f, d), &out[k][i]);
  });
}

template <class L>
void texture(const L& l, const Context& context, Batch<typename L::Int>& batch) {
  const auto c = context.constants<typename L::Int>();
  if (c.config.textured == 0) return;
  if (!c.draw.textured) return texture_absent(l, c, batch);
  const auto& u = c.config.divides != 0 ? batch.perspective_u[0] : batch.interpolate_u[0];
  const auto& v = c.config.divides != 0 ? batch.perspective_v[0] : batch.interpolate_v[0];
  const auto& lod = batch.interpolate_lod[0];
  Samples<typename L::Int> s;
  for (int first = 0; first < batch.count; first += l.size()) {
    const auto i = static_cast<std::size_t>(first);
    const Levels<L> levels = mip_levels(l, c, l.load(&lod[i]));
    address(l, c, l.load(&u[i]), l.load(&v[i]), levels.a, s.a, i);
    if (c.config.trilinear) address(l, c, l.load(&u[i]), l.load(&v[i]), levels.b, s.b, i);
    l.store(levels.weight, &s.weight[i]);
  }
  if (c.config.bump_components != 0) texture_bump(l, c, *context.texture, s, batch);
  const int first = c.config.bump_components, last = c.config.texels - 1;
  if (c.config.decal != 0) texture_codes(l, c, *context.texture, first, 3, s, batch.count, batch.texture_decal);
  if (c.config.gloss_map != 0) texture_codes(l, c, *context.texture, last, 1, s, batch.count, batch.texture_gloss);
}

}  // namespace HWY_NAMESPACE
}  // namespace wrinkle
HWY_AFTER_NAMESPACE();

#endif  // GOLDEN_PIXEL_TEXTURE_INL_H_

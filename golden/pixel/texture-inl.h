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
HWY_INLINE Coordinate<L> coordinate(const L& l, const Config& c, typename L::V u, typename L::V level, int log2_size,
                                    int mode) {
  const int b = c.weight_fraction_bits();
  const auto w = l.max(l.sub(l.set(log2_size), level), l.set(0));
  const auto scaled = l.shl(u, c.coordinate_shift());
  const auto shift = l.sub(l.set(c.uv_bits + c.coordinate_shift() - b), w);
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
  l.store(stride, &out.stride[i]);
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
  const int bits = c.config.lod_fraction_bits();
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

// The four texels of fragments i... of one level.
template <class L>
struct Quad {
  typename L::V upper_left, upper_right, lower_left, lower_right, weights_u, weight_v, weights_v;
};
template <class L>
HWY_INLINE Quad<L> load_quad(const L& l, const Config& c, const TexelRows& rows,
                             const TexelAddresses<typename L::Int>& addresses, std::size_t i) {
  const int b = c.weight_fraction_bits();
  const auto u = l.load(&addresses.weight_u[i]), v = l.load(&addresses.weight_v[i]);
  return {l.low_half(&rows.upper[i]),
          l.high_half(&rows.upper[i]),
          l.low_half(&rows.lower[i]),
          l.high_half(&rows.lower[i]),
          l.weights(u, b),
          v,
          l.weights(v, b)};
}

// A component, `shift` bits up in its texel, filtered within a level; 2B fraction bits.
template <class L>
HWY_INLINE typename L::V filter_quad(const L& l, const Config& c, const Quad<L>& quad, int shift) {
  const auto mask = l.set((1 << c.texel_bits) - 1);
  const auto component = [&](typename L::V texel) HWY_ATTR { return l.and_(l.sar(texel, shift), mask); };
  const int b = c.weight_fraction_bits();
  if (b == 0) return component(quad.upper_left);
  const auto upper = l.weigh15(component(quad.upper_left), component(quad.upper_right), quad.weights_u, b);
  const auto lower = l.weigh15(component(quad.lower_left), component(quad.lower_right), quad.weights_u, b);
  if (c.texel_bits + b <= 16) return l.weigh16(upper, lower, quad.weights_v, b);
  return interpolated(l, upper, lower, quad.weight_v, b);
}

// What is kept of a draw's samples between address and filter.
template <class Int>
struct Samples {
  TexelAddresses<Int> a, b;
  alignas(64) typename Batch<Int>::Column weight;
  TexelRows rows_a, rows_b;
};

// Fetches and filters `components` of each texel; hand_on(component, fragment, f) takes each with D fraction bits.
template <class L, class HandOn>
HWY_INLINE void sample(const L& l, const Constants<typename L::Int>& c, const std::vector<std::uint32_t>& texels,
                       int components, int count, Samples<typename L::Int>& s, const HandOn& hand_on) {
  const bool trilinear = c.config.trilinear();
  fetch(texels.data(), s.a, count, s.rows_a);
  if (trilinear) fetch(texels.data(), s.b, count, s.rows_b);
  for (int first = 0; first < count; first += l.size()) {
    const auto i = static_cast<std::size_t>(first);
    const Quad<L> a = load_quad(l, c.config, s.rows_a, s.a, i);
    const Quad<L> b = load_quad(l, c.config, s.rows_b, s.b, i);
    const auto weight = l.load(&s.weight[i]);
    for (int k = 0; k < components; ++k) {
      auto f = filter_quad(l, c.config, a, k * c.config.texel_bits);
      if (trilinear) {
        const auto g = filter_quad(l, c.config, b, k * c.config.texel_bits);
        f = interpolated(l, f, g, weight, c.config.lod_fraction_bits());
      }
      hand_on(static_cast<std::size_t>(k), i, f);
    }
  }
}

// A draw without texels: normal and slopes 0, decal white.
template <class L>
void texture_absent(const L& l, const Constants<typename L::Int>& c, Batch<typename L::Int>& batch) {
  for (std::size_t k = 0; k < 3; ++k) {
    for (int first = 0; first < batch.count; first += l.size()) {
      const auto i = static_cast<std::size_t>(first);
      if (c.config.has_texture_normal()) l.store(l.set(0), &batch.texture_n[k][i]);
      if (c.config.has_blinn()) l.store(l.set(0), &batch.texture_gradient[k][i]);
      if (c.config.decal != 0) l.store(l.set((1 << c.config.texel_bits) - 1), &batch.texture_decal[k][i]);
    }
  }
}

// fu, fv in s0.GB.
template <class L>
void texture_gradient(const L& l, const Constants<typename L::Int>& c, const std::vector<std::uint32_t>& texels,
                      Samples<typename L::Int>& s, Batch<typename L::Int>& batch) {
  const int d = c.config.filter_fraction_bits();
  const auto middle = l.shl(l.set(1 << (c.config.texel_bits - 1)), d);
  const int shift = d + c.config.texel_bits - 1 - c.config.gradient_bits;
  const typename L::Int limit = typename L::Int{1} << c.config.gradient_bits;
  sample(l, c, texels, 2, batch.count, s, [&](std::size_t k, std::size_t i, typename L::V f) HWY_ATTR {
    const auto slope = round_half_up(l, l.sub(f, middle), shift);
    l.store(saturate(l, slope, -limit, limit - 1), &batch.texture_gradient[k][i]);
  });
}

template <class L>
void texture(const L& l, const Context& context, Batch<typename L::Int>& batch) {
  const auto c = context.constants<typename L::Int>();
  if (!c.config.has_texture()) return;
  if (!c.draw.textured) return texture_absent(l, c, batch);
  const auto& u = c.config.perspective != 0 ? batch.perspective_u[0] : batch.interpolate_u[0];
  const auto& v = c.config.perspective != 0 ? batch.perspective_v[0] : batch.interpolate_v[0];
  Samples<typename L::Int> s;
  for (int first = 0; first < batch.count; first += l.size()) {
    const auto i = static_cast<std::size_t>(first);
    const Levels<L> levels = mip_levels(l, c, l.load(&batch.interpolate_lod[0][i]));
    address(l, c, l.load(&u[i]), l.load(&v[i]), levels.a, s.a, i);
    if (c.config.trilinear()) address(l, c, l.load(&u[i]), l.load(&v[i]), levels.b, s.b, i);
    l.store(levels.weight, &s.weight[i]);
  }
  const int d = c.config.filter_fraction_bits();
  if (c.config.has_blinn()) texture_gradient(l, c, context.texture->low, s, batch);
  if (c.config.has_texture_normal()) {
    const int one = (1 << c.config.texel_bits) - (c.config.decode == static_cast<int>(Decode::kRange) ? 1 : 0);
    const auto bias = l.shl(l.set(one), d);
    const int shift = d + c.config.texel_bits - c.config.vector_bits;
    sample(l, c, context.texture->low, 3, batch.count, s, [&](std::size_t k, std::size_t i, typename L::V f) HWY_ATTR {
      // |n| is at most 2^(D+T): it needs no saturation.
      l.store(round_half_up(l, l.sub(l.shl(f, 1), bias), shift), &batch.texture_n[k][i]);
    });
  }
  if (c.config.decal != 0) {
    const auto& texels = c.config.has_bump() ? context.texture->high : context.texture->low;
    sample(l, c, texels, 3, batch.count, s, [&](std::size_t k, std::size_t i, typename L::V f) HWY_ATTR {
      l.store(round_half_up(l, f, d), &batch.texture_decal[k][i]);
    });
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace wrinkle
HWY_AFTER_NAMESPACE();

#endif  // GOLDEN_PIXEL_TEXTURE_INL_H_

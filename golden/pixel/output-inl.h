// output: material and rounding to the colour.
#if defined(GOLDEN_PIXEL_OUTPUT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOLDEN_PIXEL_OUTPUT_INL_H_
#undef GOLDEN_PIXEL_OUTPUT_INL_H_
#else
#define GOLDEN_PIXEL_OUTPUT_INL_H_
#endif

#include "golden/pixel/context.h"
#include "golden/pixel/lanes-inl.h"
#include "golden/pixel/pixel.h"

HWY_BEFORE_NAMESPACE();
namespace wrinkle {
namespace HWY_NAMESPACE {

// The factor that a filtered code stands for, in u1.T: a full code is one.
template <class L>
HWY_INLINE typename L::V factor_of(const L& l, const Shape& config, typename L::V code) {
  return l.add(code, l.sar(code, config.texel_bits - 1));
}

template <class L>
HWY_INLINE typename L::V shade_channel(const L& l, const Constants<typename L::Int>& c, std::size_t k,
                                       typename L::V diffuse, typename L::V specular, const typename L::Int* decal) {
  const Shape& config = c.config;
  const int df = config.dot_bits, pf = config.power_bits, bits = config.colour_bits;
  auto base = l.add(l.shl(l.set(c.draw.ambient[k]), df), l.mul_half(l.set(c.draw.diffuse[k]), diffuse));
  if (config.decal != 0) {
    base = round_half_up(l, l.mul(base, factor_of(l, config, l.load(decal))), config.texel_bits);
  }
  const auto sum = l.add(l.shl(base, pf - df), l.mul_half(l.set(c.draw.specular[k]), specular));
  const typename L::Int full = (typename L::Int{1} << bits) - 1;
  const auto scaled = l.sub(l.shl(sum, bits), sum);  // times `full`
  return saturate(l, round_half_up(l, scaled, bits + pf), 0, full);
}

// `highlight(i)` is the specular factor of the fragments i...
template <class L, class Highlight>
HWY_INLINE void shade_all(const L& l, const Constants<typename L::Int>& c, Batch<typename L::Int>& batch,
                          const Highlight& highlight) {
  for (std::size_t k = 0; k < static_cast<std::size_t>(c.config.count); ++k) {
    for (int first = 0; first < batch.count; first += l.size()) {
      const auto i = static_cast<std::size_t>(first);
      const auto* decal = c.config.decal != 0 ? &batch.texture_decal[k][i] : nullptr;
      const auto diffuse = l.load(&batch.light_diffuse[0][i]);
      l.store(shade_channel(l, c, k, diffuse, highlight(i), decal), &batch.output_colour[k][i]);
    }
  }
}

template <class L>
void output(const L& l, const Context& context, Batch<typename L::Int>& batch) {
  const auto c = context.constants<typename L::Int>();
  const auto plain = [&](std::size_t i)
                         HWY_ATTR { return c.config.glossy ? l.load(&batch.light_specular[0][i]) : l.set(0); };
  if (c.config.gloss_map == 0) return shade_all(l, c, batch, plain);
  shade_all(l, c, batch, [&](std::size_t i) HWY_ATTR {
    const auto gloss = factor_of(l, c.config, l.load(&batch.texture_gloss[0][i]));
    return round_half_up(l, l.mul_half(plain(i), gloss), c.config.texel_bits);
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace wrinkle
HWY_AFTER_NAMESPACE();

#endif  // GOLDEN_PIXEL_OUTPUT_INL_H_

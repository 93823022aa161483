// interpolate: value + i * dw modulo 2^width at pixel i of each span, the guard bits dropped. Lanes hold the
// accumulators left-aligned, so that the lane's own wrap is the modulus.
#if defined(GOLDEN_PIXEL_INTERPOLATE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOLDEN_PIXEL_INTERPOLATE_INL_H_
#undef GOLDEN_PIXEL_INTERPOLATE_INL_H_
#else
#define GOLDEN_PIXEL_INTERPOLATE_INL_H_
#endif

#include "golden/pixel/context.h"
#include "golden/pixel/lanes-inl.h"
#include "golden/pixel/spans.h"

HWY_BEFORE_NAMESPACE();
namespace wrinkle {
namespace HWY_NAMESPACE {

// One plane over all spans. A vector may run over the end of its span: the next one writes there later.
template <bool kIsSigned, class L>
void interpolate_plane(const L& l, const Plane& plane, std::size_t index, const Spans<typename L::Int>& spans,
                       typename L::Int* out) {
  const typename L::Int *value = &spans.value[index], *step = &spans.dw[index];
  const std::size_t stride = spans.stride;
  const int shift = L::kBits - plane.width;
  const auto store = [&](typename L::V sum, int i) HWY_ATTR {
    l.store(kIsSigned ? l.sar_modular(sum, shift) : l.shr_modular(sum, shift), out + i);
  };
  const int log2_size = std::countr_zero(static_cast<unsigned>(l.size()));
  const int span_count = spans.count;
  for (int s = 0; s < span_count; ++s) {
    const Span& span = spans.span[static_cast<std::size_t>(s)];
    const std::size_t at = static_cast<std::size_t>(s) * stride;
    const auto dw = l.set(step[at]);
    auto sum = l.add_modular(l.set(value[at]), l.mul_modular(l.iota(), dw));
    int i = span.first;
    const int end = i + span.count;
    store(sum, i);
    for (i += l.size(); i < end; i += l.size()) {
      sum = l.add_modular(sum, l.shl_modular(dw, log2_size));
      store(sum, i);
    }
  }
}

template <class L>
void interpolate(const L& l, const Context& c, const Spans<typename L::Int>& spans, Batch<typename L::Int>& batch) {
  for (std::size_t p = 0; p < c.planes.size(); ++p) {
    const Plane& plane = c.planes[p];
    auto* out = batch.value[plane.value][plane.element].data();
    plane.is_signed ? interpolate_plane<true>(l, plane, p, spans, out)
                    : interpolate_plane<false>(l, plane, p, spans, out);
  }
  if (c.config.lod_held == 0) return;
  auto* lod = batch.interpolate_lod[0].data();
  for (int s = 0; s < spans.count; ++s) {
    const auto& span = spans.span[static_cast<std::size_t>(s)];
    for (int i = 0; i < span.count; i += l.size()) l.store(l.set(span.lod), lod + span.first + i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace wrinkle
HWY_AFTER_NAMESPACE();

#endif  // GOLDEN_PIXEL_INTERPOLATE_INL_H_

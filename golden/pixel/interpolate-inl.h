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

template <class Int>
Int* plane_column(Batch<Int>& batch, Component component) {
  const auto vector = [component](auto& columns, Component x) {
    return columns[static_cast<std::size_t>(component) - static_cast<std::size_t>(x)].data();
  };
  switch (component) {
    case Component::kNx:
    case Component::kNy:
    case Component::kNz:
      return vector(batch.interpolate_n, Component::kNx);
    case Component::kLx:
    case Component::kLy:
    case Component::kLz:
      return vector(batch.interpolate_l, Component::kLx);
    case Component::kHx:
    case Component::kHy:
    case Component::kHz:
      return vector(batch.interpolate_h, Component::kHx);
    case Component::kU:
      return batch.interpolate_u[0].data();
    case Component::kV:
      return batch.interpolate_v[0].data();
    case Component::kQ:
      return batch.interpolate_q[0].data();
    case Component::kLod:
      return batch.interpolate_lod[0].data();
    case Component::kZ:
      return batch.interpolate_z[0].data();
  }
  return nullptr;
}

// One component over one span. A vector may run over the end of the span: the next one writes there later.
template <class L, bool kIsSigned>
HWY_INLINE void interpolate_plane(const L& l, typename L::Int value, typename L::Int dw, int shift, int first,
                                  int count, typename L::Int* out) {
  const auto step = l.mul_modular(l.set(dw), l.set(l.size()));
  auto sum = l.add_modular(l.set(value), l.mul_modular(l.iota(), l.set(dw)));
  for (int i = first; i < first + count; i += l.size()) {
    const auto shifted = kIsSigned ? l.sar_modular(sum, shift) : l.shr_modular(sum, shift);
    store_within(l, shifted, std::min(l.size(), kBatch - i), out + i);
    sum = l.add_modular(sum, step);
  }
}

template <class L>
void interpolate(const L& l, const Context& c, const Spans<typename L::Int>& spans, Batch<typename L::Int>& batch) {
  using Int = typename L::Int;
  for (const Plane& plane : c.planes) {
    const auto index = static_cast<std::size_t>(plane.component);
    const int shift = L::kBits - plane.width;
    Int* out = plane_column(batch, plane.component);
    for (int s = 0; s < spans.count; ++s) {
      const auto& span = spans.span[static_cast<std::size_t>(s)];
      if (plane.is_signed)
        interpolate_plane<L, true>(l, span.value[index], span.dw[index], shift, span.first, span.count, out);
      else
        interpolate_plane<L, false>(l, span.value[index], span.dw[index], shift, span.first, span.count, out);
    }
  }
  if (!c.config.has_texture() || c.config.perspective != 0) return;
  Int* lod = batch.interpolate_lod[0].data();
  for (int s = 0; s < spans.count; ++s) {
    const auto& span = spans.span[static_cast<std::size_t>(s)];
    std::fill_n(lod + span.first, span.count, static_cast<Int>(span.lod));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace wrinkle
HWY_AFTER_NAMESPACE();

#endif  // GOLDEN_PIXEL_INTERPOLATE_INL_H_

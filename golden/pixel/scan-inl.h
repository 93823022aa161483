// scan: the pixel engine. Spans become pixels; the row engine that makes the spans is row_engine.h.
#if defined(GOLDEN_PIXEL_SCAN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOLDEN_PIXEL_SCAN_INL_H_
#undef GOLDEN_PIXEL_SCAN_INL_H_
#else
#define GOLDEN_PIXEL_SCAN_INL_H_
#endif

#include "golden/pixel/context.h"
#include "golden/pixel/lanes-inl.h"
#include "golden/pixel/spans.h"

HWY_BEFORE_NAMESPACE();
namespace wrinkle {
namespace HWY_NAMESPACE {

template <class L>
void scan(const L& l, const Context&, const Spans<typename L::Int>& spans, Batch<typename L::Int>& batch) {
  using Int = typename L::Int;
  Int* x = batch.scan_x[0].data();
  Int* y = batch.scan_y[0].data();
  Int* last = batch.scan_last[0].data();
  for (int s = 0; s < spans.count; ++s) {
    const auto& span = spans.span[static_cast<std::size_t>(s)];
    const int end = span.first + span.count;
    const auto row = l.set(span.y);
    const auto mirror = l.set(span.mirror ? -1 : 0);
    for (int i = span.first; i < end; i += l.size()) {
      const auto w = l.add(l.set(span.w + i - span.first), l.iota());
      l.store(l.xor_(w, mirror), x + i);  // -1 - w is the complement of w
      l.store(row, y + i);
      l.store(l.set(0), last + i);
    }
    std::fill_n(batch.packet.begin() + span.first, span.count, span.packet);
    last[end - 1] = span.last ? 1 : 0;
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace wrinkle
HWY_AFTER_NAMESPACE();

#endif  // GOLDEN_PIXEL_SCAN_INL_H_

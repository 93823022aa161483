// The scalar instances, plain and checked, of the same source.
#include "golden/pixel/lane_bits.h"
#include "golden/pixel/stages-inl.h"

namespace wrinkle {

// Debug builds check the range of every value that the scalar instance computes.
#ifdef NDEBUG
constexpr bool kAlwaysChecked = false;
#else
constexpr bool kAlwaysChecked = true;
#endif

void run_scalar(const Context& c, unsigned stages, const Spans<std::int64_t>& spans, Batch<std::int64_t>& batch) {
  HWY_NAMESPACE::run(HWY_NAMESPACE::ScalarLanes<false>(), c, stages, spans, batch);
}

void run_checked(const Context& c, unsigned stages, const Spans<std::int64_t>& spans, Batch<std::int64_t>& batch) {
  HWY_NAMESPACE::run(HWY_NAMESPACE::ScalarLanes<true>{lane_bits(c.config)}, c, stages, spans, batch);
}

void run_stages(Lanes lanes, const Context& c, unsigned stages, const Spans<std::int32_t>& spans,
                Batch<std::int32_t>& batch) {
  if (lanes != Lanes::kSimd) throw std::invalid_argument("scalar lanes are 64 bits wide");
  run_simd(c, stages, spans, batch);
}

void run_stages(Lanes lanes, const Context& c, unsigned stages, const Spans<std::int64_t>& spans,
                Batch<std::int64_t>& batch) {
  if (lanes == Lanes::kSimd) return run_simd(c, stages, spans, batch);
  kAlwaysChecked || lanes == Lanes::kChecked ? run_checked(c, stages, spans, batch)
                                             : run_scalar(c, stages, spans, batch);
}

}  // namespace wrinkle

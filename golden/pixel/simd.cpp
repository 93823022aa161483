// The SIMD instances, one for each instruction set, chosen at run time.
// AVX3_DL, which Highway leaves out by default, is worth a few per cent.
#define HWY_WANT_AVX3_DL 1
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "golden/pixel/simd.cpp"
#include "hwy/foreach_target.h"
// Highway's headers follow foreach_target.h.
#include "golden/pixel/stages-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace wrinkle {
namespace HWY_NAMESPACE {

void run_narrow(const Context& c, unsigned stages, const Spans<std::int32_t>& spans, Batch<std::int32_t>& batch) {
  run(SimdLanes<std::int32_t>(), c, stages, spans, batch);
}
void run_wide(const Context& c, unsigned stages, const Spans<std::int64_t>& spans, Batch<std::int64_t>& batch) {
  run(SimdLanes<std::int64_t>(), c, stages, spans, batch);
}
const char* target_name() { return hwy::TargetName(HWY_TARGET); }

}  // namespace HWY_NAMESPACE
}  // namespace wrinkle
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wrinkle {

HWY_EXPORT(run_narrow);
HWY_EXPORT(run_wide);
HWY_EXPORT(target_name);

void run_simd(const Context& c, unsigned stages, const Spans<std::int32_t>& spans, Batch<std::int32_t>& batch) {
  HWY_DYNAMIC_DISPATCH(run_narrow)(c, stages, spans, batch);
}
void run_simd(const Context& c, unsigned stages, const Spans<std::int64_t>& spans, Batch<std::int64_t>& batch) {
  HWY_DYNAMIC_DISPATCH(run_wide)(c, stages, spans, batch);
}
std::string_view simd_target() { return HWY_DYNAMIC_DISPATCH(target_name)(); }

}  // namespace wrinkle
#endif

// perturb: N' of the datapath, which is the one stage that a datapath has of its own (golden/datapath).
#if defined(GOLDEN_PIXEL_PERTURB_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOLDEN_PIXEL_PERTURB_INL_H_
#undef GOLDEN_PIXEL_PERTURB_INL_H_
#else
#define GOLDEN_PIXEL_PERTURB_INL_H_
#endif

#include <type_traits>

#include "golden/datapath/datapaths.h"
#include "golden/pixel/context.h"
#include "golden/pixel/lanes-inl.h"
#include "golden/pixel/pixel.h"

HWY_BEFORE_NAMESPACE();
namespace wrinkle {
namespace HWY_NAMESPACE {

// What perturb_lanes() of a datapath reads: the vectors in the place of N, the components of the bump map, and whether
// the draw has one, for the fragments of the lanes from i on.
template <class L>
struct PerturbInputs {
  Columns<typename L::Int> frame, bump;
  bool is_bumped;
  std::size_t i;

  HWY_INLINE typename L::V frame_at(const L& l, std::size_t k) const { return l.load(&frame[k][i]); }
  HWY_INLINE typename L::V bump_at(const L& l, std::size_t k) const { return l.load(&bump[k][i]); }
};

}  // namespace HWY_NAMESPACE
}  // namespace wrinkle
HWY_AFTER_NAMESPACE();

#include "golden/datapath/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace wrinkle {
namespace HWY_NAMESPACE {

// The datapath's own perturb_lanes(), over the batch.
template <class L, class Kind>
void perturb_batch(const L& l, const Kind& said, bool is_bumped, Batch<typename L::Int>& batch) {
  const Kind datapath = said;
  const auto frame = batch.interpolate_frame, bump = batch.texture_bump, n = batch.perturb_n;
  for (int first = 0; first < batch.count; first += l.size()) {
    const auto i = static_cast<std::size_t>(first);
    const Triple<L> v = perturb_lanes(l, datapath, PerturbInputs<L>{frame, bump, is_bumped, i});
    l.store(v.x, &n[0][i]);
    l.store(v.y, &n[1][i]);
    l.store(v.z, &n[2][i]);
  }
}

template <class L>
void perturb(const L& l, const Context& c, Batch<typename L::Int>& batch) {
  with_datapath(c.config, [&](const auto& datapath) {
    if constexpr (std::decay_t<decltype(datapath)>::kPerturbs) perturb_batch(l, datapath, c.draw.bump, batch);
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace wrinkle
HWY_AFTER_NAMESPACE();

#endif  // GOLDEN_PIXEL_PERTURB_INL_H_

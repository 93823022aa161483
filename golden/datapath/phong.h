// phong [Peercy97 fig. 1]: N is interpolated, and nothing perturbs it.
#ifndef GOLDEN_DATAPATH_PHONG_H_
#define GOLDEN_DATAPATH_PHONG_H_

#include "golden/datapath/datapath.h"

namespace wrinkle {

struct Phong : DatapathDefaults {
  using DatapathDefaults::DatapathDefaults;

  WRINKLE_SAYS(frame_0_width, vector_bits + 2)
  WRINKLE_SAYS(frame_0_bits, vector_bits)
  WRINKLE_SAYS(normal_width, vector_bits + 2)
  WRINKLE_SAYS(normal_bits, vector_bits)
  WRINKLE_SAYS(normal_input_bits, vector_bits)
  WRINKLE_SAYS(normal_like_light, 1)

  static constexpr std::array<std::string_view, 1> frame_names() { return {"n"}; }

  // The exact twin of perturb_lanes().
  static Vec3 exact(bool, std::span<const Vec3> frame, std::span<const double>) { return frame[0]; }
};

}  // namespace wrinkle

#endif  // GOLDEN_DATAPATH_PHONG_H_

#ifdef WRINKLE_LANES
HWY_BEFORE_NAMESPACE();
namespace wrinkle {
namespace HWY_NAMESPACE {

template <class L>
HWY_INLINE Triple<L> perturb_lanes(const L& l, const Phong&, const PerturbInputs<L>& in) {
  return {in.frame_at(l, 0), in.frame_at(l, 1), in.frame_at(l, 2)};
}

}  // namespace HWY_NAMESPACE
}  // namespace wrinkle
HWY_AFTER_NAMESPACE();
#endif

#ifdef WRINKLE_DATAPATH
WRINKLE_DATAPATH(phong, Phong)
#endif

// normal_map [Peercy97 fig. 3]: a bumped draw takes N' from a texture, in tangent or in object space; any other has N
// interpolated.
#ifndef GOLDEN_DATAPATH_NORMAL_MAP_H_
#define GOLDEN_DATAPATH_NORMAL_MAP_H_

#include "golden/datapath/datapath.h"

namespace wrinkle {

struct NormalMapped : DatapathDefaults {
  using DatapathDefaults::DatapathDefaults;

  // Texel normals are in the space of their map; L.z is the cosine of the surface in tangent space alone.
  static constexpr DrawSpace kSpace = DrawSpace::kOfTexture;
  static constexpr bool kTurnsLight = true;

  WRINKLE_SAYS(frame_0_width, vector_bits + 2)
  WRINKLE_SAYS(frame_0_bits, vector_bits)
  WRINKLE_SAYS(bump_components, 3)
  WRINKLE_SAYS(bump_width, vector_bits + 2)
  WRINKLE_SAYS(bump_fraction, vector_bits)
  WRINKLE_SAYS(bump_offset, (1 << texel_bits) - (decode == 0 ? 1 : 0))
  // `range` is symmetric, so that an 8-bit image of a normal map comes back as its own codes; with `offset`, (0, 0, 1)
  // is exact.
  WRINKLE_SAYS(bump_full_scale, (1 << texel_bits) - (decode == 0 ? 1 : 2))
  WRINKLE_SAYS(normal_width, vector_bits + 2)
  WRINKLE_SAYS(normal_bits, vector_bits)
  WRINKLE_SAYS(normal_input_bits, vector_bits)
  WRINKLE_SAYS(normal_like_light, 1)
  WRINKLE_SAYS(surface_is_z, 1)

  static constexpr std::array<std::string_view, 1> frame_names() { return {"n"}; }
  static constexpr std::string_view bump_name() { return "n"; }


  // The exact twin of perturb_lanes().
  static Vec3 exact(bool is_bumped, std::span<const Vec3> frame, std::span<const double> bump) {
    return is_bumped ? Vec3{bump[0], bump[1], bump[2]} : frame[0];
  }
};

}  // namespace wrinkle

#endif  // GOLDEN_DATAPATH_NORMAL_MAP_H_

#ifdef WRINKLE_LANES
HWY_BEFORE_NAMESPACE();
namespace wrinkle {
namespace HWY_NAMESPACE {

template <class L>
HWY_INLINE Triple<L> perturb_lanes(const L& l, const NormalMapped&, const PerturbInputs<L>& in) {
  const auto at = [&](std::size_t k) HWY_ATTR { return in.is_bumped ? in.bump_at(l, k) : in.frame_at(l, k); };
  return {at(0), at(1), at(2)};
}

}  // namespace HWY_NAMESPACE
}  // namespace wrinkle
HWY_AFTER_NAMESPACE();
#endif

#ifdef WRINKLE_DATAPATH
WRINKLE_DATAPATH(normal_map, NormalMapped)
#endif

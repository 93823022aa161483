// offset [Shen, offset vector maps]: N' = N + D in tangent space, where a texture has the two components of D, which
// lies in the plane of the surface: D = (-Bu, -Bv, 0) for the slopes Bu and Bv of the height along T and B.
#ifndef GOLDEN_DATAPATH_OFFSET_H_
#define GOLDEN_DATAPATH_OFFSET_H_

#include <algorithm>

#include "golden/datapath/datapath.h"
#include "golden/texel/gradient_map.h"

namespace wrinkle {

struct Offset : DatapathDefaults {
  using DatapathDefaults::DatapathDefaults;

  static constexpr DrawSpace kSpace = DrawSpace::kTangent;
  static constexpr bool kTurnsLight = true;

  WRINKLE_SAYS(frame_0_width, vector_bits + 2)
  WRINKLE_SAYS(frame_0_bits, vector_bits)
  WRINKLE_SAYS(frame_prepared, 1)
  WRINKLE_SAYS(bump_components, 2)
  WRINKLE_SAYS(bump_width, vector_bits + 1)
  WRINKLE_SAYS(bump_fraction, vector_bits)
  WRINKLE_SAYS(bump_offset, 1 << texel_bits)
  WRINKLE_SAYS(bump_full_scale, 1 << texel_bits)
  WRINKLE_SAYS(bump_saturates, 1)
  WRINKLE_SAYS(perturb_latency, 1)
  WRINKLE_SAYS(normal_width, vector_bits + 2)
  WRINKLE_SAYS(normal_bits, vector_bits)
  WRINKLE_SAYS(normal_input_bits, vector_bits)
  WRINKLE_SAYS(normal_any_length, 1)
  WRINKLE_SAYS(normal_like_light, 1)
  WRINKLE_SAYS(perturb_operand_bits, vector_bits + 3)
  WRINKLE_SAYS(surface_is_z, 1)
  WRINKLE_SAYS(light_may_be_constant, 0)

  static constexpr std::array<std::string_view, 1> frame_names() { return {"n"}; }
  static constexpr std::string_view bump_name() { return "offset"; }

  // D over a scale of at least 1, so that N over the same scale is no longer than a unit vector.
  static ExactTexture texels(const TexelInputs& in) {
    ExactTexture texture = gradient_texture(in.normals, in.texel_bits);
    const double to_offset = -std::min(texture.bump_scale, 1.0);
    for (auto& level : texture.levels)
      for (ExactTexel& texel : level)
        for (float& component : texel.bump) component = static_cast<float>(to_offset * component);
    texture.bump_scale = std::max(texture.bump_scale, 1.0);
    return texture;
  }

  static FrameVectors vertex(const VertexInputs& v) { return {Vec3{0, 0, 1 / v.bump_scale}}; }

  // The exact twin of perturb_lanes().
  static Vec3 exact(bool is_bumped, std::span<const Vec3> frame, std::span<const double> bump) {
    return is_bumped ? frame[0] + Vec3{bump[0], bump[1], 0} : frame[0];
  }
};

}  // namespace wrinkle

#endif  // GOLDEN_DATAPATH_OFFSET_H_

#ifdef WRINKLE_LANES
HWY_BEFORE_NAMESPACE();
namespace wrinkle {
namespace HWY_NAMESPACE {

template <class L>
HWY_INLINE Triple<L> perturb_lanes(const L& l, const Offset& c, const PerturbInputs<L>& in) {
  const typename L::Int limit = typename L::Int{2} << c.vector_bits;
  const auto moved = [&](std::size_t k) HWY_ATTR {
    const auto n = in.frame_at(l, k);
    return in.is_bumped ? saturate(l, l.add(n, in.bump_at(l, k)), -limit, limit - 1) : n;
  };
  return {moved(0), moved(1), in.frame_at(l, 2)};
}

}  // namespace HWY_NAMESPACE
}  // namespace wrinkle
HWY_AFTER_NAMESPACE();
#endif

#ifdef WRINKLE_DATAPATH
WRINKLE_DATAPATH(offset, Offset)
#endif

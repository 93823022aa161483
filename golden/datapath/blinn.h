// blinn [Peercy97 fig. 2, after Blinn 1978]: N' = A - fu B - fv C, where A = Pu x Pv, B = Pv x N and C = N x Pu are
// interpolated and a texture has the slopes fu and fv of the height field.
#ifndef GOLDEN_DATAPATH_BLINN_H_
#define GOLDEN_DATAPATH_BLINN_H_

#include "golden/datapath/datapath.h"
#include "golden/texel/gradient_map.h"

namespace wrinkle {

struct Blinn : DatapathDefaults {
  using DatapathDefaults::DatapathDefaults;

  static constexpr bool kTexelsFromHeights = true;

  WRINKLE_SAYS(frame_0_width, wide_bits + 2)
  WRINKLE_SAYS(frame_0_bits, wide_bits)
  WRINKLE_SAYS(frame_1_width, wide_bits + 2)
  WRINKLE_SAYS(frame_1_bits, wide_bits)
  WRINKLE_SAYS(frame_1_held, cross_products != 0 ? 1 : 0)
  WRINKLE_SAYS(frame_2_width, wide_bits + 2)
  WRINKLE_SAYS(frame_2_bits, wide_bits)
  WRINKLE_SAYS(frame_2_held, cross_products != 0 ? 1 : 0)
  WRINKLE_SAYS(frame_prepared, 1)
  WRINKLE_SAYS(frame_unbounded, 1)
  WRINKLE_SAYS(bump_components, 2)
  WRINKLE_SAYS(bump_width, gradient_bits + 1)
  WRINKLE_SAYS(bump_fraction, gradient_bits)
  WRINKLE_SAYS(bump_offset, 1 << texel_bits)
  WRINKLE_SAYS(bump_full_scale, 1 << texel_bits)
  WRINKLE_SAYS(bump_saturates, 1)
  WRINKLE_SAYS(perturb_latency, 2)
  WRINKLE_SAYS(normal_width, wide_bits + 3)
  WRINKLE_SAYS(normal_bits, wide_bits)
  WRINKLE_SAYS(normal_input_bits, wide_bits + 1)
  WRINKLE_SAYS(normal_any_length, 1)
  // The three terms of N', each below 2^(VW + 1 + GB), and the half that rounds.
  WRINKLE_SAYS(perturb_operand_bits, wide_bits + gradient_bits + 5)

  static constexpr std::array<std::string_view, 3> frame_names() { return {"a", "b", "c"}; }
  static constexpr std::string_view bump_name() { return "gradient"; }

  // The slopes of the height field where there is one, else those of the surface that has the normals.
  static ExactTexture texels(const TexelInputs& in) {
    return in.heights != nullptr ? gradient_texture(in.normals, *in.heights, in.texel_bits, in.wraps)
                                 : gradient_texture(in.normals, in.texel_bits);
  }

  // A, B, C with N on the outer side, f being measured along N [Peercy97 eq. 2]; where u and v are lengths along T and
  // B, N, T and B. B and C have the scale that the slopes were divided by.
  static FrameVectors vertex(const VertexInputs& v) {
    Vec3 a = v.N, b = v.T, c = v.B;
    if (v.has_derivatives) {
      // Where Pu x Pv points inwards, the perturbed normal that points outwards is the opposite one.
      const double side = dot(v.N, cross(v.Pu, v.Pv)) < 0 ? -1 : 1;
      a = side * cross(v.Pu, v.Pv), b = side * cross(v.Pv, v.N), c = side * cross(v.N, v.Pu);
    }
    return {a, v.bump_scale * b, v.bump_scale * c};
  }

  // The exact twin of perturb_lanes().
  static Vec3 exact(bool is_bumped, std::span<const Vec3> frame, std::span<const double> bump) {
    return is_bumped ? frame[0] - bump[0] * frame[1] - bump[1] * frame[2] : frame[0];
  }
};

}  // namespace wrinkle

#endif  // GOLDEN_DATAPATH_BLINN_H_

#ifdef WRINKLE_LANES
HWY_BEFORE_NAMESPACE();
namespace wrinkle {
namespace HWY_NAMESPACE {

template <class L>
HWY_INLINE Triple<L> perturb_lanes(const L& l, const Blinn& c, const PerturbInputs<L>& in) {
  const auto slope = [&](std::size_t k) HWY_ATTR { return in.is_bumped ? in.bump_at(l, k) : l.set(0); };
  const auto fu = slope(0), fv = slope(1);
  const typename L::Int limit = typename L::Int{4} << c.wide_bits;
  const auto element = [&](std::size_t k) HWY_ATTR {
    const auto along_u = l.mul(in.frame_at(l, 3 + k), fu);
    const auto along_v = l.mul(in.frame_at(l, 6 + k), fv);
    const auto n = l.sub(l.sub(l.shl(in.frame_at(l, k), c.gradient_bits), along_u), along_v);
    return saturate(l, round_half_up(l, n, c.gradient_bits), -limit, limit - 1);
  };
  return {element(0), element(1), element(2)};
}

}  // namespace HWY_NAMESPACE
}  // namespace wrinkle
HWY_AFTER_NAMESPACE();
#endif

#ifdef WRINKLE_DATAPATH
WRINKLE_DATAPATH(blinn, Blinn)
#endif

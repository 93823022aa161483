// blinn [Peercy97 fig. 2, after Blinn 1978]: N' = A - fu B - fv C, where A = Pu x Pv, B = Pv x N and C = N x Pu are
// interpolated and a texture has the slopes fu and fv of the height field.
#ifndef GOLDEN_DATAPATH_BLINN_H_
#define GOLDEN_DATAPATH_BLINN_H_

#include "golden/datapath/datapath.h"

namespace wrinkle {

struct Blinn : DatapathDefaults {
  using DatapathDefaults::DatapathDefaults;

  WRINKLE_SAYS(frame_vectors, 3)
  WRINKLE_SAYS(frame_width, wide_bits + 2)
  WRINKLE_SAYS(frame_bits, wide_bits)
  WRINKLE_SAYS(frame_held, cross_products != 0 ? 2 : 0)
  WRINKLE_SAYS(frame_unbounded, 1)
  WRINKLE_SAYS(bump_components, 2)
  WRINKLE_SAYS(bump_width, gradient_bits + 1)
  WRINKLE_SAYS(bump_fraction, gradient_bits)
  WRINKLE_SAYS(bump_offset, 1 << texel_bits)
  WRINKLE_SAYS(bump_saturates, 1)
  WRINKLE_SAYS(normal_width, wide_bits + 3)
  WRINKLE_SAYS(normal_bits, wide_bits)
  WRINKLE_SAYS(normal_input_bits, wide_bits + 1)
  WRINKLE_SAYS(normal_any_length, 1)
  // The three terms of N', each below 2^(VW + 1 + GB), and the half that rounds.
  WRINKLE_SAYS(perturb_operand_bits, wide_bits + gradient_bits + 5)
};

}  // namespace wrinkle

#endif  // GOLDEN_DATAPATH_BLINN_H_

#ifdef WRINKLE_DATAPATH
WRINKLE_DATAPATH(blinn, Blinn)
#endif

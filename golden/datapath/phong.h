// phong [Peercy97 fig. 1]: N is interpolated, and nothing perturbs it.
#ifndef GOLDEN_DATAPATH_PHONG_H_
#define GOLDEN_DATAPATH_PHONG_H_

#include "golden/datapath/datapath.h"

namespace wrinkle {

struct Phong : DatapathDefaults {
  using DatapathDefaults::DatapathDefaults;

  WRINKLE_SAYS(frame_vectors, 1)
  WRINKLE_SAYS(frame_width, vector_bits + 2)
  WRINKLE_SAYS(frame_bits, vector_bits)
  WRINKLE_SAYS(normal_width, vector_bits + 2)
  WRINKLE_SAYS(normal_bits, vector_bits)
  WRINKLE_SAYS(normal_input_bits, vector_bits)
  WRINKLE_SAYS(normal_like_light, 1)
};

}  // namespace wrinkle

#endif  // GOLDEN_DATAPATH_PHONG_H_

#ifdef WRINKLE_DATAPATH
WRINKLE_DATAPATH(phong, Phong)
#endif

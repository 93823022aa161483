// normal_map [Peercy97 fig. 3]: a bumped draw takes N' from a texture, in tangent or in object space; any other has N
// interpolated.
#ifndef GOLDEN_DATAPATH_NORMAL_MAP_H_
#define GOLDEN_DATAPATH_NORMAL_MAP_H_

#include "golden/datapath/datapath.h"

namespace wrinkle {

struct NormalMapped : DatapathDefaults {
  using DatapathDefaults::DatapathDefaults;

  WRINKLE_SAYS(frame_vectors, 1)
  WRINKLE_SAYS(frame_width, vector_bits + 2)
  WRINKLE_SAYS(frame_bits, vector_bits)
  WRINKLE_SAYS(bump_components, 3)
  WRINKLE_SAYS(bump_width, vector_bits + 2)
  WRINKLE_SAYS(bump_fraction, vector_bits)
  WRINKLE_SAYS(bump_offset, (1 << texel_bits) - (decode == 0 ? 1 : 0))
  WRINKLE_SAYS(normal_width, vector_bits + 2)
  WRINKLE_SAYS(normal_bits, vector_bits)
  WRINKLE_SAYS(normal_input_bits, vector_bits)
  WRINKLE_SAYS(normal_like_light, 1)
  WRINKLE_SAYS(surface_is_z, 1)
};

}  // namespace wrinkle

#endif  // GOLDEN_DATAPATH_NORMAL_MAP_H_

#ifdef WRINKLE_DATAPATH
WRINKLE_DATAPATH(normal_map, NormalMapped)
#endif

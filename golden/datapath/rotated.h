// rotated [Kuijk and Blake 1989]: N' is (0, 0, 1) in a frame that turns with the normal, in which L and H are given.
#ifndef GOLDEN_DATAPATH_ROTATED_H_
#define GOLDEN_DATAPATH_ROTATED_H_

#include "golden/datapath/datapath.h"

namespace wrinkle {

struct Rotated : DatapathDefaults {
  using DatapathDefaults::DatapathDefaults;

  static constexpr bool kPerturbs = false;
  static constexpr DrawSpace kSpace = DrawSpace::kTangent;
  static constexpr bool kTurnsLight = true;

  WRINKLE_SAYS(light_may_be_constant, 0)
};

}  // namespace wrinkle

#endif  // GOLDEN_DATAPATH_ROTATED_H_

#ifdef WRINKLE_DATAPATH
WRINKLE_DATAPATH(rotated, Rotated)
#endif

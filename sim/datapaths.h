// Every datapath and option that is built, each with a scene that needs it: what `verify --all` draws.
#pragma once

#include <vector>

#include "sim/comparison.h"

namespace wrinkle {

struct DatapathFrame {
  int row;  // 0 the paper's Fig. 1 and 3; 1 Fig. 2; 2 object space; 3 surface independence; 4 rotated frame; 5
            // illumination; 6 figures
  Comparison comparison;
};
std::vector<DatapathFrame> datapath_frames();

}  // namespace wrinkle

// perturb_lanes() of every datapath. Included once an instruction set, by golden/pixel/perturb-inl.h, and so unguarded.
#define WRINKLE_LANES
#define WRINKLE_DATAPATH(name, Type)
#include "golden/datapath/list.def"
#undef WRINKLE_DATAPATH
#undef WRINKLE_LANES

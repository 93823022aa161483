// The modules of the bench, connected. SystemC elaborates once, so there is one a process, used for run after run.
#pragma once

#include "tb/run.h"

namespace wrinkle {

// Runs until the core is idle, hangs, or is to stop. Results are left in `run`.
void simulate(BenchRun& run);

}  // namespace wrinkle

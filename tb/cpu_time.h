// Processor time, which unlike wall-clock time does not grow while others use the machine.
#pragma once

#include <time.h>

namespace wrinkle {

// Of all threads of this process, since it began.
inline double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace wrinkle

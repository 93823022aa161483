// Frames measured by several processes at once: SystemC elaborates once a process.
#pragma once

#include <functional>
#include <span>

#include "sim/digest/measure.h"

namespace wrinkle {

// The places in `frames` of those that one model draws, in order.
using SameConfig = std::vector<std::size_t>;

// Measures frames[i] for every i of every group, each group in a process of its own, at most `processes` at a time.
// `done` is called in this process, in the order in which they are ready. Throws std::runtime_error where a process
// ends before its frames, with the reason. No thread may run in this process.
void measure_in_processes(std::span<const DigestFrame> frames, const std::vector<SameConfig>& groups,
                          const Engines& engines, int processes,
                          const std::function<void(std::size_t, const MeasuredFrame&)>& done);

}  // namespace wrinkle

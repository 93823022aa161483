// Gathers what the wires between the stages carry into one row of values a fragment: the k-th transfer of every stage
// belongs to the k-th fragment.
#pragma once

#include <deque>
#include <vector>

#include "golden/pixel/pixel.h"
#include "tb/model.h"

namespace wrinkle {

class TapRecorder {
 public:
  explicit TapRecorder(const Config& config);

  // Takes the wires of one clock; counts transfers into `transfers`.
  void sample(const Taps& taps, std::uint64_t (&transfers)[kStages]);

  // The row of the next fragment to leave the core.
  FragmentValues take();

 private:
  std::vector<Value> values_;
  std::array<std::pair<int, int>, kStages> range_{};  // values of a stage: [first, past the last)
  std::deque<FragmentValues> rows_;
  std::uint64_t taken_ = 0;
};

// Element of a packed wire, sign-extended where the value is signed.
std::int64_t unpack(const Value& value, TapWire wire, int element);

}  // namespace wrinkle

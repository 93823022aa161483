// Gathers what the wires between the stages carry into one row of values a fragment: the k-th transfer of a stage that
// moves each fragment T times belongs to fragment k / T.
#pragma once

#include <deque>
#include <vector>

#include "golden/pixel/pixel.h"
#include "golden/stages.h"
#include "tb/model.h"

namespace wrinkle {

// What was seen of one stage.
struct StageTap {
  bool visible = false;  // the netlist has its handshake
  bool valid = false;    // at the last sample
  std::uint64_t transfers = 0;
};

class TapRecorder {
 public:
  // The values of a configuration, and how often each stage moves a fragment; the wires are those of a model.
  TapRecorder(std::vector<Value> values, const PerStage<int>& moves, std::span<const Wire> wires);

  // Takes the wires of one clock.
  void sample();

  // The row of the next fragment to leave the core.
  FragmentValues take();

  const PerStage<StageTap>& stages() const { return seen_; }
  // Whether the netlist has the wire of a value.
  std::vector<bool> visible_values() const;

 private:
  struct Tap {
    std::size_t value;  // index in values_
    Wire wire;
  };
  struct StageWires {
    Wire valid, ready;
    std::vector<Tap> taps;
  };

  void record(std::size_t stage, std::uint64_t transfer);

  std::vector<Value> values_;
  PerStage<int> moves_;
  PerStage<StageWires> wires_;
  PerStage<StageTap> seen_{};
  std::deque<FragmentValues> rows_;
  std::uint64_t taken_ = 0;
};

// Element of a value on a wire, sign-extended where the value is signed.
std::int64_t unpack(const Value& value, const Wire& wire, int element);

}  // namespace wrinkle

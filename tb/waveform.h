// What a waveform shows beside the netlist: for every stage the fragment that it offers, its values as the golden model
// expects them and as the wires have them, as real numbers, and whether they differ.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "golden/pixel/pixel.h"
#include "golden/stages.h"
#include "tb/model.h"
#include "tb/tap_recorder.h"

namespace wrinkle {

// Golden values of consecutive fragments.
struct ExpectedValues {
  std::uint64_t first = 0;  // number of the first fragment
  std::vector<FragmentValues> fragments;

  const FragmentValues* of(std::uint64_t fragment) const {
    const bool known = fragment >= first && fragment - first < fragments.size();
    return known ? &fragments[fragment - first] : nullptr;
  }
};

class Waveform {
 public:
  Waveform(const Shape& config, const Model& model, ExpectedValues expected);

  // Takes the wires of the clock, which are settled; `before` is what was seen of the stages until then.
  void sample(std::uint64_t clock, const PerStage<StageTap>& before);

  // bench.clock, and bench.STAGE.fragment, .transfer, .differs, .VALUE_golden and .VALUE_rtl.
  std::span<const TraceSignal> signals() const { return signals_; }
  // The first clock in which a stage handed on a fragment that differs.
  std::optional<std::uint64_t> first_difference(Stage stage) const {
    return first_difference_[static_cast<std::size_t>(stage)];
  }
  // Writes how GTKWave (.gtkw) and Surfer (.sucl) show the file, beside it: grouped by stages, with the cursor at the
  // clock.
  void write_views(const std::filesystem::path& file, std::uint64_t first, std::uint64_t cursor) const;

 private:
  struct Pair {
    Value value;
    std::size_t index;  // of the value
    Wire wire;
    int element;
    std::size_t signal;  // of golden; that of rtl is the next
  };
  struct StageSignals {
    Wire valid, ready;
    std::size_t fragment = 0;  // then transfer, differs
    std::vector<Pair> pairs;
  };

  void add_stage(std::size_t stage, const std::vector<Value>& all, const Model& model);
  bool compare(const StageSignals& stage, std::uint64_t fragment, std::uint64_t slot);

  ExpectedValues expected_;
  PerStage<int> moves_;
  PerStage<std::optional<StageSignals>> stages_;
  PerStage<std::optional<std::uint64_t>> first_difference_;
  std::vector<TraceSignal> signals_;
};

}  // namespace wrinkle

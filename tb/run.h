// What one run of the bench works on and what comes of it; shared by its modules.
#pragma once

#include <cstdint>
#include <exception>
#include <optional>
#include <span>
#include <vector>

#include "tb/bench.h"
#include "tb/tap_recorder.h"
#include "tb/waveform.h"

namespace wrinkle {

// Fragments that left the core within a quantum.
struct FragmentBlock {
  std::vector<Fragment> fragments;
  std::vector<std::uint32_t> clocks;   // since `first_cycle`
  std::vector<FragmentValues> values;  // one a fragment when tapped, else empty
  std::uint64_t first_cycle = 0;
};

// Fragments of the golden model.
struct GoldenBlock {
  std::vector<Fragment> fragments;
  std::vector<std::uint32_t> packets;
};

// Where RTL and golden first parted. Either side may be absent.
struct FirstDifference {
  Difference::Kind kind = Difference::Kind::kValue;
  std::uint64_t fragment = 0, cycle = 0;
  std::int64_t packet = -1;  // index in the words of the run
  std::optional<Fragment> golden, rtl;
  std::string_view stage;     // where the port says it
  FragmentValues rtl_values;  // when tapped
};

struct BenchRun {
  // in
  const Config* config = nullptr;
  std::span<const std::uint64_t> words;
  const std::vector<Texture>* textures = nullptr;
  const BenchOptions* options = nullptr;
  const BenchSinks* sinks = nullptr;
  Model* model = nullptr;
  bool tapped = false;
  Waveform* waveform = nullptr;                  // what is written to options->trace
  std::uint64_t trace_from = ~std::uint64_t{0};  // from this clock on
  std::uint64_t stop_after = 0;
  // out
  std::uint64_t fragments = 0, cycles = 0, mismatches = 0, zero_vectors = 0;
  std::optional<FirstDifference> first, bad_request;
  bool stopped = false;
  bool idle = false;                 // the core came to its end by itself
  bool surplus = false;              // the golden model has ended and the RTL has not: it may never
  PerStage<StageTap> stages{};       // at the end of a tapped run
  std::vector<bool> visible_values;  // as values(config); of a tapped run
  std::exception_ptr error;

  // The core reports what it meets ahead of the scoreboard: the earliest fragment counts.
  void differ(FirstDifference difference) {
    if (!first || difference.fragment < first->fragment) first = std::move(difference);
  }
};

}  // namespace wrinkle

// The SystemC bench: draws packets with the Verilated core and holds every fragment against the golden model.
// All of SystemC is behind this header. One bench a process; runs follow each other, they do not overlap.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "golden/config/config.h"
#include "golden/pixel/pixel.h"
#include "golden/texel/texture.h"
#include "golden/triangle/packet.h"
#include "tb/build_model.h"
#include "tb/stall.h"

namespace wrinkle {

struct BenchOptions {
  std::uint64_t seed = 1;  // of stalls, latencies and uninitialised registers
  StallProfile stalls = StallProfile::kNone;
  int latency = 8;                  // a texel request is answered after 0 to this many clocks
  int quantum = 64;                 // clocks the core runs ahead of SystemC's time: 64 to soak, 1 to be cycle by cycle
  bool compare = true;              // off: the RTL is drawn with, not verified
  bool dmi = true;                  // texels through the direct memory interface; off: a transaction each
  bool blame = true;                // replay the first difference to name its stage
  std::filesystem::path trace;      // FST waveform around the first difference; empty: none
  std::uint64_t watchdog = 100000;  // clocks without any transfer that make a hang
  std::uint64_t stop_after = 0;     // give up after this many clocks, without a verdict; 0: never
  bool keep_registers = false;      // start from what the run before left in the registers, by reset alone
  ModelOptions model;
  BuildProgress progress;
};

// The first way in which the RTL was not the golden model.
struct Difference {
  enum class Kind {
    kValue,    // a fragment has another value
    kMissing,  // the RTL came to its end before the golden model
    kExtra,    // and went on after it
    kHang,     // nothing moves any more
    kRequest,  // a texel outside its texture was asked for
    kHold,     // a stream changed or withdrew its payload before it was taken
    kIdle,     // the core said that it is idle, and was not
  };
  Kind kind = Kind::kValue;
  std::string frame;
  std::uint64_t fragment = 0;                          // counted over the frame
  std::uint64_t cycle = 0;                             // clock since reset at which it left the core
  std::int64_t draw = -1, packet = -1, triangle = -1;  // -1: unknown
  std::int32_t x = 0, y = 0;                           // of the golden fragment, or the RTL's where there is none
  std::string stage;  // first that differs, in pipeline order; empty: the replay showed no difference
  std::string value;  // name in values.def, or of the port; empty when it is not one value
  int element = 0;
  int width = 0, fraction_bits = 0;
  std::int64_t golden = 0, rtl = 0;
  double golden_real() const;
  double rtl_real() const;
  std::filesystem::path trace;  // written, with the difference at clock `trace_cycle`
  std::uint64_t trace_cycle = 0;
};
// "frame patch, triangle 12 (draw 0, packet 7), pixel (3, 4): normalize.n[1] is 0x0ff (0.99) in golden, ..."
std::string describe(const Difference& difference);

struct BenchResult {
  std::uint64_t fragments = 0;     // that left the RTL
  std::uint64_t cycles = 0;        // from the end of reset to idle
  std::uint64_t mismatches = 0;    // fragments that differ, are missing or too many
  std::uint64_t zero_vectors = 0;  // fragments with the zero flag
  std::optional<Difference> first;
  double cpu_seconds = 0;  // simulation and golden model; neither building the model nor the replay
  bool stopped = false;    // by stop_after
  bool equal() const { return !stopped && mismatches == 0 && !first; }
};

struct BenchSinks {
  // Fragments in the order they leave the RTL. A packet ends with the fragment whose `last` is set.
  std::function<void(std::span<const Fragment>)> fragments;
  // Also every stage's values, as values(config) lists them; slows the simulation down. An element is sign-extended
  // where its value is signed; what the configuration lacks is zero.
  std::function<void(const Fragment&, const FragmentValues&)> values;
};

// Draws a stream of packets. Throws ModelBuildError when the model cannot be built.
BenchResult run_bench(const Config& config, const PacketStream& stream, const std::vector<Texture>& textures,
                      std::string_view frame_name, const BenchOptions& options = {}, const BenchSinks& sinks = {});
BenchResult run_bench(const Config& config, const Frame& frame, const BenchOptions& options = {},
                      const BenchSinks& sinks = {});

}  // namespace wrinkle

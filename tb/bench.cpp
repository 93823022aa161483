#include "tb/bench.h"

#include <fmt/format.h>

#include <map>

#include "tb/blame.h"
#include "tb/cpu_time.h"
#include "tb/testbench.h"

namespace wrinkle {
namespace {

double scaled(std::int64_t value, int fraction_bits) {
  return static_cast<double>(value) / static_cast<double>(std::int64_t{1} << fraction_bits);
}

// The model, new from its seed, or as the run before left it.
Model& model_for(const std::filesystem::path& library, const BenchOptions& options) {
  static std::unique_ptr<Model> model;
  static std::filesystem::path loaded;
  if (!model || loaded != library || !options.keep_registers) {
    model = std::make_unique<Model>(library, options.seed);
    loaded = library;
  }
  return *model;
}

std::string where(const Difference& d) {
  std::string text = d.frame.empty() ? "" : fmt::format("frame {}, ", d.frame);
  if (d.triangle >= 0) text += fmt::format("triangle {} (draw {}, packet {}), ", d.triangle, d.draw, d.packet);
  return text + fmt::format("pixel ({}, {}), fragment {}, clock {}", d.x, d.y, d.fragment, d.cycle);
}

std::string what(const Difference& d) {
  switch (d.kind) {
    case Difference::Kind::kMissing:
      return "the RTL has drawn too few fragments";
    case Difference::Kind::kExtra:
      return "the RTL has drawn too many fragments";
    case Difference::Kind::kHang:
      return "the RTL hangs";
    case Difference::Kind::kRequest:
      return "the RTL asks for a texel outside its texture";
    case Difference::Kind::kHold:
      return "a stream changed before it was taken";
    case Difference::Kind::kIdle:
      return "the core said that it is idle, with a packet held or a fragment in flight";
    case Difference::Kind::kValue:
      break;
  }
  return d.value.empty() ? "the fragment differs" : "";
}

}  // namespace

double Difference::golden_real() const { return scaled(golden, fraction_bits); }
double Difference::rtl_real() const { return scaled(rtl, fraction_bits); }

std::string describe(const Difference& d) {
  std::string text = where(d) + ": ";
  if (!d.value.empty()) {
    const int digits = (d.width + 3) / 4;
    const std::uint64_t mask = d.width >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << d.width) - 1;
    const auto number = [&](std::int64_t value, double real) {
      return fmt::format("0x{:0{}x} ({})", static_cast<std::uint64_t>(value) & mask, digits, real);
    };
    text += fmt::format("first stage that differs is {}, {}[{}]: golden {}, rtl {}", d.stage, d.value, d.element,
                        number(d.golden, d.golden_real()), number(d.rtl, d.rtl_real()));
  } else {
    text += what(d);
    text += d.stage.empty() ? "; the replay shows no stage that differs" : fmt::format("; stage {}", d.stage);
  }
  if (!d.trace.empty()) text += fmt::format("; waveform {} at clock {}", d.trace.string(), d.trace_cycle);
  return text;
}

BenchResult run_bench(const Config& config, const PacketStream& stream, const std::vector<Texture>& textures,
                      std::string_view frame_name, const BenchOptions& options, const BenchSinks& sinks) {
  BenchRun run;
  run.config = &config;
  run.words = stream.words;
  run.textures = &textures;
  run.options = &options;
  run.sinks = &sinks;
  run.model = &model_for(build_model(config, options.model, options.progress), options);
  run.tapped = static_cast<bool>(sinks.values);
  run.stop_after = options.stop_after;

  BenchResult result;
  const double start = cpu_seconds();
  simulate(run);
  result.cpu_seconds = cpu_seconds() - start;
  result.fragments = run.fragments;
  result.cycles = run.cycles;
  result.mismatches = run.mismatches;
  result.zero_vectors = run.zero_vectors;
  result.stopped = run.stopped;
  if (!run.first && run.bad_request) run.first = run.bad_request;
  if (run.first && !run.stopped) result.first = blame(run, stream, frame_name);
  return result;
}

BenchResult run_bench(const Config& config, const Frame& frame, const BenchOptions& options, const BenchSinks& sinks) {
  return run_bench(config, build_packets(config, frame), frame.textures, frame.name, options, sinks);
}

}  // namespace wrinkle

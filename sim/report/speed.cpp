#include "sim/report/speed.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "golden/exact/exact.h"
#include "golden/pixel/pixel.h"
#include "sim/command.h"
#include "tb/cpu_time.h"

namespace wrinkle {
namespace {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// Repeats `draw`, which gives the fragments it drew, for long enough to be measured.
double rate(const std::function<std::uint64_t()>& draw_once) {
  constexpr double kLongEnough = .2;
  std::uint64_t fragments = 0;
  const double start = cpu_seconds();
  double spent = 0;
  do {
    fragments += draw_once();
    spent = cpu_seconds() - start;
  } while (spent < kLongEnough);
  return double(fragments) / spent;
}

using FloatEngine = void (*)(const Config&, const Frame&, const ExactSink&);

double float_rate(FloatEngine engine, const Config& config, const Frame& frame) {
  return rate([&] {
    std::uint64_t fragments = 0;
    engine(config, frame, [&](const ExactFragment&) { ++fragments; });
    return fragments;
  });
}

double golden_rate(Lanes lanes, const Config& config, const PacketStream& stream, const Frame& frame) {
  Golden golden(config, frame.textures, lanes);
  return rate([&] {
    std::uint64_t fragments = 0;
    const auto count = [&](const auto& batch) { fragments += std::uint64_t(batch.count); };
    golden.draw(stream.words, {count, count});
    return fragments;
  });
}

double rtl_rate(const Config& config, const PacketStream& stream, const Frame& frame) {
  BenchOptions options = quiet_bench_options();
  options.compare = false;
  const BenchResult run = run_bench(config, stream, frame.textures, frame.name, options);
  return double(run.fragments) / run.cpu_seconds;
}

}  // namespace

std::vector<EngineSpeed> measure_engines(const Config& config, const Frame& frame, int runs) {
  const PacketStream stream = build_packets(config, frame);
  std::array<std::vector<double>, 5> rates;
  for (int run = 0; run < runs; ++run) {
    rates[0].push_back(float_rate(draw_ideal, config, frame));
    rates[1].push_back(float_rate(draw_exact, config, frame));
    rates[2].push_back(golden_rate(Lanes::kScalar, config, stream, frame));
    rates[3].push_back(golden_rate(Lanes::kSimd, config, stream, frame));
    rates[4].push_back(rtl_rate(config, stream, frame));
  }
  return {{"ideal", median(rates[0]), "Eq. 1-2 at every pixel, float64"},
          {"exact", median(rates[1]), "the algorithm of the datapath, float64"},
          {"golden-scalar", median(rates[2]), "every bit of the hardware"},
          {"golden", median(rates[3]), "every bit of the hardware"},
          {"rtl", median(rates[4]), "every bit and every clock of the hardware"}};
}

ChipSpeed chip_speed(const std::string& name, const Config& config, const Frame& frame, double period_ns) {
  BenchOptions options = quiet_bench_options();
  options.stalls = StallProfile::kNone;
  options.compare = false;
  const BenchResult run = run_bench(config, frame, options);
  ChipSpeed speed{name, double(run.cycles) / double(run.fragments), period_ns, 0};
  if (period_ns > 0) speed.pixels_per_s = 1e9 / (speed.clocks_per_pixel * period_ns);
  return speed;
}

nlohmann::json to_json(const EngineSpeed& speed) {
  return {{"engine", speed.engine}, {"pixels_per_cpu_s", speed.pixels_per_cpu_s}, {"faithful_to", speed.faithful_to}};
}

nlohmann::json to_json(const ChipSpeed& speed) {
  nlohmann::json object{{"config", speed.config}, {"clocks_per_pixel", speed.clocks_per_pixel}};
  if (speed.period_ns > 0) {
    object["period_ns"] = speed.period_ns;
    object["pixels_per_s"] = speed.pixels_per_s;
  }
  return object;
}

}  // namespace wrinkle

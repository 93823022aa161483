#include "sim/comparison.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/engine.h"

namespace wrinkle {
namespace {

struct Pictures {
  Picture ideal, exact, golden, rtl;
  std::vector<std::uint8_t> covered;
};

// The RTL's picture is made from the fragments of the run that is compared.
BenchResult draw_and_compare(const Config& config, const Frame& frame, const BenchOptions& options,
                             Pictures& pictures) {
  const ComparedDrawing drawing = draw_compared(config, frame, options);
  pictures.rtl = drawing.framebuffer.colour();
  pictures.covered = drawing.framebuffer.covered();
  pictures.golden = drawn(Engine::kGolden, config, frame).colour();
  pictures.exact = drawn(Engine::kExact, config, frame).colour();
  pictures.ideal = drawn(Engine::kIdeal, config, frame).colour();
  return drawing.result;
}

}  // namespace

ComparedDrawing draw_compared(const Config& config, const Frame& frame, const BenchOptions& options) {
  ComparedDrawing drawing{framebuffer_for(config, frame), {}};
  BenchSinks sinks;
  sinks.fragments = [&](std::span<const Fragment> fragments) {
    for (const Fragment& fragment : fragments) drawing.framebuffer.add(to_sample(config, fragment, 0));
  };
  drawing.result = run_bench(config, frame, options, sinks);
  return drawing;
}

void print_comparison_heading() {
  fmt::print(
      "frame              config              pixels mismatches     clocks  px/clk  method dB precision dB  image\n");
}

nlohmann::json compare_engines(const Comparison& comparison, const RtlOptions& rtl, const std::filesystem::path& folder,
                               std::vector<Picture>& sheet) {
  const Scene scene = scene_named(comparison.scene);
  const std::string& config_name = comparison.config.empty() ? scene.config : comparison.config;
  const Config config = chosen_config({config_name, comparison.set}, scene.config);
  const Frame frame = build_frame(config, scene);
  Pictures pictures;
  // The RTL draws twice: once without stalls, which gives the clocks, and once under stalls. Both are compared.
  RtlOptions unstalled = rtl;
  unstalled.stalls = "none";
  const BenchResult run = draw_and_compare(config, frame, bench_options(unstalled), pictures);
  const BenchResult stalled = run_bench(config, frame, bench_options(rtl));
  for (const BenchResult* result : {&run, &stalled})
    if (result->first) fmt::print("{}\n", describe(*result->first));

  const auto path = [&](const std::string& what) { return folder / (comparison.name + what + ".png"); };
  const Picture method_picture = difference_picture(pictures.exact, pictures.ideal, kDifferenceGain);
  const Picture precision_picture = difference_picture(pictures.golden, pictures.exact, kDifferenceGain);
  write_picture(path(""), pictures.rtl);
  write_picture(path("_golden"), pictures.golden);
  write_picture(path("_ideal"), pictures.ideal);
  write_picture(path("_rtl_minus_golden"), difference_picture(pictures.rtl, pictures.golden, kDifferenceGain));
  write_picture(path("_method_error"), method_picture);
  write_picture(path("_precision_error"), precision_picture);
  for (const Picture& picture : {pictures.rtl, method_picture, precision_picture}) sheet.push_back(picture);

  const PictureDifference method = compare(pictures.exact, pictures.ideal, pictures.covered);
  const PictureDifference precision = compare(pictures.golden, pictures.exact, pictures.covered);
  const PictureDifference engines =
      compare(pictures.rtl, pictures.golden, std::vector<std::uint8_t>(pictures.covered.size(), 1));
  const double rate = run.cycles > 0 ? double(run.fragments) / double(run.cycles) : 0;
  const bool equal = run.equal() && stalled.equal();
  const std::uint64_t mismatches =
      equal ? engines.different : std::max<std::uint64_t>(run.mismatches + stalled.mismatches, 1);
  fmt::print("{:<18} {:<16} {:>9} {:>10} {:>10} {:>8.3f} {:>9.2f} {:>9.2f}  {}\n", comparison.name, config_name,
             run.fragments, mismatches, run.cycles, rate, method.psnr_db, precision.psnr_db, path("").string());
  std::fflush(stdout);
  return {{"name", comparison.name},
          {"config", config_name},
          {"pixels", run.fragments},
          {"mismatches", mismatches},
          {"cycles", run.cycles},
          {"cycles_with_stalls", stalled.cycles},
          {"pixels_per_clock", rate},
          {"psnr_method_db", method.psnr_db},
          {"psnr_precision_db", precision.psnr_db},
          {"max_error_method", method.max_error},
          {"max_error_precision", precision.max_error},
          {"covered_pixels", method.pixels},
          {"set", comparison.set},
          {"seed", rtl.seed},
          {"stalls", rtl.stalls},
          {"image", path("").string()}};
}

}  // namespace wrinkle

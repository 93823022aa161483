// demo: the paper's patch, Newell's teapot and a glTF model, by golden and RTL under random stalls, compared and drawn.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "sim/command.h"
#include "sim/engine.h"
#include "sim/picture.h"
#include "sim/progress.h"
#include "sim/tessellation.h"

namespace wrinkle {
namespace {

struct Options {
  std::filesystem::path folder = "out", json;
  RtlOptions rtl;
};

struct Entry {
  std::string name, scene;
};

std::vector<Entry> entries() {
  std::vector<Entry> list{{"fig1", "patch_fig1"}, {"fig6", "patch_fig6"}, {"fig7", "patch_fig7"}, {"teapot", "teapot"}};
  const std::filesystem::path assets = shared_assets();
  if (!assets.empty()) list.push_back({"avocado", (assets / "gltf/Avocado/glTF/Avocado.gltf").string()});
  return list;
}

struct Pictures {
  Picture ideal, exact, golden, rtl;
  std::vector<std::uint8_t> covered;
};

Picture draw_picture(Engine engine, const Config& config, const Frame& frame) {
  Framebuffer framebuffer = framebuffer_for(config, frame);
  draw(engine, config, frame, {}, [&](const Sample& sample) { framebuffer.add(sample); });
  return framebuffer.colour();
}

// The RTL's picture is made from the fragments of the run that is compared.
BenchResult draw_and_compare(const Config& config, const Frame& frame, const BenchOptions& options,
                             Pictures& pictures) {
  Framebuffer framebuffer = framebuffer_for(config, frame);
  BenchSinks sinks;
  sinks.fragments = [&](std::span<const Fragment> fragments) {
    for (const Fragment& fragment : fragments) framebuffer.add(to_sample(config, fragment, 0));
  };
  const BenchResult result = run_bench(config, frame, options, sinks);
  pictures.rtl = framebuffer.colour();
  pictures.covered = framebuffer.covered();
  pictures.golden = draw_picture(Engine::kGolden, config, frame);
  pictures.exact = draw_picture(Engine::kExact, config, frame);
  pictures.ideal = draw_picture(Engine::kIdeal, config, frame);
  return result;
}

// Without an analytic surface there is no ideal picture, and so no method error.
bool has_ideal(const Frame& frame) {
  return std::any_of(frame.draws.begin(), frame.draws.end(), [](const Draw& draw) {
    return std::any_of(draw.triangles.begin(), draw.triangles.end(),
                       [](const ScreenTriangle& triangle) { return triangle.surface != nullptr; });
  });
}

// Errors are small: what is shown is eight times as large, about mid grey.
constexpr double kGain = 8;

nlohmann::json draw_entry(const Entry& entry, const Options& options, std::vector<Picture>& sheet) {
  const Scene scene = scene_named(entry.scene);
  const Config config = chosen_config({}, scene.config);
  const Frame frame = build_frame(config, scene);
  Pictures pictures;
  // Once as fast as it goes, for the clocks, and once under stalls: both are compared.
  RtlOptions unstalled = options.rtl;
  unstalled.stalls = "none";
  const BenchResult run = draw_and_compare(config, frame, bench_options(unstalled), pictures);
  const BenchResult stalled = run_bench(config, frame, bench_options(options.rtl));
  for (const BenchResult* result : {&run, &stalled})
    if (result->first) fmt::print("{}\n", describe(*result->first));

  const auto path = [&](const std::string& what) { return options.folder / (entry.name + what + ".png"); };
  const Picture method_picture = difference_picture(pictures.exact, pictures.ideal, kGain);
  const Picture precision_picture = difference_picture(pictures.golden, pictures.exact, kGain);
  write_picture(path(""), pictures.rtl);
  write_picture(path("_golden"), pictures.golden);
  write_picture(path("_ideal"), pictures.ideal);
  write_picture(path("_rtl_minus_golden"), difference_picture(pictures.rtl, pictures.golden, kGain));
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
  const nlohmann::json method_db = has_ideal(frame) ? nlohmann::json(method.psnr_db) : nlohmann::json();
  fmt::print("{:<10} {:<12} {:>8} {:>10} {:>10} {:>8.3f} {:>9} {:>9.2f}  {}\n", entry.name, scene.config, run.fragments,
             mismatches, run.cycles, rate, method_db.is_null() ? "-" : fmt::format("{:.2f}", method.psnr_db),
             precision.psnr_db, path("").string());
  std::fflush(stdout);
  return {{"name", entry.name},
          {"config", scene.config},
          {"pixels", run.fragments},
          {"mismatches", mismatches},
          {"cycles", run.cycles},
          {"cycles_with_stalls", stalled.cycles},
          {"pixels_per_clock", rate},
          {"psnr_method_db", method_db},
          {"psnr_precision_db", precision.psnr_db},
          {"max_error_method", method.max_error},
          {"max_error_precision", precision.max_error},
          {"covered_pixels", method.pixels},
          {"seed", options.rtl.seed},
          {"stalls", options.rtl.stalls},
          {"image", path("").string()}};
}

int demo(const Options& options) {
  fmt::print("frame      config         pixels mismatches     clocks  px/clk  method dB precision dB  image\n");
  nlohmann::json frames = nlohmann::json::array();
  std::vector<Picture> sheet;
  bool equal = true;
  for (const Entry& entry : entries()) {
    frames.push_back(draw_entry(entry, options, sheet));
    equal &= frames.back()["mismatches"] == 0;
  }
  if (shared_assets().empty()) fmt::print("avocado: left out, ../shared/assets is not here\n");
  const std::filesystem::path sheet_path = options.folder / "sheet.png";
  write_picture(sheet_path, contact_sheet(sheet, 3));
  fmt::print("{}: each frame, its method error and its precision error ({} times as large)\n", sheet_path.string(),
             kGain);
  const nlohmann::json tessellation = tessellation_table();
  write_json(options.json,
             {{"equal", equal}, {"frames", frames}, {"sheet", sheet_path.string()}, {"tessellation", tessellation}});
  return equal ? kExitEqual : kExitDifferent;
}

}  // namespace

void add_demo(CLI::App& app, Run& run) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("demo", "The main job: the paper's pictures by golden and RTL, compared bit for bit");
  command->add_option("-o,--output", options->folder, "Folder for the pictures")->capture_default_str();
  add_rtl_options(*command, options->rtl);
  add_json_option(*command, options->json);
  command->callback([options, &run] { run = [options] { return demo(*options); }; });
}

}  // namespace wrinkle

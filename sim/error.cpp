// error: how much of the precision error each stage makes, and the error of the method beside it.
#include "sim/report/error.h"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "sim/command.h"
#include "sim/config_file.h"
#include "sim/losses.h"
#include "sim/report/baseline.h"

namespace wrinkle {
namespace {

struct Options {
  std::string config, scene;
  std::vector<std::string> set;
  bool check = false, keep = false;
  std::filesystem::path json;
};

void print_picture(const char* name, const PictureError& error) {
  fmt::print("{:<28} PSNR {:6.2f} dB   p99.9 {:6.2f}   maximum {:6.2f} grey levels   SSIM {:.6f}\n", name,
             error.psnr_db, 255 * error.p999, 255 * error.max, error.ssim);
}

struct Measured {
  ErrorReport report;
  Config config;
};

void print_report(const ErrorReport& report) {
  fmt::print("{} on {}, {} fragments; each number RMS / maximum\n", report.config, report.scene, report.fragments);
  fmt::print("{:<14} {:>15} {:>17} {:>19} {:>15} {:>10} {:>11}\n", "stage", "ulp", "degrees", "length", "grey levels",
             "alone dB", "without dB");
  for (const PartError& p : report.parts) {
    fmt::print("{:<14} {:7.3f}/{:7.3f} {:8.4f}/{:8.4f} {:9.6f}/{:9.6f} {:7.3f}/{:7.3f} {:>10.2f} {:>11.2f}\n", p.name,
               p.ulp.rms, p.ulp.max, p.degrees.rms, p.degrees.max, p.length.rms, p.length.max, p.grey.rms, p.grey.max,
               p.alone_db, p.without_db);
  }
  print_picture("precision, golden to exact", report.precision);
  print_picture("method, exact to ideal", report.method);
}

Measured measure(const std::string& config_name, const std::string& scene_name, const std::vector<std::string>& set) {
  const Config config = apply_overrides(load_config(config_name), set);
  const Scene scene = scene_named(scene_name);
  say_losses(config, scene);
  const Frame frame = build_frame(config, scene);
  Measured measured{{}, config};
  with_objects_named(config, scene, frame, [&] { measured.report = measure_error(config_name, config, frame); });
  print_report(measured.report);
  return measured;
}

// What the baseline holds: the named configurations on the paper's patch.
int baseline(const Options& options) {
  FiguresByName figures;
  for (const char* config : {"lean", "standard", "fine", "extreme"}) {
    const ErrorReport report = measure(config, "patch_fig6", {}).report;
    const std::string name = fmt::format("{}.patch_fig6.", config);
    figures[name + "precision_db"] = report.precision.psnr_db;
    figures[name + "method_db"] = report.method.psnr_db;
    for (const PartError& part : report.parts) figures[name + std::string(part.name) + "_alone_db"] = part.alone_db;
  }
  if (options.keep) write_baseline(baseline_path("error"), figures);
  return check_baseline(baseline_path("error"), figures) ? kExitEqual : kExitDifferent;
}

int error(Options options) {
  if (options.check || options.keep) return baseline(options);
  sort_names(options.config, options.scene);
  if (options.config.empty()) options.config = "standard";
  if (options.scene.empty()) options.scene = "patch_fig6";
  const Measured measured = measure(options.config, options.scene, options.set);
  nlohmann::json json = to_json(measured.report);
  json["parameters"] = parameters_json(measured.config);
  write_json(options.json, json);
  return kExitEqual;
}

}  // namespace

void add_error(CLI::App& app, Action& run) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("error", "Precision error by stage, method error apart");
  command->add_option("config", options->config, "Configuration, by name or .toml file; else standard");
  command->add_option("scene", options->scene, "Scene, by name or file; else patch_fig6");
  add_set_option(*command, options->set);
  command->add_flag("--check", options->check, "Against tests/baselines/error.json; exit 1 when worse");
  command->add_flag("--keep", options->keep, "Write tests/baselines/error.json");
  add_json_option(*command, options->json);
  command->callback([options, &run] { run = [options] { return error(*options); }; });
}

}  // namespace wrinkle

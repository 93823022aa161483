// figures: Figs. 5, 6 and 7 of the paper side by side, as pictures and as numbers.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "sim/command.h"
#include "sim/input_error.h"
#include "sim/report/paper.h"

namespace wrinkle {
namespace {

using nlohmann::json;

struct Options {
  std::filesystem::path folder = "out", json;
  std::string engine = "rtl";
  int size = 512;
  RtlOptions rtl;
};

// These pictures show the hardware, so the engines in float64 are not offered.
Engine hardware_engine(const std::string& name) {
  if (name != "rtl" && name != "golden") throw InputError(Place{"--engine"}, name, "rtl or golden");
  return engine_named(name);
}

void print_figures(const json& figures) {
  fmt::print("\npicture            config             pixels mismatches\n");
  for (const json& f : figures)
    fmt::print("{:<18} {:<16} {:>8} {:>10}\n", f["name"].get<std::string>(), f["config"].get<std::string>(),
               f["pixels"].get<int>(), f.contains("mismatches") ? f["mismatches"].dump() : "-");
}

void print_pairs(const std::vector<json>& pairs) {
  fmt::print("\nagainst each other                     PSNR dB    worst    p99.9     SSIM\n");
  for (const json& p : pairs)
    fmt::print("{:<17} - {:<17} {:>8.2f} {:>8.4f} {:>8.4f} {:>8.5f}\n", p["a"].get<std::string>(),
               p["b"].get<std::string>(), p["psnr_db"].get<double>(), p["max"].get<double>(), p["p999"].get<double>(),
               p["ssim"].get<double>());
}

void print_tessellation(const json& rows) {
  fmt::print("\nmethod error, dB             4x4     8x8   16x16   32x32\n");
  std::string last;
  for (const json& row : rows) {
    const std::string name =
        fmt::format("{}, {}", row["method"].get<std::string>(), row["filtering"].get<std::string>());
    if (name != last) fmt::print("{}{:<24}", last.empty() ? "" : "\n", name);
    fmt::print(" {:>7.2f}", row["psnr_method_db"].get<double>());
    last = name;
  }
  fmt::print("\n");
}

void print_others(const json& results) {
  fmt::print("\nrotated frame against Phong shading, exact:");
  for (const json& row : results["highlight"]["exact"])
    fmt::print(" {0}x{0} {1:.2f} dB", row["divisions"].get<int>(), row["psnr_db"].get<double>());
  const json& warp = results["warp"];
  fmt::print(
      "\nEq. 8-11 against Eq. 3-6, exact: normals {:.2f} degrees apart in the mean, {:.2f} where there are bumps, "
      "{:.2f} at most; {:.2f} dB\n",
      warp["mean_degrees"].get<double>(), warp["mean_degrees_bumped"].get<double>(), warp["max_degrees"].get<double>(),
      warp["psnr_exact_db"].get<double>());
}

int figures(const Options& options) {
  PaperFigures paper = draw_paper_figures({hardware_engine(options.engine), options.size, options.rtl});
  json images = json::object();
  for (const auto* list : {&paper.pictures, &paper.sheets}) {
    for (const NamedPicture& named : *list) {
      const std::filesystem::path path = options.folder / (named.name + ".png");
      write_picture(path, named.picture);
      images[named.name] = path.string();
    }
  }
  json& results = paper.results;
  json drawn = results["figures"];
  for (const char* part : {"held", "highlight"})
    drawn.insert(drawn.end(), results[part]["figures"].begin(), results[part]["figures"].end());
  print_figures(drawn);
  std::vector<json> pairs = results["pairs"];
  pairs.insert(pairs.end(),
               {results["held"]["pair"], results["highlight"]["pair"], results["highlight"]["highlight_pair"]});
  print_pairs(pairs);
  print_tessellation(results["tessellation"]);
  print_others(results);
  fmt::print("{}\n", images["figures"].get<std::string>());
  results["images"] = images;
  write_json(options.json, results);
  return paper.equal ? kExitEqual : kExitDifferent;
}

}  // namespace

void add_figures(CLI::App& app, Action& run) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("figures", "Figs. 5, 6 and 7 of the paper side by side, and their differences");
  command->add_option("-o,--output", options->folder, "Folder for the pictures")->capture_default_str();
  command->add_option("--size", options->size, "Pixels, both ways")->capture_default_str()->check(CLI::Range(64, 1024));
  command->add_option("-e,--engine", options->engine, "rtl, compared with golden; or golden")->capture_default_str();
  add_rtl_options(*command, options->rtl);
  add_json_option(*command, options->json);
  command->callback([options, &run] { run = [options] { return figures(*options); }; });
}

}  // namespace wrinkle

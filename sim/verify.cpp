// verify: golden against RTL, every fragment; or both against a file of vectors with known answers.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "sim/command.h"
#include "sim/datapaths.h"
#include "sim/digest/digest.h"
#include "sim/input_error.h"
#include "sim/layout.h"
#include "sim/progress.h"
#include "sim/scene/scene_reader.h"
#include "sim/vectors/vectors.h"
#include "tb/random_frame.h"

namespace wrinkle {
namespace {

struct Options {
  std::vector<std::string> scenes, configs, set;
  std::vector<std::filesystem::path> vectors;
  std::uint64_t random = 0;
  bool all = false;
  std::filesystem::path folder = "out";
  RtlOptions rtl;
  std::filesystem::path trace, json;
  DigestOptions digest;
};

// Compares one frame and prints one line, with the first difference below it.
bool verify_frame(const Config& config, const std::string& config_name, const Frame& frame, const BenchOptions& options,
                  nlohmann::json& runs) {
  const BenchResult result = run_bench(config, frame, options);
  fmt::print("{:<28} {:<12} {:>9} fragments {:>10} clocks  {}\n", frame.name, config_name, result.fragments,
             result.cycles, result.equal() ? "equal" : fmt::format("{} DIFFERENT", result.mismatches));
  nlohmann::json run{{"scene", frame.name},     {"config", config_name},           {"fragments", result.fragments},
                     {"cycles", result.cycles}, {"mismatches", result.mismatches}, {"equal", result.equal()}};
  if (result.first) {
    fmt::print("{}\n", describe(*result.first));
    if (!result.first->trace.empty())
      fmt::print("waveform: {}, at clock {}\n", result.first->trace.string(), result.first->trace_cycle);
    run["first"] = to_json(*result.first);
  }
  runs.push_back(std::move(run));
  return result.equal();
}

bool verify_scenes(const Options& options, nlohmann::json& runs) {
  const BenchOptions bench = [&] {
    BenchOptions b = bench_options(options.rtl);
    b.trace = options.trace;
    return b;
  }();
  bool equal = true;
  for (const std::string& name : options.scenes) {
    const Scene scene = scene_named(name);
    const std::vector<std::string> configs = options.configs.empty() ? std::vector{scene.config} : options.configs;
    for (const std::string& config_name : configs) {
      const Config config = chosen_config({config_name, options.set}, scene.config);
      equal &= verify_frame(config, config_name, build_frame(config, scene), bench, runs);
    }
  }
  return equal;
}

// Draws random frames of about 20,000 fragments, each from a seed of its own, until there are as many fragments as
// were asked for.
bool verify_random(const Options& options, nlohmann::json& runs) {
  constexpr std::uint64_t kFrame = 20000;
  bool equal = true;
  for (const std::string& name : options.configs.empty() ? std::vector<std::string>{"standard"} : options.configs) {
    const Config config = chosen_config({name, options.set}, "standard");
    Progress progress(fmt::format("random triangles, {}", name), options.random);
    BenchOptions bench = bench_options(options.rtl);
    bench.trace = options.trace;
    std::uint64_t fragments = 0, cycles = 0, mismatches = 0, frames = 0;
    for (; fragments < options.random && mismatches == 0; ++frames) {
      bench.seed = options.rtl.seed + frames;
      RandomFrame wish;
      wish.seed = bench.seed;
      wish.fragments = double(std::min(kFrame, options.random - fragments));
      const Frame frame = random_frame(config, wish);
      const BenchResult result = run_bench(config, frame, bench);
      if (!result.equal()) {
        progress.clear();
        return verify_frame(config, name, frame, bench, runs);
      }
      fragments += result.fragments;
      cycles += result.cycles;
      mismatches += result.mismatches;
      progress.at(fragments);
    }
    progress.clear();
    fmt::print("{:<28} {:<12} {:>9} fragments {:>10} clocks  equal\n",
               fmt::format("random seeds {} to {}", options.rtl.seed, bench.seed), name, fragments, cycles);
    runs.push_back({{"scene", "random"},
                    {"config", name},
                    {"seed", options.rtl.seed},
                    {"frames", frames},
                    {"fragments", fragments},
                    {"cycles", cycles},
                    {"mismatches", mismatches},
                    {"equal", true}});
  }
  return equal;
}

bool verify_vectors(const Options& options, nlohmann::json& runs) {
  bool good = true;
  const Config config =
      chosen_config({options.configs.empty() ? "" : options.configs.front(), options.set}, "standard");
  const BenchOptions bench = bench_options(options.rtl);
  for (const std::filesystem::path& path : options.vectors) {
    const VectorReport report = check_vectors(path, config, &bench);
    fmt::print("{}: {} vectors, bound {:.4g} {}\n", path.filename().string(), name(report.kind), report.bound,
               report.unit);
    for (const VectorScore& score : report.scores) {
      fmt::print("  {:<14} {:>6} cases, {} outside the bound, worst {:.4g}\n", score.engine, score.cases, score.outside,
                 score.worst);
      if (score.outside > 0) fmt::print("  first: {}\n", score.first);
      runs.push_back({{"vectors", path.string()},
                      {"kind", name(report.kind)},
                      {"engine", score.engine},
                      {"cases", score.cases},
                      {"differences", score.outside},
                      {"worst", score.worst},
                      {"bound", report.bound},
                      {"unit", report.unit},
                      {"equal", score.outside == 0}});
    }
    good &= report.good();
  }
  return good;
}

// Draws a frame of every datapath and option. Returns true when all are equal.
bool verify_all(const Options& options, nlohmann::json& frames) {
  print_comparison_heading();
  std::vector<Picture> sheet;
  bool equal = true;
  for (const DatapathFrame& frame : datapath_frames()) {
    frames.push_back(compare_engines(frame.comparison, options.rtl, options.folder, sheet));
    frames.back()["row"] = frame.row;
    equal &= frames.back()["mismatches"] == 0;
  }
  write_picture(options.folder / "datapaths.png", contact_sheet(sheet, 3));
  return equal;
}

int digest(const Options& options) {
  DigestOptions digest = options.digest;
  digest.scenes = options.scenes;
  digest.configs = options.configs;
  digest.engines.rtl = options.rtl.rtl;
  nlohmann::json object;
  const bool equal = verify_digest(digest, object);
  write_json(options.json, {{"equal", equal}, {"digest", object}});
  return equal ? kExitEqual : kExitDifferent;
}

int verify(const Options& options) {
  if (!options.digest.file.empty()) return digest(options);
  if (options.scenes.empty() && options.vectors.empty() && options.random == 0 && !options.all)
    throw InputError(Place{"verify"}, "nothing to verify", "scenes, --all, --random N or --vectors FILE");
  nlohmann::json runs = nlohmann::json::array();
  bool equal = verify_scenes(options, runs);
  if (options.random > 0) equal &= verify_random(options, runs);
  equal &= verify_vectors(options, runs);
  nlohmann::json frames = nlohmann::json::array();
  if (options.all) equal &= verify_all(options, frames);
  write_json(options.json, {{"equal", equal}, {"runs", runs}, {"frames", frames}});
  return equal ? kExitEqual : kExitDifferent;
}

// A digest is drawn with settings of its own, so that two of them can be compared.
void add_digest_options(CLI::App& command, DigestOptions& options) {
  CLI::Option* file =
      command.add_option("--digest", options.file,
                         "Write a hash of every stage's values and the clocks of the RTL to this file, a line a "
                         "frame; SCENEs (also random:SEED) and -c choose among the frames");
  for (const char* other : {"--set", "--all", "--random", "--vectors", "--stalls", "--seed", "--latency", "--trace"})
    file->excludes(command.get_option(other));
  command.add_option("--against", options.against, "Digest to draw again and to compare with")
      ->needs(file)
      ->check(CLI::ExistingFile);
  command.add_flag("--golden-only", options.engines.golden_only, "Leave out the RTL, and so its clocks, of --digest")
      ->needs(file);
  command.add_option("-j,--jobs", options.processes, "Processes that draw for --digest; else one a core")
      ->needs(file)
      ->check(CLI::Range(1, 1024));
}

}  // namespace

void add_verify(CLI::App& app, Action& run) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("verify", "Compare golden and RTL, every fragment, bit for bit");
  command->add_option("SCENE", options->scenes, fmt::format("Scene files, or {}", fmt::join(named_scenes(), ", ")));
  command->add_option("-c,--config", options->configs, "Configurations, by commas; else what each scene names")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--set", options->set, "Change a parameter of the configurations: KEY=VALUE")
      ->allow_extra_args(false);
  command->add_flag("--all", options->all, "A frame of every datapath and option, with pictures and errors");
  command->add_option("-o,--output", options->folder, "Folder for the pictures of --all")->capture_default_str();
  command->add_option("--random", options->random, "At least this many fragments of random triangles");
  command->add_option("--vectors", options->vectors, "Files of vectors: coverage, trilinear, normalize, rsqrt")
      ->allow_extra_args(false);
  add_rtl_options(*command, options->rtl);
  command->add_option("--trace", options->trace, "FST waveform to write around the first difference");
  add_digest_options(*command, options->digest);
  add_json_option(*command, options->json);
  command->callback([options, &run] { run = [options] { return verify(*options); }; });
}

}  // namespace wrinkle

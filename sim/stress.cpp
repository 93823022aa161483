// stress: the catalogue of numerical extremes, as a table.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "sim/command.h"
#include "sim/config_file.h"
#include "sim/stress/catalogue.h"

namespace wrinkle {
namespace {

struct Options {
  std::vector<int> entries;
  RtlOptions rtl;
  std::string config = "standard";
  bool golden_only = false, long_run = false;
  std::filesystem::path json;
};

// Differences between golden and RTL over the stimuli of an entry.
std::uint64_t rtl_mismatches(const ExtremeEntry& entry, const Extreme& extreme, const BenchOptions& bench) {
  std::uint64_t mismatches = 0;
  for (const Stimulus& stimulus : extreme.stimuli) {
    const BenchResult result = run_bench(stimulus.config(), stimulus.stream(), stimulus.textures(),
                                         fmt::format("extreme {}", entry.number), bench);
    mismatches += result.mismatches + (result.equal() ? 0 : result.mismatches == 0);
    if (result.first) fmt::print("{}\n", describe(*result.first));
  }
  return mismatches;
}

bool chosen(const Options& options, int number) {
  return options.entries.empty() ||
         std::find(options.entries.begin(), options.entries.end(), number) != options.entries.end();
}

int stress(const Options& options) {
  const BenchOptions bench = bench_options(options.rtl);
  const Config config = load_config(options.config);
  nlohmann::json rows = nlohmann::json::array();
  bool good = true;
  fmt::print(
      " nr  extreme                                              cases      worst      bound  unit         RTL\n");
  for (const ExtremeEntry& entry : extremes()) {
    if (!chosen(options, entry.number) || (entry.long_run && !options.long_run)) continue;
    const Extreme extreme = entry.run ? entry.run(config) : Extreme{.unreachable = entry.unreachable};
    if (!extreme.unreachable.empty()) {
      fmt::print("{:>3}  {:<48}  not reachable: {}\n", entry.number, entry.title, extreme.unreachable);
      rows.push_back({{"number", entry.number}, {"title", entry.title}, {"unreachable", extreme.unreachable}});
      continue;
    }
    const std::uint64_t mismatches = options.golden_only ? 0 : rtl_mismatches(entry, extreme, bench);
    const bool inside = extreme.inside() && extreme.cases > 0;
    good &= inside && mismatches == 0;
    const std::string rtl = options.golden_only       ? "-"
                            : extreme.stimuli.empty() ? "host only"
                            : mismatches == 0         ? "equal"
                                                      : fmt::format("{} DIFFERENT", mismatches);
    fmt::print("{:>3}  {:<48} {:>9} {:>10.4g} {:>10.4g}  {:<12} {}{}\n", entry.number, entry.title, extreme.cases,
               extreme.worst, extreme.bound, extreme.unit, rtl, inside ? "" : "  OUTSIDE: " + extreme.where);
    std::fflush(stdout);
    rows.push_back({{"number", entry.number},
                    {"title", entry.title},
                    {"cases", extreme.cases},
                    {"worst", extreme.worst},
                    {"bound", extreme.bound},
                    {"unit", extreme.unit},
                    {"mismatches", mismatches},
                    {"inside", inside}});
  }
  write_json(options.json, {{"equal", good}, {"config", options.config}, {"entries", rows}});
  return good ? kExitEqual : kExitDifferent;
}

}  // namespace

void add_stress(CLI::App& app, Action& run) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("stress", "Draw the catalogue of numerical extremes and print the errors");
  command->add_option("--only", options->entries, "Numbers of entries, by commas")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("-c,--config", options->config, "Whose widths the stimuli are made for")
      ->check(CLI::IsMember(stress_configs()))
      ->capture_default_str();
  command->add_flag("--long", options->long_run, "Also the picture of 4096 by 4096, 16.8 million fragments");
  command->add_flag("--golden-only", options->golden_only, "Leave the RTL out");
  add_rtl_options(*command, options->rtl);
  add_json_option(*command, options->json);
  command->callback([options, &run] { run = [options] { return stress(*options); }; });
}

}  // namespace wrinkle

#include "sim/report/area.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "golden/datapath/datapaths.h"
#include "sim/report/modules.h"
#include "sim/synthesis/result.h"

namespace wrinkle {
namespace {

// Runs every job, two at a time: as many processors as the least machine has. The first failure is thrown at the end.
void run_all(const std::vector<std::function<void()>>& jobs) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex mutex;
  const auto work = [&] {
    for (std::size_t i = next++; i < jobs.size(); i = next++) {
      try {
        jobs[i]();
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
      }
    }
  };
  std::thread second(work);
  work();
  second.join();
  if (failure) std::rethrow_exception(failure);
}

SynthesisResult synthesise_module(const StageModule& module, const AreaOptions& options) {
  return synthesise(module.module, module.parameters, options.library, options.synthesis, options.progress);
}

const StageArea& stage_of(const AreaReport& report, const std::string& name) {
  return *std::find_if(report.stages.begin(), report.stages.end(),
                       [&](const StageArea& stage) { return stage.stage == name; });
}

// What `more` has and `less` has not. The critical path is that of `more`.
SynthesisResult difference(const SynthesisResult& more, const SynthesisResult& less) {
  SynthesisResult result = more;
  result.um2 -= less.um2;
  result.nand2 -= less.nand2;
  result.flip_flops -= less.flip_flops;
  for (const auto& [type, count] : less.cells) result.cells[type] -= count;
  for (const Multiplier& m : less.multipliers) {
    const auto found = std::find(result.multipliers.begin(), result.multipliers.end(), m);
    if (found != result.multipliers.end()) result.multipliers.erase(found);
  }
  return result;
}

void add(SynthesisResult& sum, const SynthesisResult& other) {
  sum.um2 += other.um2;
  sum.nand2 += other.nand2;
  sum.flip_flops += other.flip_flops;
  for (const auto& [type, count] : other.cells) sum.cells[type] += count;
  sum.checked.clocks = std::min(sum.checked.clocks, other.checked.clocks);
  sum.critical_path_ns = std::max(sum.critical_path_ns, other.critical_path_ns);
}

// Splits packet and interpolate of a figure into what shading needs and the given texture coordinates: what Fig. 3 has
// there more than Fig. 1, whose own packets carry no texture coordinates.
AreaReport as_figure(AreaReport report, const AreaReport& plain, const AreaReport& textured) {
  SynthesisResult coordinates =
      difference(stage_of(textured, "interpolate").result, stage_of(plain, "interpolate").result);
  add(coordinates, difference(stage_of(textured, "packet").result, stage_of(plain, "packet").result));
  std::vector<StageArea> stages;
  for (StageArea& stage : report.stages) {
    stage.given = stage.stage == "scan" || stage.stage == "texture";
    for (const char* split : {"packet", "interpolate"}) {
      if (stage.stage != split || report.name == plain.name) continue;
      const SynthesisResult part = difference(stage_of(textured, split).result, stage_of(plain, split).result);
      stage.result = difference(stage.result, part);
    }
    if (stage.stage == "texture" && report.name == plain.name) {
      stage.result = stage_of(textured, "texture").result;
      report.lent_um2 = stage.result.um2 + coordinates.um2;
    }
    if (stage.stage == "texture") stages.push_back({"texture coordinates", coordinates, true});
    stages.push_back(stage);
  }
  report.stages = std::move(stages);
  return report;
}

double sum_given(const AreaReport& report) {
  double sum = 0;
  for (const StageArea& stage : report.stages) sum += stage.given ? stage.result.nand2 : 0;
  return sum;
}

}  // namespace

double AreaReport::sum_um2() const {
  double sum = 0;
  for (const StageArea& stage : stages) sum += stage.result.um2;
  return sum;
}

double AreaReport::sum_nand2() const {
  double sum = 0;
  for (const StageArea& stage : stages) sum += stage.result.nand2;
  return sum;
}

int AreaReport::flip_flops() const {
  int sum = 0;
  for (const StageArea& stage : stages) sum += stage.result.flip_flops;
  return sum;
}

double AreaReport::critical_path_ns() const {
  double path = flat.critical_path_ns;
  for (const StageArea& stage : stages) path = std::max(path, stage.result.critical_path_ns);
  return path;
}

int AreaReport::clocks_equal() const {
  int clocks = stages.empty() ? 0 : stages.front().result.checked.clocks;
  for (const StageArea& stage : stages) clocks = std::min(clocks, stage.result.checked.clocks);
  return clocks;
}

double AreaReport::deviation() const { return flat.um2 > 0 ? (sum_um2() - lent_um2 - flat.um2) / flat.um2 : 0; }

AreaReport measure_area(const std::string& name, const Config& config, const AreaOptions& options) {
  AreaReport report{name, cell_library_name(options.library), {}, {}};
  const std::vector<std::string> names = options.stages.empty() ? stage_names() : options.stages;
  std::vector<std::function<void()>> jobs;
  if (options.flat && options.stages.empty())
    jobs.push_back([&] { report.flat = synthesise_module({"wrinkle_core", core_parameters(config)}, options); });
  report.stages.resize(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    report.stages[i].stage = names[i];
    jobs.push_back([&, i] { report.stages[i].result = synthesise_module(stage_module(names[i], config), options); });
  }
  run_all(jobs);
  return report;
}

AreaReport measure_shading(const std::string& name, const Config& config, const AreaOptions& options) {
  if (Shape(config).normal_like_light == 0)
    throw std::invalid_argument("shading is that of datapath = phong or tangent");
  AreaOptions stage = options;
  stage.flat = false;
  Config bare = config;
  bare.depth = bare.decal = bare.gloss_map = 0;
  stage.stages = {"perturb", "normalize", "light"};
  AreaReport report = measure_area(name, bare, stage);
  bare.datapath = static_cast<int>(Datapath::kPhong);
  stage.stages = {"interpolate"};
  const AreaReport interpolate = measure_area(name, bare, stage);
  report.stages.insert(report.stages.begin(), interpolate.stages.front());
  return report;
}

Figures measure_figures(const Config& phong, const Config& blinn, const Config& tangent, const AreaOptions& options) {
  const AreaReport fig1 = measure_area("fig1", phong, options), fig3 = measure_area("fig3", tangent, options);
  const AreaReport fig2 = measure_area("fig2", blinn, options);
  Figures figures{as_figure(fig1, fig1, fig3), as_figure(fig2, fig1, fig3), as_figure(fig3, fig1, fig3)};
  return figures;
}

std::vector<NormalizerArea> measure_normalizers(const std::vector<int>& unit_bits, const AreaOptions& options) {
  SynthesisOptions synthesis = options.synthesis;
  synthesis.registers = false;
  std::vector<NormalizerArea> areas;
  for (const Normalizer kind : {Normalizer::kFaithful, Normalizer::kCompact, Normalizer::kLite, Normalizer::kNear}) {
    for (const int f : unit_bits) areas.push_back({kind, f, {}});
  }
  std::vector<std::function<void()>> jobs;
  for (NormalizerArea& area : areas) {
    jobs.push_back([&] {
      const VerilogParameters parameters{
          {"NORMALIZER", static_cast<int>(area.kind)}, {"VECTOR_BITS", area.unit_bits}, {"UNIT_BITS", area.unit_bits}};
      area.result = synthesise("wrinkle_unit_vector", parameters, options.library, synthesis, options.progress);
    });
  }
  run_all(jobs);
  return areas;
}

std::string normalizer_name(Normalizer kind) {
  for (const Parameter& parameter : parameters()) {
    if (parameter.member == &Config::normalizer_n) return std::string(parameter.values[static_cast<std::size_t>(kind)]);
  }
  return {};
}

std::string multiplier_text(const std::vector<Multiplier>& multipliers) {
  std::map<std::pair<int, int>, int> counts;
  for (const Multiplier& m : multipliers) ++counts[{std::max(m.a_bits, m.b_bits), std::min(m.a_bits, m.b_bits)}];
  std::string text;
  for (const auto& [bits, count] : counts)
    text += fmt::format("{}{} of {} x {}", text.empty() ? "" : ", ", count, bits.first, bits.second);
  return text.empty() ? "-" : text;
}

nlohmann::json to_json(const AreaReport& report) {
  nlohmann::json stages = nlohmann::json::array();
  for (const StageArea& stage : report.stages) {
    nlohmann::json object = to_json(stage.result);
    object["stage"] = stage.stage;
    object["given"] = stage.given;
    stages.push_back(std::move(object));
  }
  nlohmann::json object{{"name", report.name},
                        {"library", report.library},
                        {"um2", report.sum_um2()},
                        {"nand2", report.sum_nand2()},
                        {"nand2_given", sum_given(report)},
                        {"flip_flops", report.flip_flops()},
                        {"critical_path_ns", report.critical_path_ns()},
                        {"checked", {{"clocks", report.clocks_equal()}, {"different", 0}}},
                        {"stages", stages}};
  if (!report.flat.cells.empty()) {
    object["flat"] = to_json(report.flat);
    object["deviation"] = report.deviation();
  }
  return object;
}

nlohmann::json to_json(const Figures& figures) {
  nlohmann::json object{
      {"fig1", to_json(figures.fig1)}, {"fig2", to_json(figures.fig2)}, {"fig3", to_json(figures.fig3)}};
  const double fig1 = figures.fig1.sum_nand2();
  object["fig3_over_fig1"] = (figures.fig3.sum_nand2() - fig1) / fig1;
  object["fig2_over_fig1"] = (figures.fig2.sum_nand2() - fig1) / fig1;
  return object;
}

nlohmann::json to_json(const NormalizerArea& area) {
  return {{"kind", normalizer_name(area.kind)},
          {"unit_bits", area.unit_bits},
          {"nand2", area.result.nand2},
          {"um2", area.result.um2},
          {"critical_path_ns", area.result.critical_path_ns},
          {"checked", to_json(area.result.checked)},
          {"provenance", area.result.provenance}};
}

}  // namespace wrinkle

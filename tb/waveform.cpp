#include "tb/waveform.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <limits>

namespace wrinkle {
namespace {

constexpr int kIntegerBits = 64;

std::string element_name(const Value& value, int element) {
  if (value.elements == 1) return std::string(value.name);
  return value.elements > 3 ? fmt::format("{}_{}", value.name, element)
                            : fmt::format("{}_{}", value.name, "xyz"[element]);
}

// As the file names a signal: buses have their bits behind them.
std::string shown_name(const TraceSignal& signal) {
  return signal.bits > 1 ? fmt::format("{}[{}:0]", signal.name, signal.bits - 1) : signal.name;
}

std::string handshake(std::string_view stage, const char* end) {
  return fmt::format("TOP.wrinkle_core.{}_{}", stage, end);
}

}  // namespace

Waveform::Waveform(const Shape& config, const Model& model, ExpectedValues expected)
    : expected_(std::move(expected)), moves_(stage_moves(config)) {
  signals_.push_back({"bench.clock", kIntegerBits});
  const std::vector<Value> all = values(config);
  for (std::size_t stage = 0; stage < kStageNames.size(); ++stage) add_stage(stage, all, model);
}

void Waveform::add_stage(std::size_t stage, const std::vector<Value>& all, const Model& model) {
  const std::string name(kStageNames[stage]);
  StageSignals added{model.wire(name + "_valid"), model.wire(name + "_ready"), signals_.size(), {}};
  if (moves_[stage] == 0 || added.valid.data == nullptr || added.ready.data == nullptr) return;
  signals_.push_back({"bench." + name + ".fragment", kIntegerBits});
  signals_.push_back({"bench." + name + ".transfer", 1});
  signals_.push_back({"bench." + name + ".differs", 1});
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Wire wire = all[i].stage == name ? model.wire(all[i].wire) : Wire{};
    for (int element = 0; wire.data != nullptr && element < all[i].elements; ++element) {
      added.pairs.push_back({all[i], i, wire, element, signals_.size()});
      const std::string path = fmt::format("bench.{}.{}", name, element_name(all[i], element));
      signals_.push_back({path + "_golden"});
      signals_.push_back({path + "_rtl"});
    }
  }
  stages_[stage] = std::move(added);
}

void Waveform::sample(std::uint64_t clock, const PerStage<StageTap>& before) {
  signals_[0].integer = clock;
  for (std::size_t stage = 0; stage < stages_.size(); ++stage) {
    if (!stages_[stage]) continue;
    const StageSignals& shown = *stages_[stage];
    const auto moves = static_cast<std::uint64_t>(moves_[stage]);
    const std::uint64_t fragment = before[stage].transfers / moves;
    const bool transfer = *shown.valid.data != 0 && *shown.ready.data != 0;
    const bool differs = compare(shown, fragment, before[stage].transfers % moves) && transfer;
    signals_[shown.fragment].integer = fragment;
    signals_[shown.fragment + 1].integer = transfer;
    signals_[shown.fragment + 2].integer = differs;
    if (differs && !first_difference_[stage]) first_difference_[stage] = clock;
  }
}

// Takes both sides of every value of a stage; whether any of them differ. A fragment of which nothing is known has
// golden values that are no numbers.
bool Waveform::compare(const StageSignals& stage, std::uint64_t fragment, std::uint64_t slot) {
  const FragmentValues* golden = expected_.of(fragment);
  bool differs = false;
  for (const Pair& pair : stage.pairs) {
    const double step = std::ldexp(1.0, -pair.value.fraction_bits);
    const std::int64_t rtl = unpack(pair.value, pair.wire, pair.element);
    signals_[pair.signal + 1].number = step * static_cast<double>(rtl);
    signals_[pair.signal].number = std::numeric_limits<double>::quiet_NaN();
    if (golden == nullptr) continue;
    const auto element =
        slot * static_cast<std::uint64_t>(pair.value.elements) + static_cast<std::uint64_t>(pair.element);
    const std::int64_t wanted = (*golden)[pair.index][element];
    signals_[pair.signal].number = step * static_cast<double>(wanted);
    differs |= rtl != wanted;
  }
  return differs;
}

void Waveform::write_views(const std::filesystem::path& file, std::uint64_t first, std::uint64_t cursor) const {
  std::filesystem::path path = file;
  std::ofstream gtkwave(path.replace_extension(".gtkw")), surfer(path.replace_extension(".sucl"));
  const std::string dump = std::filesystem::absolute(file).string();
  // The marker is the number behind that of the zoom: in picoseconds, a thousand of which are a clock.
  gtkwave << fmt::format("[dumpfile] \"{}\"\n[timestart] {}\n[size] 1600 1000\n*-15.0 {}\n", dump, 1000 * first,
                         1000 * cursor)
          << "@24\n"
          << shown_name(signals_[0]) << '\n';
  surfer << fmt::format("load_file {}\nvariable_add bench.clock\n", dump);
  for (std::size_t stage = 0; stage < stages_.size(); ++stage) {
    if (!stages_[stage]) continue;
    const StageSignals& shown = *stages_[stage];
    const std::string_view name = kStageNames[stage];
    gtkwave << fmt::format("@800200\n-{}\n@28\n{}\n{}\n", name, handshake(name, "valid"), handshake(name, "ready"));
    surfer << fmt::format("divider_add {}\nvariable_add {}\nvariable_add {}\n", name, handshake(name, "valid"),
                          handshake(name, "ready"));
    for (std::size_t i = shown.fragment; i < shown.fragment + 3 + 2 * shown.pairs.size(); ++i) {
      gtkwave << fmt::format("@{}\n{}\n", signals_[i].bits > 1 ? 24 : 28, shown_name(signals_[i]));
      surfer << fmt::format("variable_add {}\n", signals_[i].name);
    }
    gtkwave << fmt::format("@1000200\n-{}\n", name);
  }
  surfer << fmt::format("cursor_set {}ns\ngoto_cursor\n", cursor);
}

}  // namespace wrinkle

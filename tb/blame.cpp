#include "tb/blame.h"

#include <algorithm>

#include "tb/testbench.h"

namespace wrinkle {
namespace {

constexpr std::uint64_t kTraceBefore = 200, kTraceAfter = 16;  // clocks
constexpr std::uint64_t kFragmentsBefore = 256, kFragmentsAfter = 512;
constexpr std::uint64_t kShownBefore = 12;  // clocks of the waveform left of the cursor

using Words = std::span<const std::uint64_t>;

// Words of the draw that holds a packet, its draw packet included.
Words words_of_draw(const PacketStream& stream, std::int64_t packet) {
  if (packet < 0 || stream.draw_word.empty()) return stream.words;
  const std::uint32_t word = stream.packet_word[static_cast<std::size_t>(packet)];
  const auto next = std::upper_bound(stream.draw_word.begin(), stream.draw_word.end(), word);
  if (next == stream.draw_word.begin()) return stream.words;
  const std::size_t begin = *(next - 1), end = next == stream.draw_word.end() ? stream.words.size() : *next;
  return Words(stream.words).subspan(begin, end - begin);
}

// All values of one fragment by the golden model, and how many fragments there are.
struct GoldenValues {
  FragmentValues values;
  std::uint64_t total = 0;
};
GoldenValues golden_values(const BenchRun& run, Words words, std::uint64_t fragment) {
  GoldenValues found;
  const auto look = [&](const auto& batch) {
    const auto count = static_cast<std::uint64_t>(batch.count);
    if (fragment >= found.total && fragment - found.total < count) {
      extract(batch, static_cast<int>(fragment - found.total), found.values);
    }
    found.total += count;
  };
  Golden(*run.config, *run.textures).draw(words, {look, look});
  return found;
}

BenchRun replay(const BenchRun& run, Words words, Model& model) {
  static const BenchSinks no_sinks;
  BenchRun again;
  again.config = run.config;
  again.words = words;
  again.textures = run.textures;
  again.options = run.options;
  again.sinks = &no_sinks;
  again.model = &model;
  return again;
}

// The first stage that handed on more than the fragments there are, each as often as the stage moves one; else the
// first that handed on fewer in a run that came to its end. (What multiplies fragments also holds up the stages before
// it.)
std::string stage_by_count(const BenchRun& run, std::uint64_t total) {
  const PerStage<int> moves = stage_moves(*run.config);
  std::string fewer;
  for (std::size_t stage = 0; stage < run.stages.size(); ++stage) {
    if (!run.stages[stage].visible) continue;
    const std::uint64_t expected = total * static_cast<std::uint64_t>(moves[stage]);
    if (run.stages[stage].transfers > expected) return std::string(kStageNames[stage]);
    if (run.idle && run.stages[stage].transfers < expected && fewer.empty()) fewer = std::string(kStageNames[stage]);
  }
  return fewer;
}

// Above the culprit of a hang every stage offers what is not taken; from it on nothing is offered.
std::string stage_by_hang(const BenchRun& run) {
  for (std::size_t stage = 0; stage < run.stages.size(); ++stage) {
    if (run.stages[stage].visible && !run.stages[stage].valid) return std::string(kStageNames[stage]);
  }
  return std::string(kStageNames.back());
}

void name(Difference& d, const Value& value, std::size_t element, std::int64_t golden, std::int64_t rtl) {
  d.stage = std::string(value.stage);
  d.value = std::string(value.name);
  d.element = static_cast<int>(element);
  d.width = value.width;
  d.fraction_bits = value.fraction_bits;
  d.golden = golden;
  d.rtl = rtl;
}

// The first value in pipeline order that differs among those of the stages `from` to `to`.
bool name_by_value(Difference& d, const BenchRun& run, const FragmentValues& golden, Stage from, Stage to) {
  const std::vector<Value> all = values(*run.config);
  const PerStage<int> moves = stage_moves(*run.config);
  const FragmentValues& rtl = run.first->rtl_values;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto stage =
        static_cast<std::size_t>(std::find(kStageNames.begin(), kStageNames.end(), all[i].stage) - kStageNames.begin());
    if (stage < static_cast<std::size_t>(from) || stage > static_cast<std::size_t>(to)) continue;
    if (!run.stages[stage].visible || !run.visible_values[i]) continue;
    for (std::size_t e = 0; e < static_cast<std::size_t>(moves[stage] * all[i].elements); ++e) {
      if (rtl[i][e] == golden[i][e]) continue;
      name(d, all[i], e, golden[i][e], rtl[i][e]);
      return true;
    }
  }
  return false;
}

// All stages agree: it went wrong on the way to the port.
void name_by_port(Difference& d, const BenchRun& run) {
  const Config& config = *run.config;
  const Fragment &g = *run.first->golden, &r = *run.first->rtl;
  const auto port = [&](const char* port_name, int width, int fraction, std::size_t element, std::int64_t golden,
                        std::int64_t rtl) {
    if (golden == rtl || !d.stage.empty()) return;
    name(d, {"output", port_name, 1, width, fraction, false, ValueKind::wire, "", 0}, element, golden, rtl);
  };
  port("x", config.screen_bits, 0, 0, g.x, r.x);
  port("y", config.screen_bits, 0, 0, g.y, r.y);
  port("z", config.depth_bits, config.depth_bits, 0, g.z, r.z);
  for (std::size_t c = 0; c < 3; ++c)
    port("colour", config.colour_bits, config.colour_bits, c, g.colour[c], r.colour[c]);
  port("last", 1, 0, 0, g.last, r.last);
  port("zero", 1, 0, 0, g.zero, r.zero);
}

// What the replayed run says of the difference. False when it shows none.
bool name_stage(Difference& d, const BenchRun& run) {
  if (!run.first) return false;
  const GoldenValues golden = golden_values(run, run.words, run.first->fragment);
  switch (run.first->kind) {
    case Difference::Kind::kHang:
      d.stage = stage_by_hang(run);
      return true;
    case Difference::Kind::kMissing:
    case Difference::Kind::kExtra:
      d.stage = stage_by_count(run, golden.total);
      return !d.stage.empty();
    case Difference::Kind::kRequest:
    case Difference::Kind::kHold:
    case Difference::Kind::kIdle:
      d.stage = std::string(run.first->stage);
      return true;
    case Difference::Kind::kValue:
      break;
  }
  // One too many or too few makes all that follows another fragment's; scan makes the fragments in the first place.
  d.stage = stage_by_count(run, golden.total);
  const bool counted = !d.stage.empty() && d.stage != kStageNames[static_cast<std::size_t>(Stage::scan)];
  if (counted || name_by_value(d, run, golden.values, Stage::scan, Stage::scan) || !d.stage.empty()) return true;
  if (!name_by_value(d, run, golden.values, Stage::interpolate, Stage{kStages - 1})) name_by_port(d, run);
  return true;
}

// Golden values of the fragments that can be in flight around the first one that differs.
ExpectedValues expected_around(const BenchRun& run, Words words, std::uint64_t fragment) {
  ExpectedValues expected;
  expected.first = fragment > kFragmentsBefore ? fragment - kFragmentsBefore : 0;
  std::uint64_t number = 0;
  const auto look = [&](const auto& batch) {
    for (int i = 0; i < batch.count; ++i, ++number) {
      if (number < expected.first || number > fragment + kFragmentsAfter) continue;
      extract(batch, i, expected.fragments.emplace_back());
    }
  };
  Golden(*run.config, *run.textures).draw(words, {look, look});
  return expected;
}

// The waveform's clock is that in which the stage handed on what differs; else `cycle`.
void write_trace(Difference& d, const BenchRun& run, Words words, const FirstDifference& first) {
  BenchOptions options = *run.options;
  options.model.trace = true;
  Model model(build_model(*run.config, options.model, options.progress), options.seed);
  Waveform waveform(*run.config, model, expected_around(run, words, first.fragment));
  BenchRun traced = replay(run, words, model);
  traced.options = &options;
  traced.tapped = true;
  traced.waveform = &waveform;
  traced.trace_from = first.cycle > kTraceBefore ? first.cycle - kTraceBefore : 0;
  traced.stop_after = first.cycle + kTraceAfter;
  simulate(traced);
  const auto stage = std::find(kStageNames.begin(), kStageNames.end(), d.stage) - kStageNames.begin();
  const auto differs = stage < kStages ? waveform.first_difference(static_cast<Stage>(stage)) : std::nullopt;
  d.trace = options.trace;
  d.trace_cycle = differs.value_or(first.cycle);
  waveform.write_views(d.trace, d.trace_cycle > kShownBefore ? d.trace_cycle - kShownBefore : 0, d.trace_cycle);
}

Difference locate(const BenchRun& run, const PacketStream& stream, std::string_view frame_name) {
  const FirstDifference& first = *run.first;
  Difference d;
  d.kind = first.kind;
  d.frame = std::string(frame_name);
  d.fragment = first.fragment;
  d.cycle = first.cycle;
  d.packet = first.packet;
  if (d.packet >= 0 && static_cast<std::size_t>(d.packet) < stream.packet_draw.size()) {
    d.draw = stream.packet_draw[static_cast<std::size_t>(d.packet)];
    d.triangle = stream.packet_triangle[static_cast<std::size_t>(d.packet)];
  }
  const std::optional<Fragment>& shown = first.golden ? first.golden : first.rtl;
  if (shown) {
    d.x = shown->x;
    d.y = shown->y;
  }
  return d;
}

}  // namespace

Difference blame(const BenchRun& run, const PacketStream& stream, std::string_view frame_name) {
  Difference d = locate(run, stream, frame_name);
  d.stage = std::string(run.first->stage);
  if (!run.options->blame || d.kind == Difference::Kind::kRequest) return d;
  const Words draw = words_of_draw(stream, d.packet);
  for (const Words words : {draw, Words(stream.words)}) {
    Model model(build_model(*run.config, run.options->model, run.options->progress), run.options->seed);
    BenchRun again = replay(run, words, model);
    again.tapped = true;
    simulate(again);
    if (!name_stage(d, again)) continue;
    if (!run.options->trace.empty()) write_trace(d, run, words, *again.first);
    break;
  }
  return d;
}

}  // namespace wrinkle

#include "tb/core.h"

#include <tlm_utils/tlm_quantumkeeper.h>

#include <algorithm>
#include <array>
#include <utility>

#include "tb/idle_watch.h"
#include "tb/tap_recorder.h"

namespace wrinkle {
namespace {

const sc_core::sc_time kPeriod(10, sc_core::SC_NS);

// Clocks after the core says it is idle in which nothing may leave it any more.
constexpr int kDrain = 64;

Fragment read_fragment(const Pins& pins, int colour_bits, int channels) {
  Fragment f;
  f.x = static_cast<std::int32_t>(pins.fragment_x);
  f.y = static_cast<std::int32_t>(pins.fragment_y);
  f.z = static_cast<std::uint32_t>(pins.fragment_z);
  const std::uint64_t mask = (std::uint64_t{1} << colour_bits) - 1;
  for (int c = 0; c < channels; ++c) {
    f.colour[static_cast<std::size_t>(c)] =
        static_cast<std::uint16_t>((pins.fragment_colour >> (c * colour_bits)) & mask);
  }
  f.last = pins.fragment_last != 0;
  f.zero = pins.fragment_zero != 0;
  return f;
}

PerStream<StallSource> stall_sources(const BenchOptions& options) {
  return [&]<std::size_t... stream>(std::index_sequence<stream...>) {
    return PerStream<StallSource>{StallSource(options.stalls, options.seed * 8 + 1 + stream)...};
  }
  (std::make_index_sequence<kStreamStages.size()>());
}

void set_words(std::uint64_t& pin, const std::uint64_t* words, std::size_t) { pin = *words; }
template <std::size_t n>
void set_words(std::array<std::uint64_t, n>& pin, const std::uint64_t* words, std::size_t count) {
  for (std::size_t k = 0; k < n && k < count; ++k) pin[k] = words[k];
}

// Drives the pins of one run, clock by clock. Of an input stream NAME it asks NAME_waits(), whether there is something
// to offer, offer_NAME(), and tells NAME_taken(); of an output stream it tells NAME_taken() before the clock edge.
class Clockwork {
 public:
  Clockwork(BenchRun& run, BlockReader<WordBlock>& words, QuadFetch& quads)
      : run_(run),
        model_(*run.model),
        words_(words),
        quads_(quads),
        taps_(values(*run.config), stage_moves(*run.config), run.model->wires()),
        idle_(*run.config),
        stalls_(stall_sources(*run.options)),
        colour_bits_(run.config->colour_bits),
        channels_(Shape(*run.config).count) {
    if (run.tapped) run.visible_values = taps_.visible_values();
  }

  ~Clockwork() {
    if (tracing_) model_.trace_close();
  }

  void reset() {
    pins_.rst = 1;
    model_.clock(pins_);
    model_.clock(pins_);
    pins_.rst = 0;
    pins_.are_new = true;
  }

  // Runs up to `clocks` clocks; the fragments that left go into `out`. False when the run is over.
  bool advance(int clocks, FragmentBlock& out) {
    out.first_cycle = cycle_;
    out_ = &out;
    if (run_.surplus) {
      run_.cycles = cycle_;
      return false;
    }
    for (int i = 0; i < clocks; ++i) {
      if (finished()) return false;
      clock();
    }
    return true;
  }

 private:
  bool finished() {
    if (run_.stop_after != 0 && cycle_ >= run_.stop_after) return run_.stopped = true;
    if (cycle_ - last_transfer_ > run_.options->watchdog) {
      run_.differ(here(Difference::Kind::kHang));
      run_.cycles = cycle_;
      return true;
    }
    if (pins_.idle == 0) {
      drained_ = 0;
      return false;
    }
    const bool quiet = pins_.packet_valid == 0 && quads_.empty() && pins_.fragment_valid == 0 &&
                       word_ == block_.size() && !next_words();
    if (!quiet) {
      drained_ = 0;
      return false;
    }
    if (drained_ == 0) run_.cycles = cycle_;
    return run_.idle = ++drained_ > kDrain;
  }

  bool next_words() {
    while (!out_of_words_ && word_ == block_.size()) {
      word_ = 0;
      block_ = {};
      out_of_words_ = !words_.get(block_);
    }
    return !out_of_words_;
  }

  bool stalled(Stream stream) { return stalls_[static_cast<std::size_t>(stream)].stalled(); }

  bool packet_waits() { return word_ < block_.size() || next_words(); }
  void offer_packet() { pins_.packet_word = block_[word_]; }
  void packet_taken() { ++word_; }

  void texel_request_taken() {
    if (!quads_.request(pins_.texel_request_a, pins_.texel_request_b, cycle_) && !run_.bad_request)
      run_.bad_request = here(Difference::Kind::kRequest, Stream::texel_request);
  }

  bool texel_response_waits() { return quads_.is_due(cycle_); }
  void offer_texel_response() { quads_.texel_words() == 1 ? offer_texels<1>() : offer_texels<kAnyNumber>(); }
  void texel_response_taken() { quads_.pop(); }
  // `known`: words of a texel, to be looped over without a count where it is one.
  template <std::size_t known>
  void offer_texels() {
    const std::size_t words = known != kAnyNumber ? known : quads_.texel_words();
    const std::uint64_t* texel = quads_.texels();
#define WRINKLE_INPUT_FIELD(stream, name, most, width)      \
  if constexpr (Stream::stream == Stream::texel_response) { \
    set_words(pins_.name, texel, words);                    \
    texel += words;                                         \
  }
#include "golden/streams.def"
  }

  void fragment_taken() {
    const Fragment f = read_fragment(pins_, colour_bits_, channels_);
    run_.zero_vectors += f.zero;
    out_->fragments.push_back(f);
    out_->clocks.push_back(static_cast<std::uint32_t>(cycle_ - out_->first_cycle));
    if (run_.tapped) out_->values.push_back(taps_.take());
    ++run_.fragments;
  }

  // The inputs of this clock. A stream once valid stays so until it is taken.
  void drive() {
#define WRINKLE_INPUT(stream, stage)                                               \
  if (pins_.stream##_valid == 0 && stream##_waits() && !stalled(Stream::stream)) { \
    pins_.stream##_valid = 1;                                                      \
    offer_##stream();                                                              \
    pins_.are_new = true;                                                          \
  }
#define WRINKLE_OUTPUT(stream, stage)                                                       \
  if (const std::uint8_t ready = !stalled(Stream::stream); ready != pins_.stream##_ready) { \
    pins_.stream##_ready = ready;                                                           \
    pins_.are_new = true;                                                                   \
  }
#include "golden/streams.def"
  }

  void clock() {
    drive();
    if (run_.tapped) sample();
    bool held = false;
#define WRINKLE_INPUT(stream, stage)                                       \
  const bool take_##stream = pins_.stream##_valid && pins_.stream##_ready; \
  if (take_##stream) last_transfer_ = cycle_;
#define WRINKLE_OUTPUT(stream, stage)                 \
  if (pins_.stream##_valid && pins_.stream##_ready) { \
    last_transfer_ = cycle_;                          \
    stream##_taken();                                 \
  }                                                   \
  held |= pins_.stream##_valid && !pins_.stream##_ready;
#include "golden/streams.def"
    const bool moving = pins_.texel_request_valid || !quads_.empty() || pins_.fragment_valid;
    if (!idle_.good(pins_.idle != 0, moving, take_packet, pins_.packet_word))
      run_.differ(here(Difference::Kind::kIdle));

    if (cycle_ == run_.trace_from) {
      model_.trace_open(run_.options->trace, cycle_, run_.waveform->signals());
      tracing_ = true;
    }
    if (held) {
      const OutputPins before = pins_;
      model_.clock(pins_);
      check_hold(before);
    } else {
      model_.clock(pins_);
    }
    ++cycle_;
#define WRINKLE_INPUT(stream, stage) \
  if (take_##stream) {               \
    stream##_taken();                \
    pins_.stream##_valid = 0;        \
    pins_.are_new = true;            \
  }
#include "golden/streams.def"
  }

  void sample() {
    model_.settle(pins_);
    if (run_.waveform != nullptr) run_.waveform->sample(cycle_, taps_.stages());
    taps_.sample();
    run_.stages = taps_.stages();
  }

  // What was offered and not taken before the clock edge is offered after it, unchanged.
  void check_hold(const OutputPins& before) {
    PerStream<bool> waits{}, changed{};
    const auto at = [](Stream stream) { return static_cast<std::size_t>(stream); };
#define WRINKLE_OUTPUT(stream, stage)                                                  \
  waits[at(Stream::stream)] = before.stream##_valid != 0 && pins_.stream##_ready == 0; \
  changed[at(Stream::stream)] = pins_.stream##_valid == 0;
#define WRINKLE_OUTPUT_FIELD(stream, name, most, width) \
  if (pins_.name != before.name) changed[at(Stream::stream)] = true;
#include "golden/streams.def"
    for (std::size_t stream = 0; stream < waits.size(); ++stream) {
      if (waits[stream] && changed[stream]) run_.differ(here(Difference::Kind::kHold, static_cast<Stream>(stream)));
    }
  }

  FirstDifference here(Difference::Kind kind) const {
    FirstDifference d;
    d.kind = kind;
    d.fragment = run_.fragments;
    d.cycle = cycle_;
    return d;
  }
  FirstDifference here(Difference::Kind kind, Stream stream) const {
    FirstDifference d = here(kind);
    d.stage = kStreamStages[static_cast<std::size_t>(stream)];
    return d;
  }

  BenchRun& run_;
  Model& model_;
  BlockReader<WordBlock>& words_;
  QuadFetch& quads_;
  TapRecorder taps_;
  IdleWatch idle_;
  PerStream<StallSource> stalls_;
  int colour_bits_, channels_;
  Pins pins_;
  FragmentBlock* out_ = nullptr;  // of the current quantum
  WordBlock block_;
  std::size_t word_ = 0;
  bool out_of_words_ = false, tracing_ = false;
  std::uint64_t cycle_ = 0, last_transfer_ = 0;
  int drained_ = 0;
};

}  // namespace

Core::Core(const sc_core::sc_module_name& name, sc_core::sc_event& start) : sc_module(name), start_(start) {
  SC_HAS_PROCESS(Core);
  SC_THREAD(thread);
  set_stack_size(1 << 20);
}

void Core::thread() {
  for (;;) {
    wait(start_);
    try {
      draw();
    } catch (...) {
      run_->error = std::current_exception();
    }
    words->cancel();
    fragments->close();
  }
}

void Core::draw() {
  quads->start(*run_);
  Clockwork clockwork(*run_, *words.operator->(), *quads.operator->());
  clockwork.reset();
  const int quantum = run_->options->quantum;
  tlm_utils::tlm_quantumkeeper keeper;
  keeper.set_global_quantum(quantum * kPeriod);
  keeper.reset();
  for (bool more = true; more;) {
    FragmentBlock block;
    block.fragments.reserve(static_cast<std::size_t>(quantum));
    block.clocks.reserve(static_cast<std::size_t>(quantum));
    more = clockwork.advance(quantum, block);
    if (!block.fragments.empty() && !fragments->put(std::move(block))) return;
    keeper.inc(quantum * kPeriod);
    if (more) keeper.sync();
  }
}

}  // namespace wrinkle

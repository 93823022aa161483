#include "tb/core.h"

#include <tlm_utils/tlm_quantumkeeper.h>

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
  f.z = pins.fragment_z;
  const std::uint64_t mask = (std::uint64_t{1} << colour_bits) - 1;
  for (int c = 0; c < channels; ++c) {
    f.colour[static_cast<std::size_t>(c)] =
        static_cast<std::uint16_t>((pins.fragment_colour >> (c * colour_bits)) & mask);
  }
  f.last = pins.fragment_last != 0;
  f.zero = pins.fragment_zero != 0;
  return f;
}

// Drives the pins of one run, clock by clock.
class Clockwork {
 public:
  Clockwork(Run& run, BlockReader<WordBlock>& words, QuadFetch& quads)
      : run_(run),
        model_(*run.model),
        words_(words),
        quads_(quads),
        taps_(*run.config),
        idle_(*run.config),
        packet_stall_(run.options->stalls, run.options->seed * 8 + 1),
        request_stall_(run.options->stalls, run.options->seed * 8 + 2),
        response_stall_(run.options->stalls, run.options->seed * 8 + 3),
        fragment_stall_(run.options->stalls, run.options->seed * 8 + 4),
        colour_bits_(run.config->colour_bits),
        channels_(run.config->channel_count()) {}

  ~Clockwork() {
    if (tracing_) model_.trace_close();
  }

  void reset() {
    pins_.rst = 1;
    model_.clock(pins_);
    model_.clock(pins_);
    pins_.rst = 0;
  }

  // Runs up to `clocks` clocks; the fragments that left go into `out`. False when the run is over.
  bool advance(int clocks, FragmentBlock& out) {
    out.first_cycle = cycle_;
    for (int i = 0; i < clocks; ++i) {
      if (finished()) return false;
      clock(out);
    }
    return true;
  }

 private:
  bool finished() {
    if (run_.surplus) {
      run_.cycles = cycle_;
      return true;
    }
    if (run_.stop_after != 0 && cycle_ >= run_.stop_after) return run_.stopped = true;
    if (cycle_ - last_transfer_ > run_.options->watchdog) {
      run_.differ(here(Difference::Kind::kHang));
      run_.cycles = cycle_;
      return true;
    }
    const bool quiet = pins_.idle != 0 && pins_.packet_valid == 0 && quads_.empty() && pins_.fragment_valid == 0 &&
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

  // The inputs of this clock. A stream once valid stays so until it is taken.
  void drive() {
    if (pins_.packet_valid == 0 && (word_ < block_.size() || next_words()) && !packet_stall_.stalled()) {
      pins_.packet_valid = 1;
      pins_.packet_word = block_[word_];
    }
    if (pins_.texel_response_valid == 0) {
      const QuadFetch::Response* response = quads_.response(cycle_);
      if (response != nullptr && !response_stall_.stalled()) {
        pins_.texel_response_valid = 1;
        std::copy(response->a.begin(), response->a.end(), pins_.texel_response_a);
        std::copy(response->b.begin(), response->b.end(), pins_.texel_response_b);
      }
    }
    pins_.texel_request_ready = !request_stall_.stalled();
    pins_.fragment_ready = !fragment_stall_.stalled();
  }

  void clock(FragmentBlock& out) {
    drive();
    if (run_.tapped) sample();
    const bool packet_taken = pins_.packet_valid && pins_.packet_ready;
    const bool request_taken = pins_.texel_request_valid && pins_.texel_request_ready;
    const bool response_taken = pins_.texel_response_valid && pins_.texel_response_ready;
    const bool fragment_taken = pins_.fragment_valid && pins_.fragment_ready;
    if (request_taken && !quads_.request(pins_.texel_request_a, pins_.texel_request_b, cycle_) && !run_.bad_request) {
      run_.bad_request = here(Difference::Kind::kRequest, "texture");
    }
    const bool moving = pins_.texel_request_valid || !quads_.empty() || pins_.fragment_valid;
    if (!idle_.good(pins_.idle != 0, moving, packet_taken, pins_.packet_word))
      run_.differ(here(Difference::Kind::kIdle));
    if (fragment_taken) emit(out);
    if (packet_taken || request_taken || response_taken || fragment_taken) last_transfer_ = cycle_;

    if (cycle_ == run_.trace_from) {
      model_.trace_open(run_.options->trace);
      tracing_ = true;
    }
    const bool held = (pins_.texel_request_valid && !request_taken) || (pins_.fragment_valid && !fragment_taken);
    if (held) {
      const Pins before = pins_;
      model_.clock(pins_);
      check_hold(before);
    } else {
      model_.clock(pins_);
    }
    ++cycle_;
    if (packet_taken) {
      ++word_;
      pins_.packet_valid = 0;
    }
    if (response_taken) {
      quads_.pop();
      pins_.texel_response_valid = 0;
    }
  }

  void emit(FragmentBlock& out) {
    const Fragment f = read_fragment(pins_, colour_bits_, channels_);
    run_.zero_vectors += f.zero;
    out.fragments.push_back(f);
    out.clocks.push_back(static_cast<std::uint32_t>(cycle_ - out.first_cycle));
    if (run_.tapped) out.values.push_back(taps_.take());
    ++run_.fragments;
  }

  void sample() {
    model_.settle(pins_);
    model_.taps(run_.last_taps);
    taps_.sample(run_.last_taps, run_.stage_transfers);
  }

  void check_hold(const Pins& before) {
    const bool request_held = !before.texel_request_valid || before.texel_request_ready ||
                              (pins_.texel_request_valid && pins_.texel_request_a == before.texel_request_a &&
                               pins_.texel_request_b == before.texel_request_b);
    const bool fragment_held =
        !before.fragment_valid || before.fragment_ready ||
        (pins_.fragment_valid && pins_.fragment_x == before.fragment_x && pins_.fragment_y == before.fragment_y &&
         pins_.fragment_z == before.fragment_z && pins_.fragment_colour == before.fragment_colour &&
         pins_.fragment_last == before.fragment_last && pins_.fragment_zero == before.fragment_zero);
    if (!request_held || !fragment_held)
      run_.differ(here(Difference::Kind::kHold, request_held ? "output" : "texture"));
  }

  FirstDifference here(Difference::Kind kind, const char* stage = "") const {
    FirstDifference d;
    d.kind = kind;
    d.fragment = run_.fragments;
    d.cycle = cycle_;
    d.stage = stage;
    return d;
  }

  Run& run_;
  Model& model_;
  BlockReader<WordBlock>& words_;
  QuadFetch& quads_;
  TapRecorder taps_;
  IdleWatch idle_;
  StallSource packet_stall_, request_stall_, response_stall_, fragment_stall_;
  int colour_bits_, channels_;
  Pins pins_;
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

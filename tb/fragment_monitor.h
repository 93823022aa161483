// Watches the fragments leave the core: hands them to whoever draws with them, and on to the scoreboard.
#pragma once

#include <systemc>

#include "tb/block_channel.h"
#include "tb/run.h"

namespace wrinkle {

class FragmentMonitor : public sc_core::sc_module {
 public:
  sc_core::sc_port<BlockReader<FragmentBlock>> fragments;
  sc_core::sc_port<BlockWriter<FragmentBlock>> checked;

  FragmentMonitor(const sc_core::sc_module_name& name, sc_core::sc_event& start) : sc_module(name), start_(start) {
    SC_HAS_PROCESS(FragmentMonitor);
    SC_THREAD(thread);
    set_stack_size(1 << 20);
  }

  void start(BenchRun& run) { run_ = &run; }

 private:
  void thread() {
    for (;;) {
      wait(start_);
      try {
        for (FragmentBlock block; fragments->get(block);) pass(std::move(block));
      } catch (...) {
        run_->error = std::current_exception();
        fragments->cancel();
      }
      checked->close();
    }
  }

  void pass(FragmentBlock&& block) {
    const BenchSinks& sinks = *run_->sinks;
    if (sinks.fragments) sinks.fragments(block.fragments);
    if (sinks.values) {
      for (std::size_t i = 0; i < block.values.size(); ++i) sinks.values(block.fragments[i], block.values[i]);
    }
    if (run_->options->compare) checked->put(std::move(block));
  }

  sc_core::sc_event& start_;
  BenchRun* run_ = nullptr;
};

}  // namespace wrinkle

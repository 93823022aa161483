// Feeds the words of a run to the core in blocks.
#pragma once

#include <systemc>

#include "tb/block_channel.h"
#include "tb/core.h"

namespace wrinkle {

class PacketDriver : public sc_core::sc_module {
 public:
  sc_core::sc_port<BlockWriter<WordBlock>> words;

  PacketDriver(const sc_core::sc_module_name& name, sc_core::sc_event& start) : sc_module(name), start_(start) {
    SC_HAS_PROCESS(PacketDriver);
    SC_THREAD(thread);
  }

  void start(const BenchRun& run) { run_ = &run; }

 private:
  static constexpr std::size_t kBlock = 4096;

  void thread() {
    for (;;) {
      wait(start_);
      for (WordBlock rest = run_->words; !rest.empty();) {
        const std::size_t size = std::min(kBlock, rest.size());
        if (!words->put(rest.first(size))) break;
        rest = rest.subspan(size);
      }
      words->close();
    }
  }

  sc_core::sc_event& start_;
  const BenchRun* run_ = nullptr;
};

}  // namespace wrinkle

// The Verilated core as a SystemC module: loosely timed, it runs a quantum of clocks between two waits.
#pragma once

#include <span>
#include <systemc>

#include "tb/block_channel.h"
#include "tb/quad_fetch.h"
#include "tb/run.h"

namespace wrinkle {

using WordBlock = std::span<const std::uint64_t>;

class Core : public sc_core::sc_module {
 public:
  sc_core::sc_port<BlockReader<WordBlock>> words;
  sc_core::sc_port<BlockWriter<FragmentBlock>> fragments;
  sc_core::sc_port<QuadFetch> quads;

  Core(const sc_core::sc_module_name& name, sc_core::sc_event& start);

  void start(BenchRun& run) { run_ = &run; }

 private:
  void thread();
  void draw();

  sc_core::sc_event& start_;
  BenchRun* run_ = nullptr;
};

}  // namespace wrinkle

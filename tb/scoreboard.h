// Holds every fragment of the RTL against the golden model, which runs beside it a few batches ahead.
#pragma once

#include <systemc>

#include "tb/block_channel.h"
#include "tb/run.h"

namespace wrinkle {

// The golden model as a source of fragments. A thread of its own: it waits when the scoreboard has enough, so that the
// memory is bounded however much a packet draws.
class GoldenSource : public sc_core::sc_module {
 public:
  sc_core::sc_port<BlockWriter<GoldenBlock>> fragments;

  GoldenSource(const sc_core::sc_module_name& name, sc_core::sc_event& start);
  void start(BenchRun& run) { run_ = &run; }

 private:
  void thread();
  void draw();

  sc_core::sc_event& start_;
  BenchRun* run_ = nullptr;
};

class Scoreboard : public sc_core::sc_module {
 public:
  sc_core::sc_port<BlockReader<FragmentBlock>> rtl;
  sc_core::sc_port<BlockReader<GoldenBlock>> golden;

  Scoreboard(const sc_core::sc_module_name& name, sc_core::sc_event& start);
  void start(BenchRun& run) { run_ = &run; }

 private:
  void thread();
  void compare(FragmentBlock& block);
  void differ(FragmentBlock& block, std::size_t index);
  void finish();
  bool next_golden();
  std::uint64_t golden_left();

  sc_core::sc_event& start_;
  BenchRun* run_ = nullptr;
  GoldenBlock expected_;
  std::size_t next_ = 0;  // of expected_
  std::uint64_t compared_ = 0;
};

}  // namespace wrinkle

#include "tb/testbench.h"

#include <systemc>

#include "tb/core.h"
#include "tb/fragment_monitor.h"
#include "tb/packet_driver.h"
#include "tb/quad_fetch.h"
#include "tb/scoreboard.h"
#include "tb/texture_memory.h"

// libsystemc refers to it. The bench is a library: simulation starts from run_bench(), not from SystemC's own main().
int sc_main(int, char**) { return 0; }

namespace wrinkle {
namespace {

class Testbench : public sc_core::sc_module {
 public:
  explicit Testbench(const sc_core::sc_module_name& name) : sc_module(name) {
    driver_.words(words_);
    core_.words(words_);
    core_.fragments(fragments_);
    core_.quads(fetch_);
    fetch_.socket.bind(memory_.socket);
    monitor_.fragments(fragments_);
    monitor_.checked(checked_);
    golden_.fragments(expected_);
    scoreboard_.rtl(checked_);
    scoreboard_.golden(expected_);
  }

  void simulate(BenchRun& run) {
    memory_.load(*run.textures, run.options->dmi);
    words_.open();
    fragments_.open();
    checked_.open();
    expected_.open();
    driver_.start(run);
    core_.start(run);
    monitor_.start(run);
    golden_.start(run);
    scoreboard_.start(run);
    start_.notify(sc_core::SC_ZERO_TIME);
    sc_core::sc_start();  // returns when every thread waits for the next run
    if (run.error) std::rethrow_exception(run.error);
  }

 private:
  sc_core::sc_event start_;
  BlockChannel<WordBlock> words_{"words", 4};
  BlockChannel<FragmentBlock> fragments_{"fragments", 4}, checked_{"checked", 4};
  BlockChannel<GoldenBlock> expected_{"expected", 4};
  PacketDriver driver_{"driver", start_};
  Core core_{"core", start_};
  TextureMemory memory_{"memory"};
  QuadFetch fetch_{"fetch", memory_.directory()};
  FragmentMonitor monitor_{"monitor", start_};
  GoldenSource golden_{"golden", start_};
  Scoreboard scoreboard_{"scoreboard", start_};
};

// Never destroyed: at exit SystemC's kernel goes first, and modules must not outlive it.
Testbench& testbench() {
  static Testbench* const bench = [] {
    auto* modules = new Testbench("bench");
    sc_core::sc_start(sc_core::SC_ZERO_TIME);  // elaborates, and brings every thread to its first wait
    return modules;
  }();
  return *bench;
}

}  // namespace

void simulate(BenchRun& run) { testbench().simulate(run); }

}  // namespace wrinkle

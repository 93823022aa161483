#include "sim/synthesis/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <random>

#include "sim/synthesis/faults.h"
#include "sim/synthesis/stimulus.h"
#include "sim/synthesis/testbench.h"
#include "tb/process.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

constexpr int kClocks = 1000, kLeastRuns = 20, kFewRuns = 8, kMostRuns = 100;
// So many bytes of results of runs that are compared together, each with a bit of the words of a GateSimulation.
constexpr std::size_t kMostBytes = 200'000'000;
constexpr std::size_t kMachines = 64;
constexpr std::uint64_t kAll = ~std::uint64_t{0};
// From one state to the next, in every other run: long enough for buffers to fill, and short, for as many states.
constexpr int kLong = 40, kShort = 5;
// After so many clocks nothing is left of the state at the start.
constexpr int kForgotten = 256;
// With registers as wires, a word stays until the deepest pipeline shows it, and only then is compared.
constexpr int kStay = 8;

// What went in and what came out of the Verilog, a line for each clock, and the flip-flops of the netlist at the start
// of each episode.
struct Run {
  std::uint64_t seed;
  int episode;
  std::vector<std::vector<bool>> states;
  std::vector<std::string> inputs, results;
};

// The values that a bit took, of a register those that a clock changed it to.
struct Seen {
  bool low = false, high = false;
  void add(std::uint64_t lows, std::uint64_t highs) {
    low = low || lows != 0;
    high = high || highs != 0;
  }
};

// A flip-flop of the netlist by which a net is driven, at once or through inverters.
struct Source {
  std::size_t flip_flop;
  bool inverted;
};

class Check {
 public:
  explicit Check(const CheckOptions& options)
      : options_(options),
        netlist_(read_gates(options.gates)),
        ports_(options.registers ? netlist_.ports : joined(netlist_.ports)),
        bench_{Bundle(ports_, true), Bundle(ports_, false)} {
    bench_.has_clock = std::any_of(ports_.begin(), ports_.end(), [](const NetlistPort& p) { return p.name == "clk"; });
    if (bench_.has_clock)
      bench_.registers = elaborated_registers(options.top, options.parameters, options.sources, options.include_folders,
                                              options.folder);
    bench_.clocks = kClocks * stay();
    find_sources();
    find_registers();
    find_flip_flops();
    bench_.shortest_episode = episode(0);
    find_constants();
    if (bench_.outputs.nets.empty()) throw SynthesisError(options.top + " has no output");
  }

  NetlistChecked run() {
    build();
    const int together = runs_together();
    for (int number = 1; number <= least_runs() || (number <= kMostRuns && !all_changed()); number += together) {
      std::vector<Run> runs;
      for (int i = 0; i < together; ++i) runs.push_back(simulate_verilog(static_cast<std::uint64_t>(number + i)));
      compare(runs);
      checked_.clocks += together * bench_.clocks;
      count_changes();
      if (options_.faults > 0) std::move(runs.begin(), runs.end(), std::back_inserter(runs_));
    }
    // What no input makes a register change to, only another state shows.
    if (!all_changed() && (starts_alike_ || checked_.outputs_changed != checked_.outputs))
      throw SynthesisError(fmt::format("{} of {} never changed in {} clocks, so that little is known of its netlist",
                                       first_unchanged(), options_.top, checked_.clocks));
    find_faults();
    return checked_;
  }

 private:
  void find_sources() {
    sources_.resize(netlist_.nets);
    for (std::size_t i = 0; i < netlist_.flip_flops.size(); ++i) sources_[netlist_.flip_flops[i].q] = Source{i, false};
    for (const Gate& gate : netlist_.gates) {
      if (!gate.is_buffer() || !sources_[gate.a]) continue;
      sources_[gate.y] = Source{sources_[gate.a]->flip_flop, sources_[gate.a]->inverted != gate.is_inverter()};
    }
  }

  // Which flip-flops have a name, and whether both sides can start alike.
  void find_flip_flops() {
    std::vector<bool> has_name(netlist_.flip_flops.size());
    for (std::size_t i = 0; i < register_nets_.size(); ++i) {
      if (const auto source = source_of(i)) has_name[source->flip_flop] = true;
    }
    starts_alike_ = options_.keeps_registers || std::count(has_name.begin(), has_name.end(), false) == 0;
    for (std::size_t i = 0; i < has_name.size(); ++i) {
      if (starts_alike_ || has_name[i]) counted_.push_back(i);
    }
    register_was_.resize(counted_.size());
  }

  // Outputs that the netlist only wires to a constant have no other value to take.
  void find_constants() {
    std::vector<bool> is_constant(netlist_.nets);
    is_constant[0] = true;
    for (const Gate& gate : netlist_.gates) is_constant[gate.y] = gate.is_buffer() && is_constant[gate.a];
    for (const std::uint32_t net : bench_.outputs.nets) output_was_.push_back({is_constant[net], is_constant[net]});
  }

  // The net of every bit of the registers, where the netlist has one.
  void find_registers() {
    for (const Register& word : bench_.registers) {
      for (std::size_t bit = 0; bit < word.bits; ++bit) {
        const auto net = netlist_.names.find(word.bits == 1 ? word.name : fmt::format("{}[{}]", word.name, bit));
        register_nets_.push_back(net == netlist_.names.end() ? std::nullopt : std::optional(net->second));
      }
    }
  }

  void tool(const Arguments& command) const {
    const fs::path log = options_.folder / (command[0] + ".log");
    const int code = Process(command, log).wait();
    if (code != 0) throw SynthesisError(fmt::format("{} ended with code {}:\n{}", command[0], code, read_text(log)));
  }

  void build() const {
    std::ofstream(options_.folder / "check.v") << testbench_text(bench_, options_);
    Arguments command{"iverilog", "-g2005", "-gno-specify", "-s", "wrinkle_check", "-o", options_.folder / "check.vvp"};
    for (const fs::path& folder : options_.include_folders) command.push_back("-I" + folder.string());
    command.push_back(options_.folder / "check.v");
    for (const fs::path& source : options_.sources) command.push_back(source);
    tool(command);
  }

  Run simulate_verilog(std::uint64_t seed) const {
    Run run{seed, episode(seed), {}, stimulus(ports_, {seed, bench_.clocks, stay(), draw(seed)}), {}};
    draw_states(run);
    std::ofstream inputs(options_.folder / "inputs");
    for (const std::string& line : run.inputs) inputs << (line.empty() ? "0" : line) << '\n';
    inputs.close();
    tool({"vvp", "-n", options_.folder / "check.vvp", fmt::format("+episode={}", run.episode)});
    std::ifstream results(options_.folder / "results");
    for (std::string line; std::getline(results, line);) run.results.push_back(line);
    if (run.results.size() != run.inputs.size()) throw SynthesisError(options_.top + ": the simulation stopped early");
    return run;
  }

  // Words for all registers at the start of each episode, which the flip-flops of the netlist take, and then what the
  // netlist has where they stand.
  void draw_states(Run& run) const {
    std::mt19937_64 random(run.seed);
    std::vector<std::string> words;
    for (const Register& word : bench_.registers) words.emplace_back(word.bits, '0');
    std::vector<std::vector<std::string>> all_words;
    std::vector<const std::string*> inputs;
    for (int clock = 0; clock < bench_.clocks; clock += run.episode) {
      for (std::string& word : words) draw_word(word, random);
      std::vector<bool> state(netlist_.flip_flops.size());
      for (std::size_t i = 0; i < state.size(); ++i) state[i] = random() % 2 != 0;
      for_each_bit(words, [&](std::size_t bit, char& value) {
        if (const auto source = source_of(bit); source && starts_alike_)
          state[source->flip_flop] = (value == '1') != source->inverted;
      });
      all_words.push_back(words);
      inputs.push_back(&run.inputs[static_cast<std::size_t>(clock)]);
      run.states.push_back(std::move(state));
    }
    for (std::size_t first = 0; first < all_words.size(); first += kMachines)
      settle_words(run, inputs, first, all_words);
    std::ofstream file(options_.folder / "state");
    for (const auto& state : all_words) {
      for (const std::string& word : state) file << word << '\n';
    }
    if (words.empty()) file << "0\n";
  }

  // Of as many states as there are machines, the bits of registers as the netlist has them.
  void settle_words(const Run& run, const std::vector<const std::string*>& inputs, std::size_t first,
                    std::vector<std::vector<std::string>>& words) const {
    const std::size_t last = std::min(first + kMachines, words.size());
    GateSimulation simulation(netlist_);
    for (std::size_t i = first; i < last; ++i) simulation.set_state(run.states[i], std::uint64_t{1} << (i - first));
    drive(simulation,
          {inputs.begin() + static_cast<std::ptrdiff_t>(first), inputs.begin() + static_cast<std::ptrdiff_t>(last)});
    for (std::size_t i = first; i < last; ++i) {
      for_each_bit(words[i], [&](std::size_t bit, char& value) {
        if (register_nets_[bit] && starts_alike_)
          value = (simulation.value(*register_nets_[bit]) >> (i - first) & 1) != 0 ? '1' : '0';
      });
    }
  }

  // Calls with the number of each bit of all registers, bit 0 of the first one first, and its place in `words`.
  template <typename Function>
  static void for_each_bit(std::vector<std::string>& words, Function call) {
    std::size_t number = 0;
    for (std::string& word : words) {
      for (std::size_t i = word.size(); i-- > 0;) call(number++, word[i]);
    }
  }

  std::optional<Source> source_of(std::size_t register_bit) const {
    return register_nets_[register_bit] ? sources_[*register_nets_[register_bit]] : std::nullopt;
  }

  // Machine i gets inputs[i].
  void drive(GateSimulation& simulation, const std::vector<const std::string*>& inputs) const {
    for (std::size_t bit = 0; bit < bench_.inputs.nets.size(); ++bit) {
      std::uint64_t value = 0;
      for (std::size_t i = 0; i < inputs.size(); ++i)
        value |= std::uint64_t{(*inputs[i])[inputs[i]->size() - 1 - bit] == '1'} << i;
      simulation.set(bench_.inputs.nets[bit], value);
    }
    simulation.settle();
  }

  int episode(std::uint64_t run) const { return starts_alike_ ? draw(run) : bench_.clocks; }
  int draw(std::uint64_t run) const { return stay() * (run % 2 != 0 ? kLong : kShort); }
  int stay() const { return options_.registers ? 1 : kStay; }
  bool is_compared(std::size_t clock) const {
    const int time = static_cast<int>(clock);
    return time % stay() == stay() - 1 && (starts_alike_ || time >= kForgotten);
  }

  // The check is not to take longer than the synthesis: cells of an FPGA are made in less time, and registers that are
  // wires make a run longer.
  int least_runs() const { return options_.keeps_registers && options_.registers ? kLeastRuns : kFewRuns; }
  int runs_together() const {
    const std::size_t line = bench_.outputs.nets.size() + register_nets_.size() + 1;
    const std::size_t most = kMostBytes / (line * static_cast<std::size_t>(bench_.clocks));
    return static_cast<int>(std::clamp<std::size_t>(most, 1, static_cast<std::size_t>(least_runs())));
  }

  // At one clock, a run in each machine, inputs settled.
  void step(GateSimulation& simulation, const std::vector<Run>& runs, std::size_t clock) const {
    std::vector<const std::string*> inputs;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const auto episode = static_cast<std::size_t>(runs[i].episode);
      if (clock % episode == 0) simulation.set_state(runs[i].states[clock / episode], std::uint64_t{1} << i);
      inputs.push_back(&runs[i].inputs[clock]);
    }
    drive(simulation, inputs);
  }

  // At one clock of one run, the same in all machines.
  void step(GateSimulation& simulation, const Run& run, std::size_t clock) const {
    const auto episode = static_cast<std::size_t>(run.episode);
    if (clock % episode == 0) simulation.set_state(run.states[clock / episode], kAll);
    const std::string& line = run.inputs[clock];
    for (std::size_t i = 0; i < bench_.inputs.nets.size(); ++i)
      simulation.set(bench_.inputs.nets[i], line[line.size() - 1 - i] == '1' ? kAll : 0);
    simulation.settle();
  }

  // Of every bit of a line of results that the netlist has too: its number and its net.
  template <typename Function>
  void for_each_result(Function call) const {
    const std::vector<std::uint32_t>& outputs = bench_.outputs.nets;
    for (std::size_t i = 0; i < outputs.size(); ++i) call(i, outputs[i]);
    for (std::size_t i = 0; i < register_nets_.size(); ++i) {
      if (starts_alike_ && source_of(i)) call(outputs.size() + i, *register_nets_[i]);
    }
  }

  void compare(const std::vector<Run>& runs) {
    const std::uint64_t all = kAll >> (kMachines - runs.size());
    GateSimulation simulation(netlist_);
    std::vector<std::uint64_t> before(counted_.size());
    for (std::size_t clock = 0; clock < static_cast<std::size_t>(bench_.clocks); ++clock) {
      step(simulation, runs, clock);
      for (std::size_t i = 0; i < before.size(); ++i) before[i] = simulation.value(counted_q(i));
      if (is_compared(clock)) compare(simulation, runs, clock);
      simulation.clock();
      for (std::size_t i = 0; i < before.size(); ++i) {
        const std::uint64_t after = simulation.value(counted_q(i)), changed = (before[i] ^ after) & all;
        register_was_[i].add(changed & ~after, changed & after);
      }
    }
  }

  void compare(const GateSimulation& simulation, const std::vector<Run>& runs, std::size_t clock) {
    std::vector<const char*> last;  // bit 0
    for (const Run& run : runs) last.push_back(&run.results[clock].back());
    for_each_result([&](std::size_t bit, std::uint32_t net) {
      std::uint64_t lows = 0, highs = 0;
      for (std::size_t i = 0; i < runs.size(); ++i) {
        const char expected = *(last[i] - bit);
        lows |= std::uint64_t{expected == '0'} << i;
        highs |= std::uint64_t{expected == '1'} << i;
      }
      const std::uint64_t value = simulation.value(net);
      const std::uint64_t right = (value & highs) | (~value & lows);
      for (std::size_t i = 0; i < runs.size(); ++i) {
        if ((right >> i & 1) == 0) complain(runs[i], clock, bit, *(last[i] - bit));
      }
      if (bit < output_was_.size()) output_was_[bit].add(lows, highs);
    });
  }

  std::uint32_t counted_q(std::size_t i) const { return netlist_.flip_flops[counted_[i]].q; }

  // The name of a bit of the results.
  std::string name_of(std::size_t bit) const {
    if (bit < bench_.outputs.nets.size()) return bench_.outputs.name_of(bit);
    bit -= bench_.outputs.nets.size();
    for (const Register& word : bench_.registers) {
      if (bit < word.bits) return fmt::format("{}[{}]", word.path, bit);
      bit -= word.bits;
    }
    return {};
  }

  [[noreturn]] void complain(const Run& run, std::size_t clock, std::size_t bit, char expected) const {
    throw NetlistDiffers(
        fmt::format("the netlist of {} is not its Verilog: {} is {} and not {} at clock {} of run {}, "
                    "inputs {}",
                    options_.top, name_of(bit), expected == '0' ? 1 : 0, expected, clock, run.seed,
                    bench_.inputs.text(run.inputs[clock])));
  }

  void count_changes() {
    const auto both = [](const std::vector<Seen>& seen) {
      return static_cast<int>(std::count_if(seen.begin(), seen.end(), [](const Seen& s) { return s.low && s.high; }));
    };
    checked_.registers = static_cast<int>(register_was_.size());
    checked_.registers_changed = both(register_was_);
    checked_.outputs = static_cast<int>(output_was_.size());
    checked_.outputs_changed = both(output_was_);
  }

  bool all_changed() const {
    return checked_.registers_changed == checked_.registers && checked_.outputs_changed == checked_.outputs;
  }

  // The first output, or else register, that did not take both values.
  std::string first_unchanged() const {
    const auto is_unchanged = [](const Seen& s) { return !s.low || !s.high; };
    const auto output = std::find_if(output_was_.begin(), output_was_.end(), is_unchanged);
    if (output != output_was_.end()) return name_of(static_cast<std::size_t>(output - output_was_.begin()));
    const auto flip_flop = std::find_if(register_was_.begin(), register_was_.end(), is_unchanged);
    for (std::size_t i = 0; i < register_nets_.size(); ++i) {
      const auto source = source_of(i);
      if (source && source->flip_flop == counted_[static_cast<std::size_t>(flip_flop - register_was_.begin())])
        return name_of(output_was_.size() + i);
    }
    return "a flip-flop without a name";
  }

  void find_faults() {
    const std::vector<Fault> faults = random_faults(netlist_, bench_.outputs.nets, options_.faults);
    for (std::size_t first = 0; first < faults.size(); first += kMachines) {
      const std::size_t last = std::min(first + kMachines, faults.size());
      const std::vector<Fault> some(faults.begin() + static_cast<std::ptrdiff_t>(first),
                                    faults.begin() + static_cast<std::ptrdiff_t>(last));
      const std::uint64_t all = ~std::uint64_t{0} >> (kMachines - some.size());
      std::uint64_t found = 0;
      for (std::size_t i = 0; i < runs_.size() && found != all; ++i)
        found |= faults_found(runs_[i], some, all & ~found);
      for (std::size_t i = 0; i < some.size(); ++i) count_fault(some[i], (found >> i & 1) != 0);
    }
  }

  void count_fault(const Fault& fault, bool is_found) {
    ++checked_.faults;
    if (is_found) {
      ++checked_.faults_found;
    } else if (is_redundant(netlist_, fault, bench_.outputs.nets, options_.folder)) {
      ++checked_.faults_redundant;
    } else {
      checked_.faults_missed.push_back(fault_text(netlist_, fault));
    }
  }

  // The machines of `wanted` that differ somewhere in a run.
  std::uint64_t faults_found(const Run& run, const std::vector<Fault>& faults, std::uint64_t wanted) const {
    GateSimulation simulation(netlist_, faults);
    std::uint64_t found = 0;
    for (std::size_t clock = 0; clock < run.inputs.size() && (found & wanted) != wanted; ++clock) {
      step(simulation, run, clock);
      if (is_compared(clock)) {
        const std::string& results = run.results[clock];
        for_each_result([&](std::size_t bit, std::uint32_t net) {
          found |= results[results.size() - 1 - bit] == '1' ? ~simulation.value(net) : simulation.value(net);
        });
      }
      simulation.clock();
    }
    return found & wanted;
  }

  CheckOptions options_;
  GateNetlist netlist_;
  std::vector<NetlistPort> ports_;
  Testbench bench_;
  std::vector<std::optional<Source>> sources_;               // by net
  std::vector<std::optional<std::uint32_t>> register_nets_;  // by bit of all registers
  std::vector<Run> runs_;
  bool starts_alike_ = true;
  std::vector<std::size_t> counted_;  // flip-flops of which it is known what they were
  std::vector<Seen> register_was_, output_was_;
  NetlistChecked checked_;
};

}  // namespace

NetlistChecked check_netlist(const CheckOptions& options) { return Check(options).run(); }

}  // namespace wrinkle

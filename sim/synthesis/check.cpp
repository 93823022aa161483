#include "sim/synthesis/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <fstream>
#include <map>
#include <random>
#include <sstream>

#include "sim/synthesis/gates.h"
#include "sim/synthesis/stimulus.h"
#include "tb/process.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

constexpr int kClocks = 1000, kLeastRuns = 2, kMostRuns = 8;
// With registers as wires, a word stays until the deepest pipeline shows it, and only then is compared.
constexpr int kStay = 8;
// So long after power-up, an output on which the machines of a netlist do not agree is not compared. Icarus takes the
// other branch of an `if` on what it does not know, and then says more than the Verilog does.
constexpr int kPowerUp = 256;

// Ports NAME_0_, NAME_1_ ... as one port NAME.
std::vector<NetlistPort> joined(const std::vector<NetlistPort>& bits) {
  std::map<std::string, NetlistPort> ports;
  for (const NetlistPort& bit : bits) {
    const std::size_t end = bit.name.size() - 1, begin = bit.name.rfind('_', end - 1);
    const bool is_split = bit.name[end] == '_' && begin != std::string::npos;
    const std::string name = is_split ? bit.name.substr(0, begin) : bit.name;
    const std::size_t index = is_split ? std::stoul(bit.name.substr(begin + 1)) : 0;
    NetlistPort& port = ports[name];
    port.name = name;
    port.is_input = bit.is_input;
    port.nets.resize(std::max(port.nets.size(), index + 1));
    port.nets[index] = bit.nets[0];
  }
  std::vector<NetlistPort> all;
  for (const auto& [name, port] : ports) all.push_back(port);
  return all;
}

// Ports of one direction without the clock, and the nets of their bits: bit 0 of the first port first.
struct Bundle {
  std::vector<NetlistPort> ports;
  std::vector<std::uint32_t> nets;

  Bundle(const std::vector<NetlistPort>& all, bool is_input) {
    for (const NetlistPort& port : all) {
      if (port.is_input != is_input || port.name == "clk") continue;
      ports.push_back(port);
      nets.insert(nets.end(), port.nets.begin(), port.nets.end());
    }
  }

  // "a_i=01 b_i=1" of a line of bits.
  std::string text(const std::string& line) const {
    std::string text;
    std::size_t end = line.size();
    for (const NetlistPort& port : ports) {
      end -= port.nets.size();
      text += fmt::format("{}{}={}", text.empty() ? "" : " ", port.name, line.substr(end, port.nets.size()));
    }
    return text;
  }

  std::string name_of(std::size_t bit) const {
    for (const NetlistPort& port : ports) {
      if (bit < port.nets.size()) return fmt::format("{}[{}]", port.name, bit);
      bit -= port.nets.size();
    }
    return {};
  }
};

// What went in and what came out of the Verilog, a line for each clock.
struct Run {
  std::uint64_t seed;
  std::vector<std::string> inputs, outputs;
};

// What a bit has been.
struct Seen {
  bool low = false, high = false;
  void add(bool value) { (value ? high : low) = true; }
};

class Check {
 public:
  explicit Check(const CheckOptions& options)
      : options_(options),
        netlist_(read_gates(options.gates)),
        ports_(options.registers ? netlist_.ports : joined(netlist_.ports)),
        inputs_(ports_, true),
        outputs_(ports_, false),
        register_was_(netlist_.flip_flops.size()),
        output_was_(outputs_.nets.size()) {
    if (outputs_.nets.empty()) throw SynthesisError(options.top + " has no output");
  }

  NetlistChecked run() {
    build();
    for (int number = 1; number <= kMostRuns; ++number) {
      runs_.push_back(simulate_verilog(static_cast<std::uint64_t>(number)));
      compare(runs_.back());
      checked_.clocks += clocks();
      count_changes();
      const bool all_changed =
          checked_.registers_changed == checked_.registers && checked_.outputs_changed == checked_.outputs;
      if (all_changed && number >= kLeastRuns) break;
    }
    find_faults();
    return checked_;
  }

 private:
  // The Verilog between a file of inputs and one of outputs.
  std::string testbench() const {
    std::string connections, outputs, parameters;
    std::size_t first = 0;
    for (const NetlistPort& port : ports_) {
      if (port.name == "clk") connections += ", .clk(clk)";
    }
    for (const NetlistPort& port : inputs_.ports) {
      connections += fmt::format(", .{}(word[{} +: {}])", port.name, first, port.nets.size());
      first += port.nets.size();
    }
    std::size_t result = 0;
    for (const NetlistPort& port : outputs_.ports) {
      connections += fmt::format(", .{}(result[{} +: {}])", port.name, result, port.nets.size());
      result += port.nets.size();
    }
    for (const auto& [name, value] : options_.parameters)
      parameters += fmt::format("{}.{}({})", parameters.empty() ? "#(" : ", ", name, value.text);
    if (!parameters.empty()) parameters += ")";
    return fmt::format(R"(module wrinkle_check;
  reg clk;
  reg [{inputs}:0] word;
  reg [{inputs}:0] words [0:{clocks}-1];
  wire [{outputs}:0] result;
  integer i, file;
  {top} {parameters} verilog ({connections});
  initial begin
    clk = 0;
    $readmemb("{folder}/inputs", words);
    file = $fopen("{folder}/outputs", "w");
    for (i = 0; i < {clocks}; i = i + 1) begin
      word = words[i];
      #1 $fdisplay(file, "%b", result);
      clk = 1;
      #1 clk = 0;
    end
    $fclose(file);
    $finish;
  end
endmodule
)",
                       fmt::arg("inputs", std::max<std::size_t>(first, 1) - 1), fmt::arg("outputs", result - 1),
                       fmt::arg("clocks", clocks()), fmt::arg("top", options_.top), fmt::arg("parameters", parameters),
                       fmt::arg("connections", connections.substr(2)), fmt::arg("folder", options_.folder.string()));
  }

  void tool(const Arguments& command) const {
    const fs::path log = options_.folder / (command[0] + ".log");
    const int code = Process(command, log).wait();
    if (code != 0) throw SynthesisError(fmt::format("{} ended with code {}:\n{}", command[0], code, read_text(log)));
  }

  void build() const {
    std::ofstream(options_.folder / "check.v") << testbench();
    Arguments command{"iverilog", "-g2005", "-gno-specify", "-s", "wrinkle_check", "-o", options_.folder / "check.vvp"};
    for (const fs::path& folder : options_.include_folders) command.push_back("-I" + folder.string());
    command.push_back(options_.folder / "check.v");
    for (const fs::path& source : options_.sources) command.push_back(source);
    tool(command);
  }

  Run simulate_verilog(std::uint64_t seed) const {
    Run run{seed, stimulus(ports_, {seed, clocks(), stay()}), {}};
    std::ofstream inputs(options_.folder / "inputs");
    for (const std::string& line : run.inputs) inputs << (line.empty() ? "0" : line) << '\n';
    inputs.close();
    tool({"vvp", "-n", options_.folder / "check.vvp"});
    std::ifstream outputs(options_.folder / "outputs");
    for (std::string line; std::getline(outputs, line);) run.outputs.push_back(line);
    if (run.outputs.size() != run.inputs.size()) throw SynthesisError(options_.top + ": the simulation stopped early");
    return run;
  }

  void drive(GateSimulation& simulation, const std::string& line) const {
    for (std::size_t i = 0; i < inputs_.nets.size(); ++i)
      simulation.set(inputs_.nets[i], line[line.size() - 1 - i] == '1');
    simulation.settle();
  }

  int stay() const { return options_.registers ? 1 : kStay; }
  int clocks() const { return kClocks * stay(); }
  bool is_compared(int clock) const { return clock % stay() == stay() - 1; }

  // Machines whose output bit is not what the Verilog says; none where it says x.
  static std::uint64_t wrong(const GateSimulation& simulation, std::uint32_t net, char expected) {
    if (expected == 'x' || expected == 'z') return 0;
    return simulation.value(net) ^ (expected == '1' ? ~std::uint64_t{0} : 0);
  }

  // Machines with a fault whose output bit is not that of the last, which has none, where the Verilog knows it.
  static std::uint64_t unlike_the_right_one(const GateSimulation& simulation, std::uint32_t net, char expected) {
    const std::uint64_t value = simulation.value(net);
    const bool right = value >> 63 != 0;
    return right == (expected == '1') ? wrong(simulation, net, expected) : 0;
  }

  void compare(const Run& run) {
    GateSimulation simulation(netlist_, run.seed);
    for (std::size_t clock = 0; clock < run.inputs.size(); ++clock) {
      drive(simulation, run.inputs[clock]);
      const std::string& expected = run.outputs[clock];
      for (std::size_t bit = 0; bit < outputs_.nets.size() && is_compared(static_cast<int>(clock)); ++bit) {
        const char value = expected[expected.size() - 1 - bit];
        const std::uint64_t machines = wrong(simulation, outputs_.nets[bit], value);
        const bool depends_on_power_up = machines != ~std::uint64_t{0} && static_cast<int>(clock) < kPowerUp;
        if (machines != 0 && !depends_on_power_up) complain(run, clock, bit, value);
        if (value == '0' || value == '1') output_was_[bit].add(value == '1');
      }
      simulation.clock();
      for (std::size_t i = 0; i < register_was_.size(); ++i)
        register_was_[i].add((simulation.value(netlist_.flip_flops[i].q) & 1) != 0);
    }
  }

  [[noreturn]] void complain(const Run& run, std::size_t clock, std::size_t bit, char expected) const {
    throw NetlistDiffers(fmt::format(
        "the netlist of {} is not its Verilog: {} is {} and not {} at clock {} of run {}, inputs {}", options_.top,
        outputs_.name_of(bit), expected == '1' ? 0 : 1, expected, clock, run.seed, inputs_.text(run.inputs[clock])));
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

  // Gates that something reads, without those that only name a net or a constant anew.
  std::vector<std::size_t> gates_that_matter() const {
    std::vector<bool> is_read(netlist_.nets);
    for (const std::uint32_t net : outputs_.nets) is_read[net] = true;
    for (const FlipFlop& flip_flop : netlist_.flip_flops) is_read[flip_flop.d] = true;
    std::vector<std::size_t> found;
    for (std::size_t g = netlist_.gates.size(); g-- > 0;) {
      const Gate& gate = netlist_.gates[g];
      if (!is_read[gate.y]) continue;
      is_read[gate.a] = is_read[gate.b] = true;
      if (gate.a != gate.b || gate.invert_y) found.push_back(g);
    }
    return found;
  }

  std::vector<Fault> random_faults() const {
    const std::vector<std::size_t> gates = gates_that_matter();
    std::mt19937_64 random(17);
    std::vector<Fault> faults;
    while (static_cast<int>(faults.size()) < options_.faults && !gates.empty())
      faults.push_back({gates[random() % gates.size()], static_cast<Fault::Kind>(random() % 5)});
    return faults;
  }

  void find_faults() {
    const std::vector<Fault> faults = random_faults();
    constexpr std::size_t kMachines = 63;
    for (std::size_t first = 0; first < faults.size(); first += kMachines) {
      const std::size_t last = std::min(first + kMachines, faults.size());
      const std::vector<Fault> some(faults.begin() + static_cast<std::ptrdiff_t>(first),
                                    faults.begin() + static_cast<std::ptrdiff_t>(last));
      const std::uint64_t all = (std::uint64_t{1} << some.size()) - 1;
      std::uint64_t found = 0;
      for (std::size_t i = 0; i < runs_.size() && found != all; ++i)
        found |= faults_found(runs_[i], some, all & ~found);
      checked_.faults += static_cast<int>(some.size());
      checked_.faults_found += std::popcount(found);
    }
  }

  // The machines of `wanted` that differ somewhere in a run.
  std::uint64_t faults_found(const Run& run, const std::vector<Fault>& faults, std::uint64_t wanted) const {
    GateSimulation simulation(netlist_, run.seed, faults);
    std::uint64_t found = 0;
    for (std::size_t clock = 0; clock < run.inputs.size() && (found & wanted) != wanted; ++clock) {
      drive(simulation, run.inputs[clock]);
      const std::string& expected = run.outputs[clock];
      for (std::size_t bit = 0; bit < outputs_.nets.size() && is_compared(static_cast<int>(clock)); ++bit)
        found |= unlike_the_right_one(simulation, outputs_.nets[bit], expected[expected.size() - 1 - bit]);
      simulation.clock();
    }
    return found & wanted;
  }

  CheckOptions options_;
  GateNetlist netlist_;
  std::vector<NetlistPort> ports_;
  Bundle inputs_, outputs_;
  std::vector<Run> runs_;
  std::vector<Seen> register_was_, output_was_;
  NetlistChecked checked_;
};

}  // namespace

NetlistChecked check_netlist(const CheckOptions& options) { return Check(options).run(); }

}  // namespace wrinkle

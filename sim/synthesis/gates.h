// A netlist as gates of two inputs and flip-flops of one clock, simulated for 64 machines at once: one bit of a word is
// one machine. No machine is compiled, so that a netlist of a hundred thousand gates starts in a second.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <unordered_map>
#include <vector>

namespace wrinkle {

// y = ((a ^ invert_a) & (b ^ invert_b)) ^ invert_y, or the same with ^ in the place of &.
struct Gate {
  std::uint32_t a = 0, b = 0, y = 0;
  bool invert_a = false, invert_b = false, invert_y = false, is_xor = false;

  // y is a, or a inverted.
  bool is_buffer() const { return a == b && !is_xor && invert_a == invert_b; }
  bool is_inverter() const { return is_buffer() && invert_a != invert_y; }
};

struct FlipFlop {
  std::uint32_t d = 0, q = 0;
};

struct NetlistPort {
  std::string name;
  bool is_input = false;
  std::vector<std::uint32_t> nets;  // bit 0 first
};

struct GateNetlist {
  std::vector<NetlistPort> ports;
  std::vector<Gate> gates;  // each behind those that drive it
  std::vector<FlipFlop> flip_flops;
  std::uint32_t nets = 0;  // net 0 is always 0
  // Nets of the top that a gate, a flip-flop or an input drives; some have several names.
  std::unordered_map<std::string, std::uint32_t> names;
};

// Reads what Yosys's `write_blif -gates -icells` writes of its own gates and positive-edge flip-flops of the clock
// `clk`, and of modules made of them; the first model is the whole. A net without a driver is 0. Throws SynthesisError
// for another cell, another clock or a loop.
GateNetlist read_gates(const std::filesystem::path& blif);

// One gate wrong in one machine.
struct Fault {
  enum class Kind {
    kOutput0,
    kOutput1,
    kPin0,
    kPin1,
    kOther
  };  // kPin: of input a; kOther: & for ^, or an inverter more
  std::size_t gate = 0;
  Kind kind = Kind::kOutput0;
};

// The output of a gate for 64 machines.
std::uint64_t evaluate(const Gate& gate, std::uint64_t a, std::uint64_t b);
// The same of a gate that is wrong in all of them.
std::uint64_t evaluate(const Gate& gate, Fault::Kind kind, std::uint64_t a, std::uint64_t b);

class GateSimulation {
 public:
  // Machine i has faults[i], the rest are right. Flip-flops start with 0.
  explicit GateSimulation(const GateNetlist& netlist, const std::vector<Fault>& faults = {});

  // A bit for each machine.
  void set(std::uint32_t net, std::uint64_t value) { values_[net] = value; }
  // A bit for each flip-flop, of the machines in `machines`.
  void set_state(const std::vector<bool>& state, std::uint64_t machines);
  void settle();
  void clock();
  std::uint64_t value(std::uint32_t net) const { return values_[net]; }

 private:
  void settle(std::size_t from, std::size_t to);
  void settle_faulty(std::size_t gate);

  const GateNetlist* netlist_;
  std::vector<std::uint64_t> values_, next_;
  std::vector<Fault> faults_;        // by machine
  std::vector<std::size_t> faulty_;  // gates with a fault, in order
};

}  // namespace wrinkle

#include "sim/synthesis/gates.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <sstream>
#include <unordered_map>

#include "sim/synthesis/synthesis.h"

namespace wrinkle {
namespace {

constexpr std::uint32_t kZero = 0;

std::uint64_t mask(bool bit) { return bit ? ~std::uint64_t{0} : 0; }

std::uint64_t evaluate(const Gate& gate, std::uint64_t a, std::uint64_t b) {
  a ^= mask(gate.invert_a);
  b ^= mask(gate.invert_b);
  return (gate.is_xor ? a ^ b : a & b) ^ mask(gate.invert_y);
}

// How each cell of Yosys is written as a Gate.
struct Shape {
  bool invert_a, invert_b, invert_y, is_xor;
};
const std::map<std::string, Shape>& shapes() {
  static const std::map<std::string, Shape> found{
      {"$_AND_", {false, false, false, false}},   {"$_NAND_", {false, false, true, false}},
      {"$_OR_", {true, true, true, false}},       {"$_NOR_", {true, true, false, false}},
      {"$_XOR_", {false, false, false, true}},    {"$_XNOR_", {false, false, true, true}},
      {"$_ANDNOT_", {false, true, false, false}}, {"$_ORNOT_", {true, false, true, false}}};
  return found;
}

class Reader {
 public:
  explicit Reader(const std::filesystem::path& path) : path_(path), in_(path) {
    if (!in_) throw SynthesisError(path.string() + ": netlist not found");
    net("$false");
    buffer(kZero, net("$true"), true);
    net("$undef");
  }

  GateNetlist read() {
    for (std::string line; std::getline(in_, line);) statement(line);
    netlist_.nets = static_cast<std::uint32_t>(names_.size());
    for (const auto& [name, port] : ports_) netlist_.ports.push_back(port);
    sort();
    name_driven_nets();
    return std::move(netlist_);
  }

 private:
  std::uint32_t net(const std::string& name) {
    return names_.try_emplace(name, static_cast<std::uint32_t>(names_.size())).first->second;
  }
  std::uint32_t fresh() { return net(fmt::format("$fresh{}", names_.size())); }

  void buffer(std::uint32_t from, std::uint32_t to, bool inverted) {
    // from & from, but for the constant 1, which is an inverted 0.
    netlist_.gates.push_back({from, from, to, false, false, inverted, false});
  }

  void statement(const std::string& line) {
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    if (keyword == ".inputs" || keyword == ".outputs") add_ports(words, keyword == ".inputs");
    if (keyword == ".gate" || keyword == ".subckt") add_cell(words);
    if (keyword == ".names") add_names(words);
  }

  void add_ports(std::istringstream& words, bool is_input) {
    for (std::string name; words >> name;) {
      const std::size_t bracket = name.rfind('[');
      NetlistPort& port = ports_[name.substr(0, bracket)];
      port.name = name.substr(0, bracket);
      port.is_input = is_input;
      const std::size_t bit = bracket == std::string::npos ? 0 : std::stoul(name.substr(bracket + 1));
      port.nets.resize(std::max(port.nets.size(), bit + 1), kZero);
      port.nets[bit] = net(name);
    }
  }

  // A constant, whose drivers are there already, or a wire by another name.
  void add_names(std::istringstream& words) {
    std::string from, to;
    words >> from >> to;
    if (!to.empty()) buffer(net(from), net(to), false);
  }

  void add_cell(std::istringstream& words) {
    std::string type;
    words >> type;
    std::map<std::string, std::uint32_t> pins;
    for (std::string pin; words >> pin;) {
      const std::size_t equal = pin.find('=');
      pins[pin.substr(0, equal)] = net(pin.substr(equal + 1));
    }
    if (type == "$_DFF_P_") {
      clocks_.push_back(pins.at("C"));
      netlist_.flip_flops.push_back({pins.at("D"), pins.at("Q")});
    } else if (type == "$_NOT_" || type == "$_BUF_") {
      buffer(pins.at("A"), pins.at("Y"), type == "$_NOT_");
    } else if (type == "$_MUX_" || type == "$_NMUX_") {
      const std::uint32_t low = fresh(), high = fresh();
      netlist_.gates.push_back({pins.at("A"), pins.at("S"), low, false, true, true, false});
      netlist_.gates.push_back({pins.at("B"), pins.at("S"), high, false, false, true, false});
      netlist_.gates.push_back({low, high, pins.at("Y"), false, false, type == "$_MUX_", false});
    } else if (const auto shape = shapes().find(type); shape != shapes().end()) {
      const auto [invert_a, invert_b, invert_y, is_xor] = shape->second;
      netlist_.gates.push_back({pins.at("A"), pins.at("B"), pins.at("Y"), invert_a, invert_b, invert_y, is_xor});
    } else {
      throw SynthesisError(fmt::format("{}: cell {} cannot be simulated", path_.string(), type));
    }
  }

  // Each gate behind its drivers; every flip-flop on `clk`.
  void sort() {
    std::vector<std::vector<std::uint32_t>> readers(netlist_.nets);
    std::vector<int> driver(netlist_.nets, -1), waits(netlist_.gates.size(), 0);
    for (std::size_t g = 0; g < netlist_.gates.size(); ++g) driver[netlist_.gates[g].y] = static_cast<int>(g);
    for (std::size_t g = 0; g < netlist_.gates.size(); ++g) {
      for (const std::uint32_t pin : {netlist_.gates[g].a, netlist_.gates[g].b}) {
        if (driver[pin] < 0) continue;
        readers[pin].push_back(static_cast<std::uint32_t>(g));
        ++waits[g];
      }
    }
    std::vector<std::uint32_t> order;
    for (std::size_t g = 0; g < waits.size(); ++g) {
      if (waits[g] == 0) order.push_back(static_cast<std::uint32_t>(g));
    }
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (const std::uint32_t reader : readers[netlist_.gates[order[i]].y]) {
        if (--waits[reader] == 0) order.push_back(reader);
      }
    }
    if (order.size() != netlist_.gates.size()) throw SynthesisError(path_.string() + ": a loop of gates");
    check_clocks(driver);
    std::vector<Gate> sorted;
    for (const std::uint32_t g : order) sorted.push_back(netlist_.gates[g]);
    netlist_.gates = std::move(sorted);
  }

  void name_driven_nets() {
    std::vector<bool> driven(netlist_.nets);
    driven[kZero] = true;
    for (const Gate& gate : netlist_.gates) driven[gate.y] = true;
    for (const FlipFlop& flip_flop : netlist_.flip_flops) driven[flip_flop.q] = true;
    for (const NetlistPort& port : netlist_.ports) {
      for (const std::uint32_t net : port.nets) driven[net] = driven[net] || port.is_input;
    }
    driven[names_.at("$undef")] = false;
    // A wire that is only another name of a net without a driver has none either.
    for (const Gate& gate : netlist_.gates) {
      if (gate.is_buffer() && !driven[gate.a]) driven[gate.y] = false;
    }
    std::erase_if(names_, [&](const auto& name) { return !driven[name.second]; });
    netlist_.names = std::move(names_);
  }

  void check_clocks(const std::vector<int>& driver) const {
    const auto found = ports_.find("clk");
    for (std::uint32_t clock : clocks_) {
      while (driver[clock] >= 0) {
        const Gate& gate = netlist_.gates[static_cast<std::size_t>(driver[clock])];
        if (!gate.is_buffer() || gate.is_inverter()) break;
        clock = gate.a;
      }
      if (found == ports_.end() || clock != found->second.nets[0])
        throw SynthesisError(path_.string() + ": a flip-flop of another clock than clk");
    }
  }

  std::filesystem::path path_;
  std::ifstream in_;
  std::unordered_map<std::string, std::uint32_t> names_;
  std::map<std::string, NetlistPort> ports_;
  std::vector<std::uint32_t> clocks_;
  GateNetlist netlist_;
};

}  // namespace

GateNetlist read_gates(const std::filesystem::path& blif) { return Reader(blif).read(); }

GateSimulation::GateSimulation(const GateNetlist& netlist, const std::vector<Fault>& faults)
    : netlist_(&netlist), values_(netlist.nets, 0), next_(netlist.flip_flops.size()), faults_(faults) {
  for (const Fault& fault : faults) faulty_.push_back(fault.gate);
  std::sort(faulty_.begin(), faulty_.end());
  faulty_.erase(std::unique(faulty_.begin(), faulty_.end()), faulty_.end());
}

void GateSimulation::set_state(const std::vector<bool>& state) {
  for (std::size_t i = 0; i < state.size(); ++i) set(netlist_->flip_flops[i].q, state[i]);
}

void GateSimulation::settle(std::size_t from, std::size_t to) {
  for (std::size_t g = from; g < to; ++g) {
    const Gate& gate = netlist_->gates[g];
    values_[gate.y] = evaluate(gate, values_[gate.a], values_[gate.b]);
  }
}

void GateSimulation::settle_faulty(std::size_t index) {
  const Gate& gate = netlist_->gates[index];
  std::uint64_t a = values_[gate.a], b = values_[gate.b], swapped = 0, low = 0, high = 0;
  for (std::size_t machine = 0; machine < faults_.size(); ++machine) {
    if (faults_[machine].gate != index) continue;
    const std::uint64_t bit = std::uint64_t{1} << machine;
    switch (faults_[machine].kind) {
      case Fault::Kind::kOutput0:
        low |= bit;
        break;
      case Fault::Kind::kOutput1:
        high |= bit;
        break;
      case Fault::Kind::kPin0:
        a &= ~bit;
        break;
      case Fault::Kind::kPin1:
        a |= bit;
        break;
      case Fault::Kind::kOther:
        swapped |= bit;
        break;
    }
    // Both pins of a buffer are one.
    if (gate.a == gate.b) b = a;
  }
  Gate other = gate;
  if (gate.a == gate.b) {
    other.invert_y = !gate.invert_y;
  } else {
    other.is_xor = !gate.is_xor;
  }
  const std::uint64_t right = evaluate(gate, a, b), wrong = evaluate(other, a, b);
  values_[gate.y] = (((right & ~swapped) | (wrong & swapped)) & ~low) | high;
}

void GateSimulation::settle() {
  std::size_t from = 0;
  for (const std::size_t gate : faulty_) {
    settle(from, gate);
    settle_faulty(gate);
    from = gate + 1;
  }
  settle(from, netlist_->gates.size());
}

void GateSimulation::clock() {
  const auto& flip_flops = netlist_->flip_flops;
  for (std::size_t i = 0; i < flip_flops.size(); ++i) next_[i] = values_[flip_flops[i].d];
  for (std::size_t i = 0; i < flip_flops.size(); ++i) values_[flip_flops[i].q] = next_[i];
}

}  // namespace wrinkle

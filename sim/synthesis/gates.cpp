#include "sim/synthesis/gates.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <numeric>
#include <sstream>
#include <unordered_map>

#include "sim/synthesis/synthesis.h"

namespace wrinkle {
namespace {

constexpr std::uint32_t kZero = 0;

std::uint64_t mask(bool bit) { return bit ? ~std::uint64_t{0} : 0; }

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

// Net 0 of every model is $false, net 1 $true, net 2 $undef.
constexpr std::uint32_t kTrue = 1, kUndefined = 2;

// A .model as it stands in the file, its nets numbered from 0.
struct Model {
  struct ClockedBit {
    std::uint32_t clock, d, q;
  };
  struct Instance {
    std::string type;
    std::vector<std::pair<std::string, std::uint32_t>> pins;
  };

  std::unordered_map<std::string, std::uint32_t> names{{"$false", kZero}, {"$true", kTrue}, {"$undef", kUndefined}};
  std::uint32_t nets = 3;
  std::vector<NetlistPort> ports;
  std::vector<Gate> gates;
  std::vector<ClockedBit> flip_flops;
  std::vector<Instance> instances;

  std::uint32_t net(const std::string& name) {
    const auto [found, is_new] = names.try_emplace(name, nets);
    if (is_new) ++nets;
    return found->second;
  }
  void buffer(std::uint32_t from, std::uint32_t to, bool inverted) {
    // from & from, but for the constant 1, which is an inverted 0.
    gates.push_back({from, from, to, false, false, inverted, false});
  }
};

class Parser {
 public:
  explicit Parser(const std::filesystem::path& path) : in_(path) {
    if (!in_) throw SynthesisError(path.string() + ": netlist not found");
    for (std::string line; std::getline(in_, line);) statement(line);
    if (models.empty()) throw SynthesisError(path.string() + ": no netlist");
  }

  std::string top;  // the first
  std::map<std::string, Model> models;

 private:
  void statement(const std::string& line) {
    std::istringstream words(line);
    std::string keyword, name;
    words >> keyword;
    if (keyword == ".model" && words >> name) {
      if (top.empty()) top = name;
      model_ = &models[name];
    }
    if (keyword == ".inputs" || keyword == ".outputs") add_ports(words, keyword == ".inputs");
    if (keyword == ".gate" || keyword == ".subckt") add_cell(words);
    if (keyword == ".names") add_names(words);
  }

  void add_ports(std::istringstream& words, bool is_input) {
    std::map<std::string, NetlistPort> ports;
    for (std::string name; words >> name;) {
      const std::size_t bracket = name.rfind('[');
      NetlistPort& port = ports[name.substr(0, bracket)];
      port.name = name.substr(0, bracket);
      port.is_input = is_input;
      const std::size_t bit = bracket == std::string::npos ? 0 : std::stoul(name.substr(bracket + 1));
      port.nets.resize(std::max(port.nets.size(), bit + 1), kZero);
      port.nets[bit] = model_->net(name);
    }
    for (const auto& [name, port] : ports) model_->ports.push_back(port);
  }

  // A constant, whose drivers are there already, or a wire by another name.
  void add_names(std::istringstream& words) {
    std::string from, to;
    words >> from >> to;
    if (!to.empty()) model_->buffer(model_->net(from), model_->net(to), false);
  }

  void add_cell(std::istringstream& words) {
    Model::Instance cell;
    words >> cell.type;
    for (std::string pin; words >> pin;) {
      const std::size_t equal = pin.find('=');
      cell.pins.emplace_back(pin.substr(0, equal), model_->net(pin.substr(equal + 1)));
    }
    const auto pin = [&](const char* name) {
      return std::find_if(cell.pins.begin(), cell.pins.end(), [&](const auto& p) { return p.first == name; })->second;
    };
    if (cell.type == "$_DFF_P_") {
      model_->flip_flops.push_back({pin("C"), pin("D"), pin("Q")});
    } else if (cell.type == "$_NOT_" || cell.type == "$_BUF_") {
      model_->buffer(pin("A"), pin("Y"), cell.type == "$_NOT_");
    } else if (cell.type == "$_MUX_" || cell.type == "$_NMUX_") {
      const std::uint32_t low = model_->nets++, high = model_->nets++;
      model_->gates.push_back({pin("A"), pin("S"), low, false, true, true, false});
      model_->gates.push_back({pin("B"), pin("S"), high, false, false, true, false});
      model_->gates.push_back({low, high, pin("Y"), false, false, cell.type == "$_MUX_", false});
    } else if (const auto shape = shapes().find(cell.type); shape != shapes().end()) {
      const auto [invert_a, invert_b, invert_y, is_xor] = shape->second;
      model_->gates.push_back({pin("A"), pin("B"), pin("Y"), invert_a, invert_b, invert_y, is_xor});
    } else {
      model_->instances.push_back(std::move(cell));
    }
  }

  std::ifstream in_;
  Model* model_ = nullptr;
};

// The top model with all others in it.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& path) : path_(path), parser_(path) {}

  GateNetlist read() {
    const Model& top = parser_.models.at(parser_.top);
    std::vector<std::uint32_t> same(top.nets);
    std::iota(same.begin(), same.end(), 0);
    netlist_.nets = top.nets;
    netlist_.gates.push_back({kZero, kZero, kTrue, false, false, true, false});
    add(top, same);
    netlist_.ports = top.ports;
    std::sort(netlist_.ports.begin(), netlist_.ports.end(),
              [](const NetlistPort& a, const NetlistPort& b) { return a.name < b.name; });
    sort();
    name_driven_nets(top);
    drop_unread();
    return std::move(netlist_);
  }

 private:
  // The gates of a model whose net i is net[i].
  void add(const Model& model, const std::vector<std::uint32_t>& net) {
    for (Gate gate : model.gates) {
      for (std::uint32_t* pin : {&gate.a, &gate.b, &gate.y}) *pin = net[*pin];
      netlist_.gates.push_back(gate);
    }
    for (const auto& [clock, d, q] : model.flip_flops) {
      clocks_.push_back(net[clock]);
      netlist_.flip_flops.push_back({net[d], net[q]});
    }
    for (const Model::Instance& instance : model.instances) {
      const auto found = parser_.models.find(instance.type);
      if (found == parser_.models.end())
        throw SynthesisError(fmt::format("{}: cell {} cannot be simulated", path_.string(), instance.type));
      add(found->second, nets_inside(found->second, instance, net));
    }
  }

  std::vector<std::uint32_t> nets_inside(const Model& model, const Model::Instance& instance,
                                         const std::vector<std::uint32_t>& outside) {
    constexpr std::uint32_t kNone = ~std::uint32_t{0};
    std::vector<std::uint32_t> nets(model.nets, kNone);
    nets[kZero] = kZero;
    nets[kTrue] = kTrue;
    nets[kUndefined] = kUndefined;
    for (const auto& [pin, net] : instance.pins) {
      const auto inside = model.names.find(pin);
      if (inside != model.names.end()) nets[inside->second] = outside[net];
    }
    for (std::uint32_t& net : nets) {
      if (net == kNone) net = netlist_.nets++;
    }
    return nets;
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

  void name_driven_nets(const Model& top) {
    std::vector<bool> driven(netlist_.nets);
    driven[kZero] = true;
    for (const Gate& gate : netlist_.gates) driven[gate.y] = true;
    for (const FlipFlop& flip_flop : netlist_.flip_flops) driven[flip_flop.q] = true;
    for (const NetlistPort& port : netlist_.ports) {
      for (const std::uint32_t net : port.nets) driven[net] = driven[net] || port.is_input;
    }
    driven[kUndefined] = false;
    // A wire that is only another name of a net without a driver has none either.
    for (const Gate& gate : netlist_.gates) {
      if (gate.is_buffer() && !driven[gate.a]) driven[gate.y] = false;
    }
    for (const auto& name : top.names) {
      if (driven[name.second]) netlist_.names.insert(name);
    }
  }

  // Models have more inside than is used of them. What a net with a name of the source depends on stays.
  void drop_unread() {
    std::vector<bool> is_read(netlist_.nets);
    for (const NetlistPort& port : netlist_.ports) {
      for (const std::uint32_t net : port.nets) is_read[net] = true;
    }
    for (const auto& [name, net] : netlist_.names) is_read[net] = is_read[net] || name[0] != '$';
    for (bool is_done = false; !is_done;) {
      for (std::size_t g = netlist_.gates.size(); g-- > 0;) {
        const Gate& gate = netlist_.gates[g];
        if (is_read[gate.y]) is_read[gate.a] = is_read[gate.b] = true;
      }
      is_done = true;
      for (const FlipFlop& flip_flop : netlist_.flip_flops) {
        if (!is_read[flip_flop.q] || is_read[flip_flop.d]) continue;
        is_read[flip_flop.d] = true;
        is_done = false;
      }
    }
    std::erase_if(netlist_.gates, [&](const Gate& gate) { return !is_read[gate.y]; });
    std::erase_if(netlist_.flip_flops, [&](const FlipFlop& flip_flop) { return !is_read[flip_flop.q]; });
    std::erase_if(netlist_.names, [&](const auto& name) { return !is_read[name.second]; });
  }

  void check_clocks(const std::vector<int>& driver) const {
    const auto found = std::find_if(netlist_.ports.begin(), netlist_.ports.end(),
                                    [](const NetlistPort& port) { return port.name == "clk"; });
    for (std::uint32_t clock : clocks_) {
      while (driver[clock] >= 0) {
        const Gate& gate = netlist_.gates[static_cast<std::size_t>(driver[clock])];
        if (!gate.is_buffer() || gate.is_inverter()) break;
        clock = gate.a;
      }
      if (found == netlist_.ports.end() || clock != found->nets[0])
        throw SynthesisError(path_.string() + ": a flip-flop of another clock than clk");
    }
  }

  std::filesystem::path path_;
  Parser parser_;
  std::vector<std::uint32_t> clocks_;
  GateNetlist netlist_;
};

}  // namespace

std::uint64_t evaluate(const Gate& gate, std::uint64_t a, std::uint64_t b) {
  a ^= mask(gate.invert_a);
  b ^= mask(gate.invert_b);
  return (gate.is_xor ? a ^ b : a & b) ^ mask(gate.invert_y);
}

std::uint64_t evaluate(const Gate& gate, Fault::Kind kind, std::uint64_t a, std::uint64_t b) {
  if (kind == Fault::Kind::kOutput0) return 0;
  if (kind == Fault::Kind::kOutput1) return mask(true);
  // Both pins of a buffer are one.
  const bool is_one_pin = gate.a == gate.b;
  if (kind != Fault::Kind::kOther) {
    a = mask(kind == Fault::Kind::kPin1);
    return evaluate(gate, a, is_one_pin ? a : b);
  }
  Gate other = gate;
  (is_one_pin ? other.invert_y : other.is_xor) ^= true;
  return evaluate(other, a, b);
}

GateNetlist read_gates(const std::filesystem::path& blif) { return Reader(blif).read(); }

GateSimulation::GateSimulation(const GateNetlist& netlist, const std::vector<Fault>& faults)
    : netlist_(&netlist), values_(netlist.nets, 0), next_(netlist.flip_flops.size()), faults_(faults) {
  for (const Fault& fault : faults) faulty_.push_back(fault.gate);
  std::sort(faulty_.begin(), faulty_.end());
  faulty_.erase(std::unique(faulty_.begin(), faulty_.end()), faulty_.end());
}

void GateSimulation::set_state(const std::vector<bool>& state, std::uint64_t machines) {
  for (std::size_t i = 0; i < state.size(); ++i) {
    std::uint64_t& value = values_[netlist_->flip_flops[i].q];
    value = (value & ~machines) | (mask(state[i]) & machines);
  }
}

void GateSimulation::settle(std::size_t from, std::size_t to) {
  for (std::size_t g = from; g < to; ++g) {
    const Gate& gate = netlist_->gates[g];
    values_[gate.y] = evaluate(gate, values_[gate.a], values_[gate.b]);
  }
}

void GateSimulation::settle_faulty(std::size_t index) {
  const Gate& gate = netlist_->gates[index];
  const std::uint64_t a = values_[gate.a], b = values_[gate.b];
  std::uint64_t y = evaluate(gate, a, b);
  for (std::size_t machine = 0; machine < faults_.size(); ++machine) {
    if (faults_[machine].gate != index) continue;
    const std::uint64_t bit = std::uint64_t{1} << machine;
    y = (y & ~bit) | (evaluate(gate, faults_[machine].kind, a, b) & bit);
  }
  values_[gate.y] = y;
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

#include "sim/synthesis/faults.h"

#include <fmt/format.h>

#include <fstream>
#include <random>

#include "sim/synthesis/synthesis.h"
#include "tb/process.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

// All nets that a fault may reach are compared; what drives them is written twice, once with the fault.
class Cone {
 public:
  Cone(const GateNetlist& netlist, std::size_t gate, const std::vector<std::uint32_t>& observed)
      : netlist_(netlist), reached_(netlist.nets), needed_(netlist.nets) {
    reached_[netlist.gates[gate].y] = true;
    for (const Gate& other : netlist.gates) {
      if (reached_[other.a] || reached_[other.b]) reached_[other.y] = true;
    }
    for (const std::uint32_t net : observed) add_result(net);
    for (const FlipFlop& flip_flop : netlist.flip_flops) add_result(flip_flop.d);
    for (std::size_t g = netlist.gates.size(); g-- > 0;) {
      const Gate& needs = netlist.gates[g];
      if (needed_[needs.y]) needed_[needs.a] = needed_[needs.b] = true;
    }
  }

  bool is_seen() const { return !results_.empty(); }

  void write(const fs::path& path, const Fault* fault) const {
    std::ofstream file(path);
    file << ".model cone\n.inputs";
    std::vector<bool> driven(netlist_.nets);
    for (const Gate& gate : netlist_.gates) driven[gate.y] = true;
    for (std::uint32_t net = 1; net < netlist_.nets; ++net) {
      if (needed_[net] && !driven[net]) file << " n" << net;
    }
    file << "\n.outputs";
    for (const std::uint32_t net : results_) file << " o" << net;
    file << "\n.names n0\n";  // net 0 is the constant 0
    for (const std::uint32_t net : results_) file << fmt::format(".names n{0} o{0}\n1 1\n", net);
    for (std::size_t g = 0; g < netlist_.gates.size(); ++g) {
      if (needed_[netlist_.gates[g].y]) write_gate(file, g, fault != nullptr && fault->gate == g ? fault : nullptr);
    }
    file << ".end\n";
  }

 private:
  void add_result(std::uint32_t net) {
    if (!reached_[net] || needed_[net]) return;
    needed_[net] = true;
    results_.push_back(net);
  }

  void write_gate(std::ofstream& file, std::size_t g, const Fault* fault) const {
    const Gate& gate = netlist_.gates[g];
    const auto is_one = [&](bool a, bool b) {
      const std::uint64_t wide_a = a ? 1 : 0, wide_b = b ? 1 : 0;
      return ((fault != nullptr ? evaluate(gate, fault->kind, wide_a, wide_b) : evaluate(gate, wide_a, wide_b)) & 1) !=
             0;
    };
    const bool is_one_pin = gate.a == gate.b;
    std::string rows;
    for (const bool a : {false, true}) {
      for (const bool b : {false, true}) {
        if (is_one_pin && a != b) continue;
        if (is_one(a, b)) rows += fmt::format("{}{} 1\n", a ? "1" : "0", is_one_pin ? "" : b ? "1" : "0");
      }
    }
    // A constant 0 has no inputs.
    std::string inputs;
    if (!rows.empty()) inputs = fmt::format("n{} ", gate.a);
    if (!rows.empty() && !is_one_pin) inputs += fmt::format("n{} ", gate.b);
    file << fmt::format(".names {}n{}\n{}", inputs, gate.y, rows);
  }

  const GateNetlist& netlist_;
  std::vector<bool> reached_, needed_;
  std::vector<std::uint32_t> results_;
};

// Gates that something reads, without those that only name a net or a constant anew.
std::vector<std::size_t> gates_that_matter(const GateNetlist& netlist, const std::vector<std::uint32_t>& observed) {
  std::vector<bool> is_read(netlist.nets);
  for (const std::uint32_t net : observed) is_read[net] = true;
  for (const FlipFlop& flip_flop : netlist.flip_flops) is_read[flip_flop.d] = true;
  std::vector<std::size_t> found;
  for (std::size_t g = netlist.gates.size(); g-- > 0;) {
    const Gate& gate = netlist.gates[g];
    if (!is_read[gate.y]) continue;
    is_read[gate.a] = is_read[gate.b] = true;
    if (!gate.is_buffer() || gate.is_inverter()) found.push_back(g);
  }
  return found;
}

}  // namespace

std::vector<Fault> random_faults(const GateNetlist& netlist, const std::vector<std::uint32_t>& observed, int count) {
  const std::vector<std::size_t> gates = gates_that_matter(netlist, observed);
  std::mt19937_64 random(17);
  std::vector<Fault> faults;
  while (static_cast<int>(faults.size()) < count && !gates.empty())
    faults.push_back({gates[random() % gates.size()], static_cast<Fault::Kind>(random() % 5)});
  return faults;
}

bool is_redundant(const GateNetlist& netlist, const Fault& fault, const std::vector<std::uint32_t>& observed,
                  const fs::path& folder) {
  const Cone cone(netlist, fault.gate, observed);
  if (!cone.is_seen()) return true;
  const fs::path right = folder / "right.blif", wrong = folder / "wrong.blif", log = folder / "proof.log";
  cone.write(right, nullptr);
  cone.write(wrong, &fault);
  const Arguments command{"yosys-abc", "-c", fmt::format("cec -T 60 -C 1000000 {} {}", right.string(), wrong.string())};
  const int code = Process(command, log).wait();
  const std::string text = read_text(log);
  const auto says = [&](const char* words) { return text.find(words) != std::string::npos; };
  if (code != 0 || (!says("Networks are equivalent") && !says("Networks are NOT EQUIVALENT") && !says("UNDECIDED")))
    throw SynthesisError("yosys-abc cannot compare a netlist with its fault:\n" + text);
  return says("Networks are equivalent");
}

std::string fault_text(const GateNetlist& netlist, const Fault& fault) {
  static constexpr const char* kKinds[] = {"output stuck at 0", "output stuck at 1", "input stuck at 0",
                                           "input stuck at 1", "another gate"};
  std::string name;
  for (const auto& [one, net] : netlist.names) {
    if (net == netlist.gates[fault.gate].y && (name.empty() || one < name)) name = one;
  }
  if (name.empty()) name = fmt::format("gate {}", fault.gate);
  return fmt::format("{} of {}", kKinds[static_cast<std::size_t>(fault.kind)], name);
}

}  // namespace wrinkle

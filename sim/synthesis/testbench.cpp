#include "sim/synthesis/testbench.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace wrinkle {

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

Bundle::Bundle(const std::vector<NetlistPort>& all, bool is_input) {
  for (const NetlistPort& port : all) {
    if (port.is_input != is_input || port.name == "clk") continue;
    ports.push_back(port);
    nets.insert(nets.end(), port.nets.begin(), port.nets.end());
  }
}

std::string Bundle::text(const std::string& line) const {
  std::string text;
  std::size_t end = line.size();
  for (const NetlistPort& port : ports) {
    end -= port.nets.size();
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", port.name, line.substr(end, port.nets.size()));
  }
  return text;
}

std::string Bundle::name_of(std::size_t bit) const {
  for (const NetlistPort& port : ports) {
    if (bit < port.nets.size()) return fmt::format("{}[{}]", port.name, bit);
    bit -= port.nets.size();
  }
  return {};
}

namespace {

// ", .a_i(word[0 +: 8]), .b_i(word[8 +: 1])" for the ports of a bundle.
std::string connected(const Bundle& bundle, const char* to) {
  std::string text;
  std::size_t first = 0;
  for (const NetlistPort& port : bundle.ports) {
    text += fmt::format(", .{}({}[{} +: {}])", port.name, to, first, port.nets.size());
    first += port.nets.size();
  }
  return text;
}

constexpr const char* kText = R"(module wrinkle_check;
  reg clk;
  reg [{inputs}:0] word;
  reg [{inputs}:0] words [0:{clocks}-1];
  reg [{widest}:0] state [0:{states}-1];
  wire [{outputs}:0] result;
  integer i, first, file, episode;
  {top} {parameters} verilog ({connections});
  initial begin
    clk = 0;
    $readmemb("{folder}/inputs", words);
    $readmemb("{folder}/state", state);
    if (!$value$plusargs("episode=%d", episode)) $finish;
    file = $fopen("{folder}/results", "w");
    // Whatever waits for a change waits before the first one.
    #1 first = 0;
    for (i = 0; i < {clocks}; i = i + 1) begin
      word = words[i];
      if (i % episode == 0) begin
{settings}        first = first + {registers};
      end
      #1 $fdisplay(file, "%b", {{{values}result}});
      clk = 1;
      #1 clk = 0;
    end
    $fclose(file);
    $finish;
  end
endmodule
)";

}  // namespace

std::string testbench_text(const Testbench& bench, const CheckOptions& options) {
  const std::string connections = std::string(bench.has_clock ? ", .clk(clk)" : "") + connected(bench.inputs, "word") +
                                  connected(bench.outputs, "result");
  std::string parameters, settings, values;
  for (const auto& [name, value] : options.parameters)
    parameters += fmt::format("{}.{}({})", parameters.empty() ? "#(" : ", ", name, value.text);
  if (!parameters.empty()) parameters += ")";
  std::size_t widest = 1;
  for (std::size_t i = 0; i < bench.registers.size(); ++i) {
    const Register& one = bench.registers[i];
    settings += fmt::format("        verilog.{} = state[first + {}];\n", one.path, i);
    values.insert(0, fmt::format("verilog.{}, ", one.path));
    widest = std::max(widest, one.bits);
  }
  const int episodes = (bench.clocks + bench.shortest_episode - 1) / bench.shortest_episode;
  return fmt::format(
      kText, fmt::arg("inputs", std::max<std::size_t>(bench.inputs.nets.size(), 1) - 1),
      fmt::arg("outputs", bench.outputs.nets.size() - 1), fmt::arg("clocks", bench.clocks),
      fmt::arg("widest", widest - 1),
      fmt::arg("states", std::max<std::size_t>(1, bench.registers.size()) * static_cast<std::size_t>(episodes)),
      fmt::arg("registers", bench.registers.size()), fmt::arg("settings", settings), fmt::arg("values", values),
      fmt::arg("top", options.top), fmt::arg("parameters", parameters), fmt::arg("connections", connections.substr(2)),
      fmt::arg("folder", options.folder.string()));
}

}  // namespace wrinkle

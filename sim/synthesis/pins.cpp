#include "sim/synthesis/pins.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "sim/synthesis/synthesis.h"
#include "tb/process.h"

namespace wrinkle {

std::string pin_wrapper(const std::string& top, const std::filesystem::path& ports) {
  const auto json = nlohmann::json::parse(read_text(ports));
  const auto& modules = json.at("modules");
  if (!modules.contains(top)) throw SynthesisError(top + " is not in " + ports.string());

  std::string connections;
  std::size_t inputs = 0, outputs = 0;
  for (const auto& [name, port] : modules.at(top).at("ports").items()) {
    const std::size_t bits = port.at("bits").size();
    const bool is_input = port.at("direction") == "input";
    std::string to = "clk";
    if (name != "clk") {
      std::size_t& first = is_input ? inputs : outputs;
      to = fmt::format("{}[{} +: {}]", is_input ? "feed_q" : "result", first, bits);
      first += bits;
    }
    connections += fmt::format("{}\n    .{}({})", connections.empty() ? "" : ",", name, to);
  }
  if (inputs < 2 || outputs < 2) throw SynthesisError(top + " has too few ports to be wrapped");
  return fmt::format(R"(module wrinkle_pins (input clk, input serial_i, input load_i, output serial_o);
  reg  [{0}:0] feed_q;
  reg  [{1}:0] catch_q;
  wire [{1}:0] result;

  {2} inner ({3});

  assign serial_o = catch_q[0];
  always @(posedge clk) begin
    feed_q  <= {{feed_q[{4}:0], serial_i}};
    catch_q <= load_i ? result : {{1'b0, catch_q[{1}:1]}};
  end
endmodule
)",
                     inputs - 1, outputs - 1, top, connections, inputs - 2);
}

}  // namespace wrinkle

// A module with more ports than a part has pins, made to fit.
#pragma once

#include <filesystem>
#include <string>

namespace wrinkle {

// Verilog of a module `wrinkle_pins`: `top` with its inputs fed by one shift register and its outputs caught in
// another, so that four pins will do: clk, serial_i, load_i, serial_o. `ports` is a file by Yosys's write_json. Every
// path of `top` runs from flip-flop to flip-flop.
std::string pin_wrapper(const std::string& top, const std::filesystem::path& ports);

}  // namespace wrinkle

// What a netlist and its Verilog are driven with: words that reach far into arithmetic and control alike.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "sim/synthesis/gates.h"

namespace wrinkle {

struct StimulusOptions {
  std::uint64_t seed = 1;
  int clocks = 1000;
  // Each word stays so long. More than 1: nothing ever waits, so that at the end of its stay a pipeline shows it.
  int stay = 1;
  // So long stays the state of a draw.
  int draw = 64;
};

// Draws a random word, bit 0 last: a sparse, a dense or a constant one, one of a single bit, a row of small signed
// numbers, as vectors near 0 are, or the word before again.
void draw_word(std::string& word, std::mt19937_64& random);

// A line of 0 and 1 for every clock, bit 0 of the first input last; the input `clk` is left out. The input `rst` is 1
// in the first clocks and seldom again. Inputs named valid, ready, advance and shift change at random with a rate that
// is another every 64 clocks, at times that of all together, so that a deep buffer is written everywhere. All others
// are drawn.
std::vector<std::string> stimulus(const std::vector<NetlistPort>& ports, const StimulusOptions& options);

}  // namespace wrinkle

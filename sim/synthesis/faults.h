// Single faults of a netlist, to measure what the words of a check find.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/synthesis/gates.h"

namespace wrinkle {

// Faults at random of gates that `observed` or a flip-flop depends on; none of those that only name a net or a constant
// anew.
std::vector<Fault> random_faults(const GateNetlist& netlist, const std::vector<std::uint32_t>& observed, int count);

// Whether a fault changes nothing: ABC proves that every net of `observed` and the next state of every flip-flop stay
// as they are for all inputs in all states. Proofs are written to `folder`. Throws SynthesisError when ABC fails; a
// proof that takes too long is none.
bool is_redundant(const GateNetlist& netlist, const Fault& fault, const std::vector<std::uint32_t>& observed,
                  const std::filesystem::path& folder);

// "output stuck at 0 of _12_", by a name of the net that the gate drives; inside a cell it has a number only.
std::string fault_text(const GateNetlist& netlist, const Fault& fault);

}  // namespace wrinkle

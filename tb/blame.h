// From the first fragment that differs to the first stage that does.
#pragma once

#include "tb/bench.h"
#include "tb/run.h"

namespace wrinkle {

// Names the difference a run ended with. Replays its draw, and where that shows nothing the whole stream with the same
// seeds, with the wires between the stages sampled.
Difference blame(const BenchRun& run, const PacketStream& stream, std::string_view frame_name);

}  // namespace wrinkle

// Random packets straight from their format [docs/formats.md], reproducible from a seed: every field takes the ends of
// its width, and what set-up never sends is among them.
#pragma once

#include <cstdint>
#include <vector>

#include "golden/config/config.h"
#include "golden/texel/texture.h"
#include "golden/triangle/packet.h"

namespace wrinkle {

struct RandomPackets {
  std::uint64_t seed = 1;
  double fragments = 4000;  // about as many; no bound
  int draws = 24;
};

// As many textures as a draw can name, all small but for some of 4096 texels one way. None where the configuration
// reads no texels.
std::vector<Texture> random_textures(const Config& config, std::uint64_t seed);

// Rows of any length and packets without a pixel; edges that carry at every row or never, with denominators of every
// width; planes of any residue; texture coordinates, levels and reciprocals out of range.
PacketStream random_packets(const Config& config, const std::vector<Texture>& textures, const RandomPackets& wish);

}  // namespace wrinkle

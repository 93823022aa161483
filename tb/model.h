// The Verilated core behind plain pins, so that the bench is built once and a model is loaded per configuration.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace wrinkle {

// The top-level pins of wrinkle_core, none wider than 64 bits. Texel port b is used only with a trilinear filter.
struct Pins {
  // in
  std::uint8_t rst = 0;
  std::uint8_t packet_valid = 0;
  std::uint64_t packet_word = 0;
  std::uint8_t texel_request_ready = 0;
  std::uint8_t texel_response_valid = 0;
  std::uint64_t texel_response_a[4] = {}, texel_response_b[4] = {};
  std::uint8_t fragment_ready = 0;
  // out
  std::uint8_t packet_ready = 0;
  std::uint8_t texel_request_valid = 0;
  std::uint64_t texel_request_a = 0, texel_request_b = 0;
  std::uint8_t texel_response_ready = 0;
  std::uint8_t fragment_valid = 0;
  std::uint32_t fragment_x = 0, fragment_y = 0, fragment_z = 0;
  std::uint64_t fragment_colour = 0;
  std::uint8_t fragment_last = 0, fragment_zero = 0;
  std::uint8_t idle = 0;  // no packet held, no fragment in flight
};

}  // namespace wrinkle

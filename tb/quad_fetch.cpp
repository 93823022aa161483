#include "tb/quad_fetch.h"

#include <cstring>
#include <stdexcept>

namespace wrinkle {

QuadFetch::QuadFetch(const sc_core::sc_module_name& name, const TextureMemory& directory)
    : sc_module(name), socket("socket"), directory_(directory), responses_(kWaiting) {
  socket.register_invalidate_direct_mem_ptr(this, &QuadFetch::invalidate);
}

void QuadFetch::start(const Run& run) {
  head_ = tail_ = last_due_ = 0;
  latency_ = LatencySource(run.options->stalls, run.options->latency, run.options->seed * 8 + 5);
  trilinear_ = run.config->trilinear();
  tlm::tlm_generic_payload probe;
  probe.set_command(tlm::TLM_READ_COMMAND);
  probe.set_address(0);
  tlm::tlm_dmi dmi;
  direct_ = socket->get_direct_mem_ptr(probe, dmi) && dmi.is_read_allowed() ? dmi.get_dmi_ptr() : nullptr;
}

void QuadFetch::invalidate(sc_dt::uint64, sc_dt::uint64) { direct_ = nullptr; }

std::uint64_t QuadFetch::read_word(std::uint64_t address) {
  std::uint64_t word = 0;
  if (direct_ != nullptr) {
    std::memcpy(&word, direct_ + address, sizeof word);
    return word;
  }
  tlm::tlm_generic_payload read;
  sc_core::sc_time delay;
  read.set_command(tlm::TLM_READ_COMMAND);
  read.set_address(address);
  read.set_data_ptr(reinterpret_cast<unsigned char*>(&word));
  read.set_data_length(sizeof word);
  read.set_streaming_width(sizeof word);
  read.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
  socket->b_transport(read, delay);
  if (read.is_response_error()) throw std::runtime_error("texture memory: " + read.get_response_string());
  return word;
}

// Fields of the request as in docs/formats.md.
bool QuadFetch::read_quad(std::uint64_t request, Quad& quad) {
  const auto field = [request](int low, int width) {
    return static_cast<std::uint32_t>(request >> low) & ((1U << width) - 1);
  };
  const std::uint32_t x[2] = {field(0, 12), field(12, 12)}, y[2] = {field(24, 12), field(36, 12)};
  const TextureMemory::Level* level = directory_.level(field(52, 12), field(48, 4));
  quad = {};
  if (level == nullptr) return false;
  bool legal = true;
  for (unsigned i = 0; i < 4; ++i) {
    const std::uint32_t column = x[i & 1], row = y[i >> 1];
    if (column >= level->width || row >= level->height) {
      legal = false;
      continue;
    }
    quad[i] = read_word(level->base + sizeof(std::uint64_t) * (std::uint64_t{row} * level->width + column));
  }
  return legal;
}

}  // namespace wrinkle

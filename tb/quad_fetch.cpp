#include "tb/quad_fetch.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace wrinkle {

QuadFetch::QuadFetch(const sc_core::sc_module_name& name, const TexelStore& directory)
    : sc_module(name), socket("socket"), directory_(directory), due_(kWaiting) {
  socket.register_invalidate_direct_mem_ptr(this, &QuadFetch::invalidate);
}

void QuadFetch::start(const BenchRun& run) {
  head_ = tail_ = last_due_ = 0;
  latency_ = LatencySource(run.options->stalls, run.options->latency, run.options->seed * 8 + 5);
  trilinear_ = Shape(*run.config).trilinear != 0;
  texel_words_ = directory_.texel_words();
  response_words_ = 2 * kQuad * texel_words_;
  texels_.assign(kWaiting * response_words_, 0);
  tlm::tlm_generic_payload probe;
  probe.set_command(tlm::TLM_READ_COMMAND);
  probe.set_address(0);
  tlm::tlm_dmi dmi;
  direct_ = socket->get_direct_mem_ptr(probe, dmi) && dmi.is_read_allowed() ? dmi.get_dmi_ptr() : nullptr;
}

void QuadFetch::invalidate(sc_dt::uint64, sc_dt::uint64) { direct_ = nullptr; }

void QuadFetch::transact(std::uint64_t address, std::uint64_t* texel) {
  const auto length = static_cast<unsigned>(texel_words_ * sizeof *texel);
  tlm::tlm_generic_payload read;
  sc_core::sc_time delay;
  read.set_command(tlm::TLM_READ_COMMAND);
  read.set_address(address);
  read.set_data_ptr(reinterpret_cast<unsigned char*>(texel));
  read.set_data_length(length);
  read.set_streaming_width(length);
  read.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
  socket->b_transport(read, delay);
  if (read.is_response_error()) throw std::runtime_error("texture memory: " + read.get_response_string());
}

// Fields of the request as in docs/formats.md.
template <std::size_t known>
bool QuadFetch::read_quad(std::uint64_t request, std::uint64_t* quad) {
  const std::size_t words = known != kAnyNumber ? known : texel_words_;
  const auto field = [request](int low, int width) {
    return static_cast<std::uint32_t>(request >> low) & ((1U << width) - 1);
  };
  const std::uint32_t x[2] = {field(0, 12), field(12, 12)}, y[2] = {field(24, 12), field(36, 12)};
  const TexelStore::Level* level = directory_.level(field(52, 12), field(48, 4));
  if (level == nullptr) {
    std::fill_n(quad, kQuad * words, 0);
    return false;
  }
  const std::uint64_t texel_bytes = sizeof *quad * words;
  const std::uint64_t rows[2] = {level->base + texel_bytes * level->width * y[0],
                                 level->base + texel_bytes * level->width * y[1]};
  const bool legal = x[0] < level->width && x[1] < level->width && y[0] < level->height && y[1] < level->height;
  for (std::size_t i = 0; i < kQuad; ++i) {
    std::uint64_t* const texel = quad + i * words;
    const std::uint64_t address = rows[i >> 1] + texel_bytes * x[i & 1];
    if (!legal && (x[i & 1] >= level->width || y[i >> 1] >= level->height))
      std::fill_n(texel, words, 0);
    else if (direct_ != nullptr)
      std::memcpy(texel, direct_ + address, words * sizeof *texel);
    else
      transact(address, texel);
  }
  return legal;
}

template <std::size_t known>
bool QuadFetch::read_quads(std::uint64_t a, std::uint64_t b, std::uint64_t* texels) {
  const bool legal = read_quad<known>(a, texels);
  return (!trilinear_ || read_quad<known>(b, texels + kQuad * texel_words_)) && legal;
}
template bool QuadFetch::read_quads<1>(std::uint64_t, std::uint64_t, std::uint64_t*);
template bool QuadFetch::read_quads<kAnyNumber>(std::uint64_t, std::uint64_t, std::uint64_t*);

}  // namespace wrinkle

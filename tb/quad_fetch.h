// The quad-fetch port adapter: turns the core's texel requests into reads of the texture memory, and answers them in
// order after a random latency.
#pragma once

#include <tlm_utils/simple_initiator_socket.h>

#include <array>
#include <systemc>

#include "tb/run.h"
#include "tb/stall.h"
#include "tb/texture_memory.h"

namespace wrinkle {

// Four texels of a level: (x0,y0) (x1,y0) (x0,y1) (x1,y1).
using Quad = std::array<std::uint64_t, 4>;

// Called by the core once a clock, through a port bound to the class itself so that calls need no table.
class QuadFetch final : public sc_core::sc_module, virtual public sc_core::sc_interface {
 public:
  tlm_utils::simple_initiator_socket<QuadFetch> socket;

  struct Response {
    Quad a, b;  // b: trilinear
    std::uint64_t due;
  };

  QuadFetch(const sc_core::sc_module_name& name, const TextureMemory& directory);

  // Begins a run, after the memory is loaded.
  void start(const Run& run);

  // Takes a request of the clock `now`. False for a texel that is in no texture; it reads as 0.
  bool request(std::uint64_t a, std::uint64_t b, std::uint64_t now) {
    if (tail_ - head_ == kWaiting) return false;
    Response& entry = responses_[tail_ % kWaiting];
    bool legal = read_quad(a, entry.a);
    if (trilinear_) legal = read_quad(b, entry.b) && legal;
    // In order: none is due before the one ahead of it.
    last_due_ = std::max(last_due_, now + 1 + latency_.next());
    entry.due = last_due_;
    ++tail_;
    return legal;
  }

  // The oldest response, null while it is not due.
  const Response* response(std::uint64_t now) const {
    if (head_ == tail_) return nullptr;
    const Response& entry = responses_[head_ % kWaiting];
    return entry.due <= now ? &entry : nullptr;
  }
  void pop() { ++head_; }
  bool empty() const { return head_ == tail_; }

 private:
  // More than the core can have in flight.
  static constexpr std::uint64_t kWaiting = 1024;

  bool read_quad(std::uint64_t request, Quad& quad);
  std::uint64_t read_word(std::uint64_t address);
  void invalidate(sc_dt::uint64 first, sc_dt::uint64 last);

  const TextureMemory& directory_;
  std::vector<Response> responses_;
  std::uint64_t head_ = 0, tail_ = 0, last_due_ = 0;
  LatencySource latency_{StallProfile::kNone, 0, 0};
  bool trilinear_ = false;
  const unsigned char* direct_ = nullptr;  // null: every read is a transaction
};

}  // namespace wrinkle

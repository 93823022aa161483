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

// In the place of a number of words that is not known to the compiler.
inline constexpr std::size_t kAnyNumber = 0;

// Called by the core once a clock, through a port bound to the class itself so that calls need no table.
class QuadFetch final : public sc_core::sc_module, virtual public sc_core::sc_interface {
 public:
  tlm_utils::simple_initiator_socket<QuadFetch> socket;

  QuadFetch(const sc_core::sc_module_name& name, const TexelStore& directory);

  // Begins a run, after the memory is loaded.
  void start(const BenchRun& run);

  // Takes a request of the clock `now`. False for a texel that is in no texture; it reads as 0.
  bool request(std::uint64_t a, std::uint64_t b, std::uint64_t now) {
    if (tail_ - head_ == kWaiting) return false;
    std::uint64_t* const texels = texels_of(tail_);
    const bool legal = texel_words_ == 1 ? read_quads<1>(a, b, texels) : read_quads<kAnyNumber>(a, b, texels);
    // In order: none is due before the one ahead of it.
    last_due_ = std::max(last_due_, now + 1 + latency_.next());
    due_[tail_ % kWaiting] = last_due_;
    ++tail_;
    return legal;
  }

  // Whether the oldest response is due.
  bool is_due(std::uint64_t now) const { return head_ != tail_ && due_[head_ % kWaiting] <= now; }
  // Texels of the oldest response: (x0,y0) (x1,y0) (x0,y1) (x1,y1) of a, then of b, texel_words() words each.
  const std::uint64_t* texels() { return texels_of(head_); }
  std::size_t texel_words() const { return texel_words_; }
  void pop() { ++head_; }
  bool empty() const { return head_ == tail_; }

 private:
  // More than the core can have in flight.
  static constexpr std::uint64_t kWaiting = 1024;

  static constexpr std::size_t kQuad = 4;

  std::uint64_t* texels_of(std::uint64_t request) { return texels_.data() + request % kWaiting * response_words_; }
  // `known`: words of a texel, so that the common one costs no loops.
  template <std::size_t known>
  bool read_quads(std::uint64_t a, std::uint64_t b, std::uint64_t* texels);
  template <std::size_t known>
  bool read_quad(std::uint64_t request, std::uint64_t* quad);
  void transact(std::uint64_t address, std::uint64_t* texel);
  void invalidate(sc_dt::uint64 first, sc_dt::uint64 last);

  const TexelStore& directory_;
  std::size_t texel_words_ = 1, response_words_ = 2 * kQuad;
  std::vector<std::uint64_t> due_, texels_;
  std::uint64_t head_ = 0, tail_ = 0, last_due_ = 0;
  LatencySource latency_{StallProfile::kNone, 0, 0};
  bool trilinear_ = false;
  const unsigned char* direct_ = nullptr;  // null: every read is a transaction
};

}  // namespace wrinkle

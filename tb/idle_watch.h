// Watches the status port of the core: idle_o is high only while it holds no packet and no fragment is in flight.
#pragma once

#include <cstdint>

#include "golden/config/config.h"
#include "golden/triangle/packet.h"

namespace wrinkle {

class IdleWatch {
 public:
  explicit IdleWatch(const Config& config)
      : triangle_words_(triangle_word_count(config)), draw_words_(Shape(config).draw_words) {}

  // One clock: `moving` says that a texel is asked for or awaited, or that a fragment is put out. False where the port
  // is or has been high though a packet is held in part, or though something that came of a whole one still moves.
  bool good(bool idle, bool moving, bool word_taken, std::uint64_t word) {
    // Most clocks of a drawn triangle.
    if (!idle && !word_taken && !was_idle_) return true;
    was_idle_ |= idle;
    const bool is_wrong = (idle && words_left_ > 0) || (moving && was_idle_);
    if (word_taken) {
      if (words_left_ == 0) words_left_ = (word & 15) == kOpcodeTriangle ? triangle_words_ : draw_words_;
      --words_left_;
    }
    if (word_taken || is_wrong) was_idle_ = false;
    return !is_wrong;
  }

 private:
  int triangle_words_, draw_words_;
  int words_left_ = 0;     // of the packet that is held in part
  bool was_idle_ = false;  // since the last word
};

}  // namespace wrinkle

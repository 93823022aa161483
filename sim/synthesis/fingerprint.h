// A key of 128 bits for texts.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace wrinkle {

// FNV-1a; two of them from different starts make a key of 128 bits.
class Fingerprint {
 public:
  void add(std::string_view text) {
    for (const char c : text) step(static_cast<unsigned char>(c));
    step(text.size());
  }
  std::string hex() const { return fmt::format("{:016x}{:016x}", a_, b_); }

 private:
  void step(std::uint64_t value) {
    a_ = (a_ ^ value) * 0x100000001b3;
    b_ = (b_ ^ value) * 0x10000000233;
  }
  std::uint64_t a_ = 0xcbf29ce484222325, b_ = 0x84222325cbf29ce4;
};

}  // namespace wrinkle

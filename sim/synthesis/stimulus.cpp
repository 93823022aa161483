#include "sim/synthesis/stimulus.h"

#include <algorithm>
#include <random>

namespace wrinkle {
namespace {

constexpr int kEpisode = 64;
// The first reset, in which everything is handed on: what can be known afterwards is known.
constexpr int kFirstReset = 40;

bool is_handshake(const std::string& name) {
  for (const char* word : {"valid", "ready", "advance", "shift"}) {
    if (name.find(word) != std::string::npos) return true;
  }
  return false;
}

class Driver {
 public:
  Driver(const NetlistPort& port, const StimulusOptions& options)
      : name_(port.name), bits_(port.nets.size()), options_(options), word_(bits_, '0') {}

  // The word of this clock, bit 0 last.
  const std::string& next(int clock, std::mt19937_64& random) {
    if (clock % kEpisode == 0) rate_ = 1 + random() % 4;
    if (name_ == "rst") {
      word_[0] = clock < kFirstReset || (options_.stay == 1 && random() % 400 == 0) ? '1' : '0';
    } else if (is_handshake(name_)) {
      for (char& bit : word_) bit = options_.stay > 1 || clock < kFirstReset || random() % 4 < rate_ ? '1' : '0';
    } else if (name_.starts_with("draw_") ? clock % kEpisode == 0 : clock % options_.stay == 0) {
      draw(random);
    }
    return word_;
  }

 private:
  void draw(std::mt19937_64& random) {
    const std::uint64_t kind = random() % 16;
    if (kind == 0) return;  // the word before again
    if (kind == 1) return fill([&, bit = random() % 2 != 0](std::size_t) { return bit; });
    if (kind == 2) return fill([one = random() % bits_](std::size_t i) { return i == one; });
    if (kind <= 4) return fill([&](std::size_t) { return random() % 8 == 0; });
    if (kind <= 6) return fill([&](std::size_t) { return random() % 8 != 0; });
    if (kind <= 10) return small_numbers(random);
    fill([&](std::size_t) { return random() % 2 != 0; });
  }

  // As many equal fields as a vector or a texel has, each with a number of few bits, its sign repeated.
  void small_numbers(std::mt19937_64& random) {
    static constexpr std::size_t kFields[] = {3, 3, 3, 1, 2, 4, 6, 9};
    const std::size_t fields = kFields[random() % std::size(kFields)];
    const std::size_t width = std::max<std::size_t>(1, bits_ % fields == 0 ? bits_ / fields : bits_);
    const std::size_t kept = random() % width;
    bool sign = false;
    fill([&](std::size_t i) {
      if (i % width <= kept) sign = random() % 2 != 0;
      return sign;
    });
  }

  template <typename Bit>
  void fill(Bit bit) {
    for (std::size_t i = 0; i < bits_; ++i) word_[bits_ - 1 - i] = bit(i) ? '1' : '0';
  }

  std::string name_;
  std::size_t bits_;
  StimulusOptions options_;
  std::string word_;
  std::uint64_t rate_ = 4;
};

}  // namespace

std::vector<std::string> stimulus(const std::vector<NetlistPort>& ports, const StimulusOptions& options) {
  std::mt19937_64 random(options.seed);
  std::vector<Driver> drivers;
  for (const NetlistPort& port : ports) {
    if (port.is_input && port.name != "clk") drivers.emplace_back(port, options);
  }
  std::vector<std::string> lines;
  for (int clock = 0; clock < options.clocks; ++clock) {
    std::string line;
    for (Driver& driver : drivers) line.insert(0, driver.next(clock, random));
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace wrinkle

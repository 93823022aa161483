#include "sim/synthesis/stimulus.h"

#include <algorithm>
#include <random>

namespace wrinkle {
namespace {

constexpr int kEpisode = 64;
constexpr int kFirstReset = 4;
// Of a handshake, in quarters: at 0 buffers fill or drain.
constexpr std::uint64_t kRates[] = {0, 1, 2, 3, 4, 4};

bool is_handshake(const std::string& name) {
  for (const char* word : {"valid", "ready", "advance", "shift"}) {
    if (name.find(word) != std::string::npos) return true;
  }
  return false;
}

template <typename Bit>
void fill(std::string& word, Bit bit) {
  for (std::size_t i = 0; i < word.size(); ++i) word[word.size() - 1 - i] = bit(i) ? '1' : '0';
}

// As many equal fields as a vector or a texel has; the width of one.
std::size_t draw_field_width(std::size_t bits, std::mt19937_64& random) {
  static constexpr std::size_t kFields[] = {3, 3, 3, 1, 1, 2, 4, 6, 9};
  const std::size_t fields = kFields[random() % std::size(kFields)];
  return bits % fields == 0 ? bits / fields : bits;
}

// Numbers of few bits, their sign repeated.
void draw_small_numbers(std::string& word, std::mt19937_64& random) {
  const std::size_t width = draw_field_width(word.size(), random), kept = random() % width;
  bool sign = false;
  fill(word, [&](std::size_t i) {
    if (i % width <= kept) sign = random() % 2 != 0;
    return sign;
  });
}

// Numbers at the ends of their ranges: 0, the greatest and the least with a sign or without, one, and some between.
void draw_extremes(std::string& word, std::mt19937_64& random) {
  const std::size_t width = draw_field_width(word.size(), random);
  bool low = false, high = false, is_random = false;
  fill(word, [&](std::size_t i) {
    if (i % width == 0) {
      const std::uint64_t kind = random() % 8;
      low = (kind & 1) != 0;
      high = (kind & 2) != 0;
      is_random = kind >= 6;
    }
    if (is_random) return random() % 2 != 0;
    return i % width == width - 1 ? high : low;
  });
}

class Driver {
 public:
  Driver(const NetlistPort& port, const StimulusOptions& options)
      : name_(port.name), bits_(port.nets.size()), options_(options), word_(bits_, '0') {}

  // The word of this clock, bit 0 last.
  const std::string& next(int clock, bool flows, std::mt19937_64& random) {
    if (clock % kEpisode == 0) rate_ = flows ? 4 : kRates[random() % std::size(kRates)];
    if (name_ == "rst") {
      word_[0] = clock < kFirstReset || (options_.stay == 1 && random() % 400 == 0) ? '1' : '0';
    } else if (is_handshake(name_)) {
      for (char& bit : word_) bit = options_.stay > 1 || clock < kFirstReset || random() % 4 < rate_ ? '1' : '0';
    } else if (name_.starts_with("draw_") ? clock % options_.draw == 0 : clock % options_.stay == 0) {
      draw_word(word_, random);
    }
    return word_;
  }

 private:
  std::string name_;
  std::size_t bits_;
  StimulusOptions options_;
  std::string word_;
  std::uint64_t rate_ = 4;
};

}  // namespace

void draw_word(std::string& word, std::mt19937_64& random) {
  const std::uint64_t kind = random() % 16;
  if (kind == 0) return;  // the word before again
  if (kind == 1) return fill(word, [&, bit = random() % 2 != 0](std::size_t) { return bit; });
  if (kind == 2) return fill(word, [one = random() % word.size()](std::size_t i) { return i == one; });
  if (kind <= 4) return fill(word, [&](std::size_t) { return random() % 8 == 0; });
  if (kind == 5) return fill(word, [&](std::size_t) { return random() % 8 != 0; });
  if (kind == 6) return fill(word, [&, bit = false](std::size_t) mutable { return bit ^= random() % 8 == 0; });
  if (kind <= 8) return draw_small_numbers(word, random);
  if (kind <= 11) return draw_extremes(word, random);
  fill(word, [&](std::size_t) { return random() % 2 != 0; });
}

std::vector<std::string> stimulus(const std::vector<NetlistPort>& ports, const StimulusOptions& options) {
  std::mt19937_64 random(options.seed);
  std::vector<Driver> drivers;
  for (const NetlistPort& port : ports) {
    if (port.is_input && port.name != "clk") drivers.emplace_back(port, options);
  }
  std::vector<std::string> lines;
  bool flows = false;
  for (int clock = 0; clock < options.clocks; ++clock) {
    if (clock % kEpisode == 0) flows = random() % 3 == 0;
    std::string line;
    for (Driver& driver : drivers) line.insert(0, driver.next(clock, flows, random));
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace wrinkle

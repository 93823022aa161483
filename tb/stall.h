// Random stalls and latencies, reproducible from a seed and as cheap as a decrement in the common case.
#pragma once

#include <cstdint>

namespace wrinkle {

// Small and fast generator (splitmix64).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  // Uniform in [0, bound), bound below 2^32.
  std::uint32_t below(std::uint32_t bound) {
    return static_cast<std::uint32_t>(((next() >> 32) * std::uint64_t{bound}) >> 32);
  }
  // Uniform in [low, high].
  int between(int low, int high) { return low + static_cast<int>(below(static_cast<std::uint32_t>(high - low + 1))); }
  // Uniform in [0, 1).
  double real() { return static_cast<double>(next() >> 11) * 0x1p-53; }

 private:
  std::uint64_t state_;
};

enum class StallProfile {
  kNone,     // never
  kRandom,   // each clock by itself, with a probability drawn from the seed
  kBursty,   // runs of up to 64 clocks, open and stalled
  kExtreme,  // open for hundreds of clocks, then closed for ten thousand
};

inline constexpr int kExtremeStall = 10000;

// Whether one stream stalls in a clock.
class StallSource {
 public:
  StallSource(StallProfile profile, std::uint64_t seed) : profile_(profile), random_(seed) {
    constexpr std::uint32_t kPercent[] = {5, 25, 50, 80};
    percent_ = kPercent[random_.below(4)];
    stalled_ = profile != StallProfile::kNone && random_.below(2) == 0;
  }

  bool stalled() {
    if (profile_ == StallProfile::kNone) return false;
    if (left_ == 0) next_run();
    --left_;
    return stalled_;
  }

 private:
  void next_run() {
    switch (profile_) {
      case StallProfile::kNone:
        break;
      case StallProfile::kRandom:
        left_ = 1;
        stalled_ = random_.below(100) < percent_;
        break;
      case StallProfile::kBursty:
        left_ = 1 + random_.below(64);
        stalled_ = !stalled_;
        break;
      case StallProfile::kExtreme:
        stalled_ = !stalled_;
        left_ = stalled_ ? kExtremeStall : 200 + random_.below(5000);
        break;
    }
  }

  StallProfile profile_;
  Random random_;
  std::uint32_t percent_;
  std::uint64_t left_ = 0;
  bool stalled_ = false;
};

// Clocks from a texel request to its response, drawn per request.
class LatencySource {
 public:
  // Uniform in [0, largest]; with kExtreme 0, and now and then ten thousand.
  LatencySource(StallProfile profile, int largest, std::uint64_t seed)
      : extreme_(profile == StallProfile::kExtreme), bound_(static_cast<std::uint32_t>(largest) + 1), random_(seed) {}

  std::uint64_t next() {
    if (extreme_) return random_.below(1024) == 0 ? kExtremeStall : 0;
    return bound_ == 1 ? 0 : random_.below(bound_);
  }

 private:
  bool extreme_;
  std::uint32_t bound_;
  Random random_;
};

}  // namespace wrinkle

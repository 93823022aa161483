// wrinkle_unit_vector alone, Verilated, a vector a clock, against the golden model and against real arithmetic.
//   normalizer                 extremes, all axes, and random vectors of all lengths
//   normalizer --exhaustive    every triple of magnitudes, largest first, with random signs and order
// KIND (Config::normalizer_n), UNIT_BITS and VECTOR_BITS are macros. Exit 1 at any difference, or at an error of 1 ulp
// by any kind but `lite`.
#include <verilated.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <string_view>
#include <type_traits>
#include <vector>

#include "Vwrinkle_unit_vector.h"
#include "golden/pixel/context.h"
#include "golden/pixel/stages.h"

namespace wrinkle {
namespace {

using Vector = std::array<std::int64_t, 3>;

constexpr int kRanks = 5;
constexpr std::int64_t kLimit = std::int64_t{2} << VECTOR_BITS;

// Three fields of `bits` bits, packed from bit 0, in a port of any width.
template <class Port>
void put(Port& port, const Vector& v, int bits) {
  if constexpr (std::is_integral_v<Port>) {
    port = 0;
    for (int k = 0; k < 3; ++k)
      port |= static_cast<Port>((static_cast<std::uint64_t>(v[k]) & ((1ull << bits) - 1)) << (k * bits));
  } else {
    for (std::size_t word = 0; word < sizeof(port) / sizeof(port[0]); ++word) port[word] = 0;
    for (int k = 0; k < 3; ++k)
      for (int b = 0; b < bits; ++b)
        port[(k * bits + b) / 32] |= static_cast<std::uint32_t>((v[k] >> b) & 1) << ((k * bits + b) % 32);
  }
}

template <class Port>
std::int64_t field(const Port& port, int k, int bits) {
  std::int64_t value = 0;
  for (int b = 0; b < bits; ++b) {
    std::int64_t bit;
    if constexpr (std::is_integral_v<Port>)
      bit = (port >> (k * bits + b)) & 1;
    else
      bit = (port[(k * bits + b) / 32] >> ((k * bits + b) % 32)) & 1;
    value |= bit << b;
  }
  return value - (((value >> (bits - 1)) & 1) << bits);
}

class Check {
 public:
  Check() {
    Config config;
    config.unit_bits = UNIT_BITS;
    config.vector_bits = VECTOR_BITS;
    config.normalizer_n = KIND;
    config.dot_bits = 6;
    context_ = make_context(config);
    unit_.clk = 0;
    unit_.advance_i = 1;
    unit_.eval();
  }

  void see(const Vector& v) {
    pending_.push_back(v);
    if (pending_.size() == kBatch) flush();
  }

  void flush() {
    const int count = static_cast<int>(pending_.size());
    batch_->count = count;
    for (std::size_t i = 0; i < pending_.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) batch_->perturb_n[k][i] = pending_[i][k];
    run_simd(context_, kNormalize, *spans_, *batch_);
    for (int i = 0; i < count + kRanks; ++i) {
      if (i < count) put(unit_.vector_i, pending_[static_cast<std::size_t>(i)], VECTOR_BITS + 2);
      if (i >= kRanks) compare(pending_[static_cast<std::size_t>(i - kRanks)], static_cast<std::size_t>(i - kRanks));
      clock();
    }
    pending_.clear();
  }

  int report() const {
    std::printf("kind %d, F %d, V %d: %lld vectors, %lld differ from the golden model, worst error %.4f ulp\n", KIND,
                UNIT_BITS, VECTOR_BITS, count_, different_, worst_);
    return different_ == 0 && (KIND == 3 || worst_ < 1) ? 0 : 1;
  }

 private:
  void clock() {
    for (const int level : {1, 0}) {
      unit_.clk = static_cast<CData>(level);
      unit_.eval();
    }
  }

  void compare(const Vector& v, std::size_t i) {
    ++count_;
    for (int k = 0; k < 3; ++k) {
      const std::int64_t n = field(unit_.unit_o, k, UNIT_BITS + 2), golden = batch_->normalize_n[k][i];
      if (n != golden && ++different_ <= 10)
        std::printf("(%lld, %lld, %lld)[%d]: %lld, golden %lld\n", static_cast<long long>(v[0]),
                    static_cast<long long>(v[1]), static_cast<long long>(v[2]), k, static_cast<long long>(n),
                    static_cast<long long>(golden));
      see_error(v, k, n);
    }
    if ((unit_.zero_o != 0) != (v == Vector{})) ++different_;
  }

  // -2^(V+1) has no magnitude of V + 1 bits, and `near` promises nothing about other lengths.
  void see_error(const Vector& v, int k, std::int64_t n) {
    const double length = std::hypot(v[0], v[1], v[2]), one = static_cast<double>(kLimit) / 2;
    if (length == 0 || std::min({v[0], v[1], v[2]}) == -kLimit) return;
    if (KIND == 4 && (length < one / 2 || length > one)) return;
    worst_ =
        std::max(worst_, std::abs(static_cast<double>(n) - std::ldexp(static_cast<double>(v[k]) / length, UNIT_BITS)));
  }

  Context context_;
  std::unique_ptr<Batch<std::int64_t>> batch_ = std::make_unique<Batch<std::int64_t>>(context_.config);
  std::unique_ptr<Spans<std::int64_t>> spans_ = std::make_unique<Spans<std::int64_t>>();
  std::vector<Vector> pending_;
  Vwrinkle_unit_vector unit_;
  long long count_ = 0, different_ = 0;
  double worst_ = 0;
};

void exhaustive(Check& check) {
  std::minstd_rand random(1997);
  for (std::int64_t x = 0; x < kLimit; ++x)
    for (std::int64_t y = 0; y <= x; ++y)
      for (std::int64_t z = 0; z <= y; ++z) {
        Vector v{x, y, z};
        const auto bits = static_cast<unsigned>(random() >> 8);
        for (unsigned k = 0; k < 3; ++k)
          if ((bits >> k & 1) != 0) v[k] = -v[k];
        std::swap(v[0], v[(bits >> 3) % 3]);
        std::swap(v[1], v[1 + (bits >> 7) % 2]);
        check.see(v);
      }
}

void sampled(Check& check) {
  std::vector<std::int64_t> ends{0};
  const int step = VECTOR_BITS / 8 + 1;
  for (int bit = (VECTOR_BITS + 1) % step; bit <= VECTOR_BITS + 1; bit += step)
    for (std::int64_t d = -1; d <= 1; ++d) {
      const std::int64_t c = (std::int64_t{1} << bit) + d;
      if (c < kLimit) ends.push_back(c);
      ends.push_back(-c < -kLimit ? -kLimit : -c);
    }
  for (std::int64_t x : ends)
    for (std::int64_t y : ends)
      for (std::int64_t z : ends) check.see({x, y, z});
  for (std::int64_t c = 1; c < kLimit; c += 1 + c / 512) {
    check.see({c, 0, 0});
    check.see({0, -c, 0});
    check.see({0, 0, c});
  }
  std::mt19937_64 random(1997);
  std::uniform_int_distribution<std::int64_t> component(-kLimit, kLimit - 1);
  for (int i = 0; i < 100000; ++i) {
    const int shift = i % 2 == 0 ? 0 : i / 2 % (VECTOR_BITS + 1);
    check.see({component(random) >> shift, component(random) >> shift, component(random) >> shift});
  }
}

}  // namespace
}  // namespace wrinkle

int main(int argc, char** argv) {
  wrinkle::Check check;
  if (argc > 1 && std::string_view(argv[1]) == "--exhaustive")
    wrinkle::exhaustive(check);
  else
    wrinkle::sampled(check);
  check.flush();
  return check.report();
}

// The golden model of the hardware: packet words in, every stage's values out, bit for bit.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "golden/config/values.h"
#include "golden/texel/texture.h"
#include "golden/triangle/packet.h"

namespace wrinkle {

// Fragments of a batch, which never spans two draws.
inline constexpr int kBatch = 256;
// A vector that begins inside a column may run over its end by so much.
inline constexpr int kBatchPadding = 16;

// One element of a value, by fragment.
template <class Int>
struct alignas(64) Column : std::array<Int, kBatch + kBatchPadding> {};
// The elements of a value.
template <class Int>
using Columns = std::span<Column<Int>>;

// Fragments in structure-of-arrays form: STAGE_NAME[element][fragment] for every value of values.def, as signed
// integers in that value's format; no elements where the configuration lacks the value. The vectors in the place of N
// lie in interpolate_frame, the first in elements 0 to 2. Int is std::int32_t or std::int64_t, as lane_bits() says.
template <class Int>
struct Batch {
  explicit Batch(const Shape& config);
  Batch(const Batch&) = delete;
  Batch& operator=(const Batch&) = delete;

  int count = 0;
  std::array<std::uint32_t, kBatch> packet;  // index of the triangle packet, counted over the stream
#define WRINKLE_VALUE(stage, name, elements, width, fraction_bits, is_signed, present, kind) \
  Columns<Int> stage##_##name;
#define WRINKLE_FRAME(stage, name, reader) Columns<Int> stage##_##name;
#define WRINKLE_BUMP(stage, name) Columns<Int> stage##_##name;
#include "golden/values.def"
  std::vector<Columns<Int>> value;  // of each value of values(config)

 private:
  std::vector<Column<Int>> columns_;
};

// One fragment's values: value_of[i][element], i as in values(). The common currency of golden, RTL taps and printers.
using FragmentValues = std::vector<std::array<std::int64_t, kMaxElements>>;
template <class Int>
void extract(const Batch<Int>& batch, int index, FragmentValues& out);

// Element of a value for all fragments of a batch; `value` as in values().
template <class Int>
const Int* column(const Batch<Int>& batch, std::size_t value, std::size_t element) {
  return batch.value[value][element].data();
}

// What leaves the hardware.
struct Fragment {
  std::int32_t x = 0, y = 0;
  std::uint32_t z = 0;
  std::array<std::uint16_t, 3> colour{};
  bool last = false, zero = false;
  bool operator==(const Fragment&) const = default;
};
template <class Int>
Fragment fragment(const Batch<Int>& batch, int index);

// Which instance of the one source shades the lanes. kChecked is kScalar, throwing std::logic_error where an operation
// leaves the lane that lane_bits() promises to be wide enough; in a debug build kScalar is kChecked.
enum class Lanes { kScalar, kSimd, kChecked };
// Name of the instruction set that kSimd uses on this machine, as Highway names it ("AVX3_ZEN4", "AVX2" ...).
std::string_view simd_target();

// A golden machine: draw state and textures bound, packets in, batches out. Value type; no global state.
class Golden {
 public:
  // The textures must outlive it.
  Golden(const Shape& config, const std::vector<Texture>& textures, Lanes lanes = Lanes::kSimd);
  ~Golden();
  Golden(Golden&&) noexcept;
  Golden& operator=(Golden&&) noexcept;

  // Called with each full or final batch, in order. Which of the two is decided by lane_bits(config); scalar and
  // checked are wide.
  struct Sink {
    std::function<void(const Batch<std::int32_t>&)> narrow;
    std::function<void(const Batch<std::int64_t>&)> wide;
  };
  // Draws all packets of the stream; words are whole packets. Batches are flushed at a draw packet and at the end.
  void draw(std::span<const std::uint64_t> words, const Sink& sink);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace wrinkle

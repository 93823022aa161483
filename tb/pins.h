// The ports of wrinkle_core as plain numbers, from golden/streams.def.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "golden/texel/texture.h"

namespace wrinkle {

// A port of so many bits; what is wider than a word is an array of words, the low one first.
template <int bits>
using PinBits = std::conditional_t<(bits <= 64), std::uint64_t, std::array<std::uint64_t, (bits + 63) / 64>>;

// What the bench drives.
struct InputPins {
  bool are_new = true;  // something was changed since the model took them; who changes a pin says so
  std::uint8_t rst = 0;
#define WRINKLE_INPUT(stream, stage) std::uint8_t stream##_valid = 0;
#define WRINKLE_INPUT_FIELD(stream, name, most, width) PinBits<most> name{};
#define WRINKLE_OUTPUT(stream, stage) std::uint8_t stream##_ready = 0;
#include "golden/streams.def"
};

// What the core drives. The fields of a stream are up to date while it is valid.
struct OutputPins {
#define WRINKLE_INPUT(stream, stage) std::uint8_t stream##_ready = 0;
#define WRINKLE_OUTPUT(stream, stage) std::uint8_t stream##_valid = 0;
#define WRINKLE_OUTPUT_FIELD(stream, name, most, width) PinBits<most> name{};
#define WRINKLE_STATUS(name) std::uint8_t name = 0;
#include "golden/streams.def"
};

struct Pins : InputPins, OutputPins {};

enum class Stream : int {
#define WRINKLE_INPUT(stream, stage) stream,
#define WRINKLE_OUTPUT(stream, stage) stream,
#include "golden/streams.def"
};

// The stage that each stream belongs to.
inline constexpr std::array kStreamStages{
#define WRINKLE_INPUT(stream, stage) std::string_view(#stage),
#define WRINKLE_OUTPUT(stream, stage) std::string_view(#stage),
#include "golden/streams.def"
};

// Something for each stream, in their order.
template <class T>
using PerStream = std::array<T, kStreamStages.size()>;

}  // namespace wrinkle

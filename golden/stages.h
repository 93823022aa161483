// The stages of stages.def for C++.
#pragma once

#include <array>
#include <string_view>

#include "golden/config/config.h"

namespace wrinkle {

enum class Stage : int {
#define WRINKLE_STAGE(name, title, moves, latency) name,
#include "golden/stages.def"
#undef WRINKLE_STAGE
};

inline constexpr std::array kStageNames{
#define WRINKLE_STAGE(name, title, moves, latency) std::string_view(#name),
#include "golden/stages.def"
#undef WRINKLE_STAGE
};
inline constexpr int kStages = static_cast<int>(kStageNames.size());

// A set of stages, as bits.
enum Stages : unsigned {
#define WRINKLE_STAGE(name, title, moves, latency) k##title = 1U << static_cast<int>(Stage::name),
#include "golden/stages.def"
#undef WRINKLE_STAGE
  kAllStages = (1U << kStages) - 1
};

// A number for each stage, in their order.
template <class T>
using PerStage = std::array<T, kStageNames.size()>;

// How often a stage hands on one fragment.
inline PerStage<int> stage_moves([[maybe_unused]] const Shape& c) {
  return {
#define WRINKLE_STAGE(name, title, moves, latency) moves,
#include "golden/stages.def"
#undef WRINKLE_STAGE
  };
}

// Clocks that each stage takes of the way of a packet's first fragment.
inline PerStage<int> stage_latencies([[maybe_unused]] const Shape& c) {
  return {
#define WRINKLE_STAGE(name, title, moves, latency) latency,
#include "golden/stages.def"
#undef WRINKLE_STAGE
  };
}

}  // namespace wrinkle

// The float64 datapath with the rounding of chosen stages put in: which stage costs how much of the picture.
//
// The rounding of a stage at a pixel is what its golden values differ by from its float64 twin given the very inputs
// that golden had. Replaying the twins from the vertices on and adding these at all stages gives golden's own colours;
// adding them at one stage alone, or at all but one, tells what that stage costs.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "golden/exact/pipeline.h"

namespace wrinkle {

// In pipeline order. kInterpolate is with the division of u and v; kDot is N.L and N.H; kPower is all behind them up
// to diffuse and specular.
enum class Part { kInterpolate, kTexel, kFilter, kPerturb, kNormalize, kDot, kPower, kOutput };
inline constexpr std::size_t kParts = 8;
inline constexpr std::array<std::string_view, kParts> kPartNames{"interpolators", "texel", "filter", "perturb",
                                                                 "normalizer",    "dot",   "power",  "output"};
using Parts = std::array<bool, kParts>;

// What a part puts out, twin and rounding apart.
struct PartOutput {
  ExactFragment exact;    // of the twin given golden's inputs; only the fields of the part are its own
  ExactFragment rounded;  // golden's
};

// One pixel: golden's values, as real numbers, and what the twins make of them.
struct ReplayedPixel {
  const exact::DrawContext& draw;
  const ExactFragment& exact;   // the exact datapath's
  const ExactFragment& golden;  // golden's values as real numbers
  std::array<PartOutput, kParts> parts;
};

// The colour with the rounding of the chosen parts only.
Vec3 replay(const ReplayedPixel& pixel, const Parts& chosen);

// Calls `visit` for every fragment of the frame. Vectors that are normalized after the dot products are their mantissas
// times their scales: what the normalizer puts out and what the dot products are of.
void for_each_replayed(const Config& config, const Frame& frame,
                       const std::function<void(const ReplayedPixel&)>& visit);

}  // namespace wrinkle

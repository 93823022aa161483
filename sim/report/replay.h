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

#include "golden/exact/pipeline.h"

namespace wrinkle {

// In pipeline order. kInterpolate is with the division of u and v; kDot is N.L and N.H; kPower is all behind them up
// to diffuse and specular.
enum class Part { kInterpolate, kTexel, kFilter, kPerturb, kNormalize, kDot, kPower, kOutput };
inline constexpr std::size_t kParts = 8;
inline constexpr std::array<std::string_view, kParts> kPartNames{"interpolators", "texel", "filter", "perturb",
                                                                 "normalizer",    "dot",   "power",  "output"};
using Parts = std::array<bool, kParts>;

// Some fragments of one draw: golden's values as real numbers, and what the twins make of them. Vectors that are
// normalized after the dot products are their mantissas times their scales: what the normalizer puts out and what the
// dot products are of.
class Replay {
 public:
  using Colours = exact::Column<Vec3>;
  using PartVisit = std::function<void(Part, const Colours& alone, const Colours& without)>;

  // `exact` up to what is interpolated; `texels`: the codes of the texture of the draw as real numbers.
  void start(const exact::DrawContext& draw, const ExactTexture* texels, const exact::Fragments& interpolated,
             const exact::Fragments& golden);

  const exact::DrawContext& draw() const { return *draw_; }
  std::size_t count() const { return static_cast<std::size_t>(golden_.count); }
  const exact::Fragments& exact() const { return exact_; }
  const exact::Fragments& golden() const { return golden_; }
  // What a part puts out: its twin, given golden's inputs, and golden. Only the values of the part are its own.
  const exact::Fragments& twin(Part part) const;
  const exact::Fragments& rounded(Part part) const;

  // The colours with the rounding of the chosen parts; valid until the next call.
  const Colours& replay(const Parts& chosen);
  // For each part, last to first, the colours when it alone rounds, and when all others do.
  void for_each_part(const PartVisit& visit);

 private:
  void run_from(Part first, const Parts& chosen, exact::Fragments& batch) const;
  void put_out(Part part, bool is_rounded, exact::Fragments& batch) const;

  const exact::DrawContext* draw_ = nullptr;
  exact::Fragments exact_, golden_;
  exact::Fragments twin_, quantised_;  // quantised_: what the filter makes of the codes, without rounding
  exact::Fragments alone_, without_;
};

// Calls `visit` with all fragments of the frame, in golden's order.
void for_each_replayed(const Shape& config, const Frame& frame, const std::function<void(Replay&)>& visit);

}  // namespace wrinkle

#include "sim/report/golden_reals.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace wrinkle {
namespace {

using exact::Fragments;
using exact::Numbers;

// Where the value on a wire goes. Behind `perspective` u and v are the divided ones.
struct Target {
  std::string_view wire;
  Numbers* (*numbers)(Fragments&, std::size_t element);
};
constexpr Target kTargets[] = {
#define WRINKLE_EXACT(type, name, initial, wire) \
  {#wire, [](Fragments& b, std::size_t element) { return &b.name.element[element]; }},
#include "golden/exact/fragment.def"
#undef WRINKLE_EXACT
    {"perspective_u", [](Fragments& b, std::size_t) { return &b.u.element[0]; }},
    {"perspective_v", [](Fragments& b, std::size_t) { return &b.v.element[0]; }},
};

double full_scale(int bits) { return 1 / (1 - std::ldexp(1.0, -bits)); }

}  // namespace

GoldenReals::GoldenReals(const Shape& config) : values_(values(config)), grey_(config.count == 1) {
  for (std::size_t i = 0; i < values_.size(); ++i) add(config, values_[i], i);
}

void GoldenReals::add(const Shape& config, const Value& value, std::size_t index) {
  for (const Target& target : kTargets) {
    if (target.wire != value.wire) continue;
    const auto first = std::size_t(value.first_element);
    for (std::size_t k = 0; k < std::size_t(value.elements); ++k) {
      Element element{target.numbers, first + k, index, k, std::ldexp(1.0, -value.fraction_bits)};
      if (value.name == "decal" || value.name == "gloss")
        element.factor = full_scale(config.texel_bits), element.textured_only = true;
      if (value.name == "colour") element.factor = full_scale(config.colour_bits);
      if (config.normalizes_after != 0 && value.stage == "normalize") {
        const auto is_scale = [](const Value& v) { return v.stage == "normalize" && v.name == "scale"; };
        element.scale = int(std::find_if(values_.begin(), values_.end(), is_scale) - values_.begin());
        element.scale_element = value.name == "n" ? 0 : value.name == "l" ? 1 : 2;
        element.scale_lsb = std::ldexp(1.0, -values_[std::size_t(element.scale)].fraction_bits);
      }
      elements_.push_back(element);
    }
  }
}

template <class Int>
void GoldenReals::read(const wrinkle::Batch<Int>& from, std::size_t first, const exact::DrawContext& draw, int count,
                       Fragments& to) const {
  const auto n = std::size_t(count);
  to.count = count;
  to.clear(0, n);
  for (const Element& element : elements_) {
    if (element.textured_only && draw.texture == nullptr) continue;
    Numbers& numbers = *element.target(to, element.target_element);
    const Int* codes = column(from, element.value, element.element) + first;
    for (std::size_t i = 0; i < n; ++i) numbers[i] = element.factor * (element.lsb * double(codes[i]));
    if (element.scale < 0) continue;
    const Int* scales = column(from, std::size_t(element.scale), element.scale_element) + first;
    for (std::size_t i = 0; i < n; ++i) numbers[i] *= element.scale_lsb * double(scales[i]);
  }
  if (grey_) to.colour.element[1] = to.colour.element[2] = to.colour.element[0];
}

template void GoldenReals::read(const wrinkle::Batch<std::int32_t>&, std::size_t, const exact::DrawContext&, int,
                                Fragments&) const;
template void GoldenReals::read(const wrinkle::Batch<std::int64_t>&, std::size_t, const exact::DrawContext&, int,
                                Fragments&) const;

}  // namespace wrinkle

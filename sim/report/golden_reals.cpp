#include "sim/report/golden_reals.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace wrinkle {
namespace {

using exact::Fragments;
using exact::Numbers;

struct Place {
  std::string_view wire;  // as in values.def
  Numbers* (*target)(Fragments&, std::size_t element);
};

// Where each value goes; u and v are those behind `perspective`, where there is one.
#define WRINKLE_PLACE(stage, name, column)                                                          \
  {                                                                                                 \
#stage "_" #name, [](Fragments & b, std::size_t element) { return &b.column.element[element]; } \
  }
constexpr Place kPlaces[] = {WRINKLE_PLACE(interpolate, frame, frame),
                             WRINKLE_PLACE(interpolate, l, interpolated_l),
                             WRINKLE_PLACE(interpolate, h, interpolated_h),
                             WRINKLE_PLACE(interpolate, u, u),
                             WRINKLE_PLACE(interpolate, v, v),
                             WRINKLE_PLACE(interpolate, lod, lod),
                             WRINKLE_PLACE(perspective, u, u),
                             WRINKLE_PLACE(perspective, v, v),
                             WRINKLE_PLACE(texture, bump, bump),
                             WRINKLE_PLACE(texture, decal, decal),
                             WRINKLE_PLACE(perturb, n, perturbed_n),
                             WRINKLE_PLACE(normalize, n, n),
                             WRINKLE_PLACE(normalize, l, l),
                             WRINKLE_PLACE(normalize, h, h),
                             WRINKLE_PLACE(light, nl, nl),
                             WRINKLE_PLACE(light, nh, nh),
                             WRINKLE_PLACE(light, diffuse, diffuse),
                             WRINKLE_PLACE(light, specular, specular),
                             WRINKLE_PLACE(output, colour, colour)};
#undef WRINKLE_PLACE

double full_scale(int bits) { return 1 / (1 - std::ldexp(1.0, -bits)); }

}  // namespace

GoldenReals::GoldenReals(const Shape& config) : values_(values(config)), grey_(config.count == 1) {
  for (std::size_t i = 0; i < values_.size(); ++i) add(config, values_[i], i);
}

void GoldenReals::add(const Shape& config, const Value& value, std::size_t index) {
  for (const Place& place : kPlaces) {
    if (place.wire != value.wire) continue;
    const auto first = std::size_t(value.lowest_bit / value.width);
    for (std::size_t k = 0; k < std::size_t(value.elements); ++k) {
      Element element{place.target, first + k, index, k, std::ldexp(1.0, -value.fraction_bits)};
      if (value.name == "decal") element.factor = full_scale(config.texel_bits), element.textured_only = true;
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

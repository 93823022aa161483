#include "sim/report/error.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "sim/engine.h"
#include "sim/report/similarity.h"

namespace wrinkle {
namespace {

struct Sum {
  double squares = 0, max = 0;
  std::uint64_t count = 0;

  void add(double error) {
    squares += error * error;
    max = std::max(max, std::abs(error));
    ++count;
  }
  Spread spread() const { return {count > 0 ? std::sqrt(squares / double(count)) : 0, max}; }
  double psnr_db() const {
    const double mean = count > 0 ? squares / double(count) : 0;
    return mean > 0 ? std::min(kPsnrOfEqual, -10 * std::log10(mean)) : kPsnrOfEqual;
  }
};

struct PartSums {
  Sum ulp, degrees, length, colour_alone, colour_without;

  void add_number(double rounded, double exact, double one_ulp) { ulp.add((rounded - exact) / one_ulp); }
  void add_vector(Vec3 rounded, Vec3 exact, double one_ulp) {
    add_number(rounded.x, exact.x, one_ulp);
    add_number(rounded.y, exact.y, one_ulp);
    add_number(rounded.z, exact.z, one_ulp);
    const double a = wrinkle::length(rounded), b = wrinkle::length(exact);
    if (a == 0 || b == 0) return;
    degrees.add(std::atan2(wrinkle::length(cross(rounded, exact)), dot(rounded, exact)) * 180 / std::numbers::pi);
    length.add(a - b);
  }
  void add_colours(Vec3 alone, Vec3 without, Vec3 exact) {
    for (const auto axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      colour_alone.add(alone.*axis - exact.*axis);
      colour_without.add(without.*axis - exact.*axis);
    }
  }
};

double ulp_of(int fraction_bits) { return std::ldexp(1.0, -fraction_bits); }

// Adds the errors of a part's values against its twin, in ulp of their formats.
void add_values(const Config& c, Part part, const ReplayedPixel& pixel, PartSums& sums) {
  const ExactFragment &r = pixel.parts[std::size_t(part)].rounded, &e = pixel.parts[std::size_t(part)].exact;
  const double vector = ulp_of(c.vector_bits), unit = ulp_of(c.unit_bits), dot_ulp = ulp_of(c.dot_bits);
  const double wide = ulp_of(c.wide_bits), gradient = ulp_of(c.gradient_bits), code = ulp_of(c.texel_bits - 1);
  const bool textured = pixel.draw.texture != nullptr;
  const auto add_texture = [&](double normal_ulp, double gradient_ulp) {
    if (textured && c.has_texture_normal()) sums.add_vector(r.texture_n, e.texture_n, normal_ulp);
    if (!textured || !c.has_blinn()) return;
    sums.add_number(r.gradient.x, e.gradient.x, gradient_ulp);
    sums.add_number(r.gradient.y, e.gradient.y, gradient_ulp);
  };
  switch (part) {
    case Part::kInterpolate:
      if (c.has_normal_planes()) sums.add_vector(r.interpolated_n, e.interpolated_n, vector);
      for (const auto plane :
           {&ExactFragment::interpolated_a, &ExactFragment::interpolated_b, &ExactFragment::interpolated_c})
        if (c.has_blinn()) sums.add_vector(r.*plane, e.*plane, wide);
      if (c.has_light_planes()) sums.add_vector(r.interpolated_l, e.interpolated_l, vector);
      if (c.has_light_planes() && c.has_specular()) sums.add_vector(r.interpolated_h, e.interpolated_h, vector);
      return;
    case Part::kTexel:
      return add_texture(code, code);
    case Part::kFilter:
      return add_texture(vector, gradient);
    case Part::kPerturb:
      if (c.has_normal()) sums.add_vector(r.perturbed_n, e.perturbed_n, ulp_of(c.normal_vector_bits()));
      return;
    case Part::kNormalize:
      sums.add_vector(r.n, e.n, unit);
      sums.add_vector(r.l, e.l, unit);
      if (c.has_specular()) sums.add_vector(r.h, e.h, unit);
      return;
    case Part::kDot:
      sums.add_number(r.nl, e.nl, dot_ulp);
      if (c.has_specular()) sums.add_number(r.nh, e.nh, dot_ulp);
      return;
    case Part::kPower:
      sums.add_number(r.diffuse, e.diffuse, dot_ulp);
      if (c.has_specular()) sums.add_number(r.specular, e.specular, ulp_of(c.power_bits));
      return;
    case Part::kOutput:
      sums.add_number(r.colour.x, e.colour.x, 1.0 / ((1 << c.colour_bits) - 1));
      return;
  }
}

Picture picture_of(Engine engine, const Config& config, const Frame& frame, std::vector<std::uint8_t>& covered) {
  const Framebuffer framebuffer = drawn(engine, config, frame);
  covered = framebuffer.covered();
  return framebuffer.colour();
}

PartError summary(Part part, const PartSums& sums) {
  PartError error{kPartNames[std::size_t(part)], sums.ulp.spread(),          sums.degrees.spread(),
                  sums.length.spread(),          sums.colour_alone.spread(), sums.colour_alone.psnr_db(),
                  sums.colour_without.psnr_db()};
  error.grey.rms *= 255;
  error.grey.max *= 255;
  return error;
}

double largest(Vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

}  // namespace

PictureError picture_error(const Picture& a, const Picture& b, const std::vector<std::uint8_t>& mask) {
  const PictureDifference difference = compare(a, b, mask);
  return {difference.psnr_db, error_percentile(a, b, mask, .999), difference.max_error,
          structural_similarity(a, b, mask)};
}

ErrorReport measure_error(const std::string& config_name, const Config& config, const Frame& frame) {
  ErrorReport report{config_name, frame.name, 0, {}, {}, {}, 0};
  std::array<PartSums, kParts> sums;
  Parts every;
  every.fill(true);
  for_each_replayed(config, frame, [&](const ReplayedPixel& pixel) {
    ++report.fragments;
    report.replay_deviation = std::max(report.replay_deviation, largest(replay(pixel, every) - pixel.golden.colour));
    for (std::size_t i = 0; i < kParts; ++i) {
      Parts alone{}, without = every;
      alone[i] = true;
      without[i] = false;
      add_values(config, Part(i), pixel, sums[i]);
      sums[i].add_colours(replay(pixel, alone), replay(pixel, without), pixel.exact.colour);
    }
  });
  for (std::size_t i = 0; i < kParts; ++i) report.parts.push_back(summary(Part(i), sums[i]));
  std::vector<std::uint8_t> covered;
  const Picture ideal = picture_of(Engine::kIdeal, config, frame, covered);
  const Picture exact = picture_of(Engine::kExact, config, frame, covered);
  const Picture golden = picture_of(Engine::kGolden, config, frame, covered);
  report.precision = picture_error(golden, exact, covered);
  report.method = picture_error(exact, ideal, covered);
  return report;
}

nlohmann::json to_json(const PictureError& e) {
  return {{"psnr_db", e.psnr_db}, {"p999", e.p999}, {"max", e.max}, {"ssim", e.ssim}};
}

nlohmann::json to_json(const ErrorReport& report) {
  const auto spread = [](const Spread& s) { return nlohmann::json{{"rms", s.rms}, {"max", s.max}}; };
  nlohmann::json parts = nlohmann::json::array();
  for (const PartError& part : report.parts) {
    parts.push_back({{"stage", part.name},
                     {"ulp", spread(part.ulp)},
                     {"degrees", spread(part.degrees)},
                     {"length", spread(part.length)},
                     {"grey", spread(part.grey)},
                     {"psnr_alone_db", part.alone_db},
                     {"psnr_without_db", part.without_db}});
  }
  return {{"config", report.config},
          {"scene", report.scene},
          {"fragments", report.fragments},
          {"stages", parts},
          {"precision", to_json(report.precision)},
          {"method", to_json(report.method)},
          {"replay_deviation", report.replay_deviation}};
}

}  // namespace wrinkle

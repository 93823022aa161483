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

// The values of a part against its twin, in units of their formats: those of the fragment i.
void add_values(const Shape& c, Part part, const Replay& replay, std::size_t i, PartSums& sums) {
  const exact::Fragments &r = replay.rounded(part), &e = replay.twin(part);
  const double vector = ulp_of(c.vector_bits), unit = ulp_of(c.unit_bits), dot_ulp = ulp_of(c.dot_bits);
  const double code = ulp_of(c.texel_bits - 1);
  const bool textured = replay.draw().texture != nullptr;
  const auto add_vector = [&](bool present, exact::Column<Vec3> exact::Fragments::*column, double ulp) {
    if (present) sums.add_vector((r.*column)[i], (e.*column)[i], ulp);
  };
  const auto add_number = [&](bool present, exact::Column<double> exact::Fragments::*column, double ulp) {
    if (present) sums.add_number((r.*column)[i], (e.*column)[i], ulp);
  };
  const auto add_texture = [&](double component_ulp) {
    if (!textured) return;
    const BumpComponents rounded = r.bump[i], twin = e.bump[i];
    if (c.bump_components == 3)
      return sums.add_vector({rounded[0], rounded[1], rounded[2]}, {twin[0], twin[1], twin[2]}, component_ulp);
    for (std::size_t k = 0; k < std::size_t(c.bump_components); ++k)
      sums.add_number(rounded[k], twin[k], component_ulp);
  };
  switch (part) {
    case Part::kInterpolate:
      for (std::size_t k = 0; const FrameVector& v : frame_vectors(c)) {
        if (v.width != 0) sums.add_vector(r.frame[i][k], e.frame[i][k], ulp_of(v.fraction_bits));
        ++k;
      }
      add_vector(c.has_light_planes != 0, &exact::Fragments::interpolated_l, vector);
      return add_vector(c.has_light_planes != 0 && c.glossy != 0, &exact::Fragments::interpolated_h, vector);
    case Part::kTexel:
      return add_texture(code);
    case Part::kFilter:
      return add_texture(ulp_of(c.bump_fraction));
    case Part::kPerturb:
      return add_vector(c.normal_width != 0, &exact::Fragments::perturbed_n, ulp_of(c.normal_bits));
    case Part::kNormalize:
      add_vector(true, &exact::Fragments::n, unit);
      add_vector(true, &exact::Fragments::l, unit);
      return add_vector(c.glossy != 0, &exact::Fragments::h, unit);
    case Part::kDot:
      add_number(true, &exact::Fragments::nl, dot_ulp);
      return add_number(c.glossy != 0, &exact::Fragments::nh, dot_ulp);
    case Part::kPower:
      add_number(true, &exact::Fragments::diffuse, dot_ulp);
      return add_number(c.glossy != 0, &exact::Fragments::specular, ulp_of(c.power_bits));
    case Part::kOutput:
      return sums.add_number(r.colour[i].x, e.colour[i].x, 1.0 / ((1 << c.colour_bits) - 1));
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
  const Shape shape(config);
  for_each_replayed(shape, frame, [&](Replay& replay) {
    report.fragments += replay.count();
    const Replay::Colours& replayed = replay.replay(every);
    for (std::size_t i = 0; i < replay.count(); ++i)
      report.replay_deviation = std::max(report.replay_deviation, largest(replayed[i] - replay.golden().colour[i]));
    replay.for_each_part([&](Part part, const Replay::Colours& alone, const Replay::Colours& without) {
      PartSums& sum = sums[std::size_t(part)];
      for (std::size_t i = 0; i < replay.count(); ++i) {
        add_values(shape, part, replay, i, sum);
        sum.add_colours(alone[i], without[i], replay.exact().colour[i]);
      }
    });
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

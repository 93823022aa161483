#include "sim/report/replay.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/report/golden_reals.h"

namespace wrinkle {
namespace {

using exact::Fragments;
using exact::Numbers;

constexpr std::array kLastFirst{Part::kOutput,  Part::kPower,  Part::kDot,   Part::kNormalize,
                                Part::kPerturb, Part::kFilter, Part::kTexel, Part::kInterpolate};

// Calls visit(column) for the values that a part puts out: pointers to the columns of a batch.
template <class Visit>
void for_each_column(const Shape& config, Part part, Visit&& visit) {
  const auto only = [&](bool present, auto column) {
    if (present) visit(column);
  };
  switch (part) {
    case Part::kInterpolate:
      only(config.frame_vectors != 0, &Fragments::frame);
      only(config.has_light_planes != 0, &Fragments::interpolated_l);
      only(config.has_light_planes != 0 && config.glossy != 0, &Fragments::interpolated_h);
      for (const auto coordinate : {&Fragments::u, &Fragments::v, &Fragments::lod})
        only(config.textured != 0, coordinate);
      return;
    case Part::kTexel:
    case Part::kFilter:
      only(config.bump_components != 0, &Fragments::bump);
      only(config.decal != 0, &Fragments::decal);
      return only(config.gloss_map != 0, &Fragments::gloss);
    case Part::kPerturb:
      return only(config.normal_width != 0, &Fragments::perturbed_n);
    case Part::kNormalize:
      for (const auto vector : {&Fragments::n, &Fragments::l, &Fragments::h}) visit(vector);
      return;
    case Part::kDot:
      visit(&Fragments::nl);
      return visit(&Fragments::nh);
    case Part::kPower:
      visit(&Fragments::diffuse);
      return visit(&Fragments::specular);
    case Part::kOutput:
      return visit(&Fragments::colour);
  }
}

void run_twin(Part part, const exact::DrawContext& draw, Fragments& batch) {
  switch (part) {
    case Part::kInterpolate:
    case Part::kFilter:
      return;
    case Part::kTexel:
      return exact::texture(draw, draw.texture, batch);
    case Part::kPerturb:
      return exact::perturb(draw, batch);
    case Part::kNormalize:
      return exact::normalize(draw, batch);
    case Part::kDot:
      return exact::dots(draw, batch);
    case Part::kPower:
      return exact::power(draw, batch);
    case Part::kOutput:
      return exact::output(draw, batch);
  }
}

// The codes of a texture as the real numbers that they stand for.
ExactTexture decoded(const Shape& config, const Texture& texture) {
  ExactTexture result{texture.log2_width, texture.log2_height, {}};
  const int bits = texture.component_bits, bumps = config.bump_components;
  const double mask = std::ldexp(1.0, bits) - 1, half = std::ldexp(1.0, bits - 1);
  const double zero = config.bump_offset / 2.0;
  const auto words = std::size_t(texture.texel_words());
  for (const auto& level : texture.levels) {
    auto& texels = result.levels.emplace_back(level.size() / words);
    for (std::size_t i = 0; i < texels.size(); ++i) {
      for (int c = 0; c < texture.components; ++c) {
        const auto code = double(texture.code(level, i, c));
        if (c < bumps) {
          texels[i].bump[std::size_t(c)] = float((code - zero) / half);
        } else if (c < bumps + config.colours) {
          texels[i].colour[std::size_t(c - bumps)] = float(code / mask);
        } else {
          texels[i].gloss = float(code / mask);
        }
      }
    }
  }
  return result;
}

// Finds the triangles of a frame again whose packets golden draws, in their order.
class TriangleCursor {
 public:
  TriangleCursor(const Shape& config, const Frame& frame, const PacketStream& stream)
      : config_(config), frame_(frame), stream_(stream) {}

  // The triangle of a packet with the pixel (x, y). Packets come in order; pieces of one triangle share its id, and no
  // pixel.
  exact::Interpolator& at(std::uint32_t packet, int x, int y) {
    if (packet == packet_ && triangle_) return *triangle_;
    packet_ = packet;
    if (stream_.packet_draw[packet] != draw_) {
      draw_ = stream_.packet_draw[packet];
      next_ = 0;
      triangle_.reset();
    }
    const std::uint32_t id = stream_.packet_triangle[packet];
    while (!triangle_ || triangle_->triangle().id != id || !triangle_->covers(x, y)) {
      const auto& triangles = frame_.draws[draw_].triangles;
      if (next_ == triangles.size()) throw std::logic_error("golden draws a fragment that no triangle covers");
      triangle_.emplace(config_, triangles[next_++]);
    }
    return *triangle_;
  }

 private:
  const Shape& config_;
  const Frame& frame_;
  const PacketStream& stream_;
  std::uint32_t packet_ = 0, draw_ = 0;
  std::size_t next_ = 0;  // triangle of the draw
  std::optional<exact::Interpolator> triangle_;
};

}  // namespace

void Replay::start(const exact::DrawContext& draw, const ExactTexture* texels, const Fragments& interpolated,
                   const Fragments& golden) {
  draw_ = &draw;
  exact_ = interpolated;
  golden_ = golden;
  exact::run_stages(draw, kAllStages, exact_);
  // Last to first: what a part reads is still golden's when it runs.
  twin_ = golden;
  for (const Part part : kLastFirst) run_twin(part, draw, twin_);
  quantised_ = golden;
  exact::texture(draw, draw.texture == nullptr ? nullptr : texels, quantised_);
}

const Fragments& Replay::twin(Part part) const {
  // The texels alone are rounded first, then all that the filter rounds.
  return part == Part::kInterpolate ? exact_ : part == Part::kFilter ? quantised_ : twin_;
}

const Fragments& Replay::rounded(Part part) const { return part == Part::kTexel ? quantised_ : golden_; }

void Replay::put_out(Part part, bool is_rounded, Fragments& batch) const {
  run_twin(part, *draw_, batch);
  const Fragments &from = twin(part), &to = rounded(part);
  for_each_column(draw_->config, part, [&](auto column) {
    for (std::size_t k = 0; k < (batch.*column).element.size(); ++k) {
      Numbers& numbers = (batch.*column).element[k];
      const Numbers &e = (from.*column).element[k], &r = (to.*column).element[k];
      if (part == Part::kInterpolate) numbers = e;  // nothing is in front of it
      for (std::size_t i = 0; is_rounded && i < count(); ++i) numbers[i] += r[i] - e[i];
    }
  });
}

void Replay::run_from(Part first, const Parts& chosen, Fragments& batch) const {
  for (std::size_t i = std::size_t(first); i < kParts; ++i) put_out(Part(i), chosen[i], batch);
}

const Replay::Colours& Replay::replay(const Parts& chosen) {
  alone_ = exact_;
  run_from(Part::kInterpolate, chosen, alone_);
  return alone_.colour;
}

void Replay::for_each_part(const PartVisit& visit) {
  Parts every;
  every.fill(true);
  alone_ = without_ = exact_;
  run_from(Part::kInterpolate, every, without_);
  // Last to first: the values in front of a part are those without any rounding and with all of it, as they were left.
  for (const Part part : kLastFirst) {
    Parts alone{}, without = every;
    alone[std::size_t(part)] = true;
    without[std::size_t(part)] = false;
    const Part first = part == Part::kFilter ? Part::kTexel : part;  // both put out the same values
    run_from(first, alone, alone_);
    run_from(first, without, without_);
    visit(part, alone_.colour, without_.colour);
  }
}

void for_each_replayed(const Shape& config, const Frame& frame, const std::function<void(Replay&)>& visit) {
  std::vector<ExactTexture> textures;
  for (const Texture& texture : frame.textures) textures.push_back(decoded(config, texture));
  const GoldenReals reals(config);
  const PacketStream stream = build_packets(config, frame);
  TriangleCursor triangles(config, frame, stream);
  std::optional<exact::DrawContext> draw;
  std::uint32_t draw_index = 0;
  Fragments interpolated, golden;
  Replay replay;

  // Fragments [first, first + interpolated.count) of a batch of golden's.
  const auto piece = [&](const auto& batch, std::size_t first) {
    for (std::size_t i = 0; i < std::size_t(interpolated.count); ++i) {
      const int x = int(batch.scan_x[0][first + i]), y = int(batch.scan_y[0][first + i]);
      triangles.at(batch.packet[first + i], x, y).put(*draw, x, y, i, interpolated);
    }
    reals.read(batch, first, *draw, interpolated.count, golden);
    const std::size_t number = std::size_t(frame.draws[draw_index].state.texture);
    replay.start(*draw, draw->texture == nullptr ? nullptr : &textures[number], interpolated, golden);
    visit(replay);
  };
  const auto read = [&](const auto& batch) {
    const std::uint32_t index = stream.packet_draw[batch.packet[0]];
    if (!draw || index != draw_index) draw.emplace(exact::draw_context(config, frame, frame.draws[index]));
    draw_index = interpolated.draw = golden.draw = index;
    for (int first = 0; first < batch.count; first += exact::kColumnLength) {
      interpolated.count = std::min(exact::kColumnLength, batch.count - first);
      piece(batch, std::size_t(first));
    }
  };
  Golden(config, frame.textures).draw(stream.words, {read, read});
}

}  // namespace wrinkle

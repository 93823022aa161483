#include "sim/stress/stimulus.h"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace wrinkle {

ScreenTriangle screen_triangle(std::array<std::array<std::int32_t, 2>, 3> corners, const ScreenVertex& attributes) {
  ScreenTriangle triangle;
  for (std::size_t i = 0; i < 3; ++i) {
    triangle.v[i] = attributes;
    triangle.v[i].x = corners[i][0];
    triangle.v[i].y = corners[i][1];
  }
  return triangle;
}

Stimulus::Stimulus(const Config& config) : config_(config), values_(values(config)), formats_(plane_formats(config)) {}

int Stimulus::add_texture(Texture texture) {
  textures_.push_back(std::move(texture));
  return int(textures_.size()) - 1;
}

void Stimulus::add_draw(const DrawState& state) {
  state_ = state;
  stream_.draw_word.push_back(std::uint32_t(stream_.words.size()));
  encode(config_, quantise(config_, state, textures_), stream_.words);
}

TriangleWords Stimulus::row(int x, int y, int length) const {
  TriangleWords words(config_);
  words.y = y;
  words.start.w = x;
  words.end0.w = words.end1.w = x + length;
  for (const PlaneFormat& format : formats_) set(words, format.name, format.element, 0);
  return words;
}

void Stimulus::set(TriangleWords& words, std::string_view name, std::size_t element, std::int64_t value,
                   std::int64_t step) const {
  for (std::size_t p = 0; p < formats_.size(); ++p) {
    if (!formats_[p].is(name, element)) continue;
    const int bits = formats_[p].width + config_.guard_bits;
    const std::int64_t half = std::int64_t{1} << (config_.guard_bits - 1);
    const auto wrap = [&](std::int64_t v) {
      const std::int64_t low = v & ((std::int64_t{1} << bits) - 1);
      return formats_[p].is_signed && (low >> (bits - 1)) != 0 ? low - (std::int64_t{1} << bits) : low;
    };
    PlaneWords& plane = words.planes[p];
    plane.value = wrap((value << config_.guard_bits) + half);
    plane.dw = wrap(step << config_.guard_bits);
    plane.row = 0;
  }
}

void Stimulus::append(const TriangleWords& words) {
  stream_.packet_word.push_back(std::uint32_t(stream_.words.size()));
  stream_.packet_draw.push_back(std::uint32_t(stream_.draw_word.size() - 1));
  stream_.packet_triangle.push_back(adds_);
  encode(config_, words, stream_.words);
}

void Stimulus::add(const TriangleWords& words) {
  append(words);
  ++adds_;
}

void Stimulus::add_vectors(std::array<std::int64_t, 3> n, std::array<std::int64_t, 3> l,
                           std::array<std::int64_t, 3> h) {
  const int side = config_.screen_size();
  TriangleWords words = row(next_ % side, next_ / side % side);
  ++next_;
  for (std::size_t i = 0; i < 3; ++i) {
    set(words, "n", i, n[i]);
    set(words, "l", i, l[i]);
    set(words, "h", i, h[i]);
  }
  add(words);
}

int Stimulus::add(const ScreenTriangle& triangle, int width, int height) {
  const std::vector<TriangleWords> packets = set_up(config_, triangle, state_, textures_, width, height);
  for (const TriangleWords& packet : packets) append(packet);
  ++adds_;
  return int(packets.size());
}

void Stimulus::each_golden(const std::function<void(const FragmentValues&, std::uint32_t owner)>& visit) const {
  FragmentValues values;
  const auto keep = [&](const auto& batch) {
    for (int i = 0; i < batch.count; ++i) {
      extract(batch, i, values);
      visit(values, stream_.packet_triangle[batch.packet[std::size_t(i)]]);
    }
  };
  Golden(config_, textures_).draw(stream_.words, {keep, keep});
}

std::vector<FragmentValues> Stimulus::golden(std::vector<std::uint32_t>& owners) const {
  std::vector<FragmentValues> all;
  owners.clear();
  each_golden([&](const FragmentValues& values, std::uint32_t owner) {
    all.push_back(values);
    owners.push_back(owner);
  });
  return all;
}

std::vector<FragmentValues> Stimulus::golden() const {
  std::vector<std::uint32_t> owners;
  return golden(owners);
}

std::size_t Stimulus::index(std::string_view stage, std::string_view name) const {
  for (std::size_t i = 0; i < values_.size(); ++i)
    if (values_[i].stage == stage && values_[i].name == name) return i;
  throw std::logic_error("the configuration has no " + std::string(stage) + "_" + std::string(name));
}

double Stimulus::real(const FragmentValues& fragment, std::string_view stage, std::string_view name,
                      std::size_t element) const {
  const std::size_t i = index(stage, name);
  return std::ldexp(double(fragment[i][element]), -values_[i].fraction_bits);
}

}  // namespace wrinkle

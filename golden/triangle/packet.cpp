#include "golden/triangle/packet.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <type_traits>

namespace wrinkle {
namespace {

// The lists of fields. A visitor is called as visit(field, bits, is_signed) from bit 0 of the first word upwards, and
// visit.next_word() where a word is left unfilled; Draw and Triangle are const for a writer and not for a reader.

template <class Draw, class Visit>
void draw_fields(const Shape& config, Draw& draw, Visit& visit) {
  unsigned opcode = kOpcodeDraw;
  visit(opcode, 4, false);
  visit(draw.bump, 1, false);
  visit(draw.textured, 1, false);
  visit(draw.shadow, 1, false);
  visit(draw.exponent_zero, 1, false);
  visit(draw.wrap_u, 2, false);
  visit(draw.wrap_v, 2, false);
  visit(draw.log2_width, 4, false);
  visit(draw.log2_height, 4, false);
  visit(draw.max_level, 4, false);
  visit(draw.texture, 12, false);
  visit(draw.squarings, 4, false);
  for (auto* colour : {&draw.ambient, &draw.diffuse, &draw.specular}) {
    visit.next_word();
    for (auto& channel : *colour) visit(channel, 16, false);
  }
  visit.next_word();
  if (config.has_light_planes) return;
  for (auto* vector : {&draw.l, &draw.h}) {
    for (auto& component : *vector) visit(component, config.unit_bits + 2, true);
    visit.next_word();
  }
}

template <class Triangle, class Visit>
void scan_fields(const Shape& config, Triangle& triangle, Visit& visit) {
  const int screen = config.screen_bits;
  unsigned opcode = kOpcodeTriangle;
  visit(opcode, 4, false);
  visit(triangle.mirror, 1, false);
  visit(triangle.y, screen, false);
  visit(triangle.rows, screen + 1, false);
  visit(triangle.rows_end0, screen + 1, false);
  for (auto* edge : {&triangle.start, &triangle.end0, &triangle.end1}) {
    visit(edge->w, screen + 2, true);
    visit(edge->step, screen + 2, true);
    visit(edge->remainder, config.edge_bits + 1, true);
    visit(edge->remainder_step, config.edge_bits, false);
    visit(edge->denominator, config.edge_bits, false);
  }
  visit.next_word();
}

template <class Triangle, class Visit>
void plane_fields(const Shape& config, Triangle& triangle, Visit& visit) {
  std::size_t index = 0;
  for_each_plane(config, [&](const PlaneFormat& format) {
    auto& plane = triangle.planes[index++];
    if (format.is_held) return visit(plane.value, format.width, true);
    const int bits = format.width + config.guard_bits;
    visit(plane.value, bits, true);
    visit(plane.row, bits, true);
    visit(plane.dw, bits, true);
  });
  if (config.lod_held != 0) visit(triangle.lod, 4 + config.lod_fraction_bits, false);
  visit.next_word();
}

class Writer {
 public:
  explicit Writer(std::vector<std::uint64_t>& words) : words_(words) {}

  template <class Field>
  void operator()(const Field& field, int bits, [[maybe_unused]] bool is_signed) {
    const auto value = static_cast<std::int64_t>(field);
    assert(is_signed ? value >> (bits - 1) == value >> 63 : value >> bits == 0);
    const std::uint64_t code = static_cast<std::uint64_t>(value) & ((std::uint64_t{1} << bits) - 1);
    if (used_ == 0) words_.push_back(0);
    words_.back() |= code << used_;
    const int room = 64 - used_;
    if (bits > room) words_.push_back(code >> room);
    used_ = (used_ + bits) % 64;
  }
  void next_word() { used_ = 0; }

 private:
  std::vector<std::uint64_t>& words_;
  int used_ = 0;  // bits of the last word; 0: it is full
};

class Reader {
 public:
  explicit Reader(std::span<const std::uint64_t> words) : words_(words) {}

  template <class Field>
  void operator()(Field& field, int bits, bool is_signed) {
    const std::size_t word = bit_ / 64;
    const int shift = static_cast<int>(bit_ % 64);
    bit_ += static_cast<std::size_t>(bits);
    if ((bit_ + 63) / 64 > words_.size()) throw std::invalid_argument("a packet is cut short");
    std::uint64_t code = words_[word] >> shift;
    if (shift + bits > 64) code |= words_[word + 1] << (64 - shift);
    const int unused = 64 - bits;
    const auto top = static_cast<std::int64_t>(code << unused);
    field = static_cast<Field>(is_signed ? top >> unused : static_cast<std::int64_t>((code << unused) >> unused));
  }
  void next_word() { bit_ = (bit_ + 63) / 64 * 64; }

 private:
  std::span<const std::uint64_t> words_;
  std::size_t bit_ = 0;
};

// Counts the words that a list of fields fills.
class Counter {
 public:
  template <class Field>
  void operator()(const Field&, int bits, bool) {
    bits_ += bits;
  }
  void next_word() { bits_ = (bits_ + 63) / 64 * 64; }
  int words() const { return bits_ / 64; }

 private:
  int bits_ = 0;
};

void expect_opcode(std::span<const std::uint64_t> words, unsigned opcode) {
  if (words.empty() || (words[0] & 15) != opcode)
    throw std::invalid_argument("a packet has another opcode than expected");
}

void require(bool sound, const char* message) {
  if (!sound) throw std::invalid_argument(message);
}

// What the widths of the fields leave open and docs/formats.md does not allow.
void check(const Shape& config, const DrawWords& draw) {
  constexpr int kLastWrap = static_cast<int>(Wrap::kMirror);
  require(draw.wrap_u <= kLastWrap && draw.wrap_v <= kLastWrap, "a draw packet has a wrap mode that is none");
  require(std::max(draw.log2_width, draw.log2_height) <= kMaxLog2Size, "a draw packet has a texture that is too large");
  require(draw.squarings <= config.specular_squarings, "a draw packet has more squarings than the configuration");
  for (const auto* colour : {&draw.ambient, &draw.diffuse, &draw.specular})
    for (const int channel : *colour)
      require(channel <= 1 << config.colour_bits, "a draw packet has a colour greater than 1");
}

void check(const TriangleWords& triangle) {
  require(triangle.rows >= 1, "a triangle packet has no rows");
  for (const EdgeWords* edge : {&triangle.start, &triangle.end0, &triangle.end1}) {
    require(edge->remainder_step < edge->denominator && edge->remainder >= -edge->denominator && edge->remainder < 0,
            "a triangle packet has an edge with a remainder that is none of its denominator");
  }
}

}  // namespace

int scan_word_count(const Shape& config) {
  Counter counter;
  const TriangleWords triangle(config);
  scan_fields(config, triangle, counter);
  return counter.words();
}

int plane_word_count(const Shape& config) {
  Counter counter;
  const TriangleWords triangle(config);
  plane_fields(config, triangle, counter);
  return counter.words();
}

void encode(const Shape& config, const DrawWords& draw, std::vector<std::uint64_t>& words) {
  Writer writer(words);
  draw_fields(config, draw, writer);
}

void encode(const Shape& config, const TriangleWords& triangle, std::vector<std::uint64_t>& words) {
  Writer writer(words);
  scan_fields(config, triangle, writer);
  plane_fields(config, triangle, writer);
}

DrawWords decode_draw(const Shape& config, std::span<const std::uint64_t> words) {
  expect_opcode(words, kOpcodeDraw);
  DrawWords draw;
  Reader reader(words);
  draw_fields(config, draw, reader);
  check(config, draw);
  return draw;
}

void decode(const Shape& config, std::span<const std::uint64_t> words, TriangleWords& triangle) {
  expect_opcode(words, kOpcodeTriangle);
  Reader reader(words);
  scan_fields(config, triangle, reader);
  plane_fields(config, triangle, reader);
  check(triangle);
}

TriangleWords decode_triangle(const Shape& config, std::span<const std::uint64_t> words) {
  TriangleWords triangle(config);
  decode(config, words, triangle);
  return triangle;
}

}  // namespace wrinkle

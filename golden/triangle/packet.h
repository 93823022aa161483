// Packets: the words the hardware is fed with. Layout in docs/formats.md.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "golden/config/config.h"
#include "golden/triangle/draw.h"
#include "golden/triangle/plane_list.h"

namespace wrinkle {

inline constexpr unsigned kOpcodeDraw = 1;
inline constexpr unsigned kOpcodeTriangle = 2;

// The draw state as the hardware holds it.
struct DrawWords {
  bool bump = false, textured = false, shadow = false, exponent_zero = false;
  int wrap_u = 0, wrap_v = 0;
  int log2_width = 0, log2_height = 0, max_level = 0;
  int texture = 0;
  int squarings = 0;
  std::array<int, 3> ambient{}, diffuse{}, specular{};  // u1.C
  std::array<int, 3> l{}, h{};                          // s1.F; constant light vectors: L, and H or E; else 0

  bool operator==(const DrawWords&) const = default;
};

struct EdgeWords {
  std::int64_t w = 0, step = 0, remainder = -1, remainder_step = 0, denominator = 1;
  bool operator==(const EdgeWords&) const = default;
};

// One plane; all three modulo 2^(width + G), kept as the residue of that many bits that is
// sign-extended. Of a constant one `value` modulo 2^width.
struct PlaneWords {
  std::int64_t value = 0, row = 0, dw = 0;
  bool operator==(const PlaneWords&) const = default;
};

struct TriangleWords {
  // All planes are zero.
  explicit TriangleWords(const Shape& config) : planes(PlanePlaces(config).count) {}

  bool mirror = false;
  int y = 0, rows = 1, rows_end0 = 1;
  EdgeWords start, end0, end1;
  std::vector<PlaneWords> planes;  // in the order of plane_formats()
  int lod = 0;                     // where the level of detail is held

  bool operator==(const TriangleWords&) const = default;
};

int scan_word_count(const Shape& config);
int plane_word_count(const Shape& config);
inline int triangle_word_count(const Shape& config) { return scan_word_count(config) + plane_word_count(config); }

void encode(const Shape& config, const DrawWords& draw, std::vector<std::uint64_t>& words);
void encode(const Shape& config, const TriangleWords& triangle, std::vector<std::uint64_t>& words);
DrawWords decode_draw(const Shape& config, std::span<const std::uint64_t> words);
TriangleWords decode_triangle(const Shape& config, std::span<const std::uint64_t> words);
// The same into a triangle of this configuration.
void decode(const Shape& config, std::span<const std::uint64_t> words, TriangleWords& triangle);

// A colour as the configured channels: three, or one, the luminance (Rec. 709), in x.
Vec3 to_channels(const Shape& config, Vec3 colour);

// Quantises a draw state. What the configuration cannot do is off: bump and textured say whether texels are fetched.
// Throws std::invalid_argument when the texture is not there or the exponent is neither 0 nor a power of two.
DrawWords quantise(const Shape& config, const DrawState& state, const std::vector<Texture>& textures);

// Set-up: the packets of one triangle on a screen of width x height, none when it covers no pixel. Any winding draws;
// the order of the corners does not matter. Integers only after the one quantisation of each vertex; every compiler
// gives the same words. Throws std::invalid_argument for vertices outside the guard band [-2^X, 2^(X+1)) pixels,
// vectors far from unit length and 1/w <= 0, and std::range_error when u or v does not fit uv_integer_bits.
std::vector<TriangleWords> set_up(const Shape& config, const ScreenTriangle& triangle, const DrawWords& draw, int width,
                                  int height);
std::vector<TriangleWords> set_up(const Shape& config, const ScreenTriangle& triangle, const DrawState& state,
                                  const std::vector<Texture>& textures, int width, int height);

// A frame as words, with an index from packets back to triangles.
struct PacketStream {
  std::vector<std::uint64_t> words;
  std::vector<std::uint32_t> packet_word;      // first word of each triangle packet
  std::vector<std::uint32_t> packet_draw;      // index into Frame::draws
  std::vector<std::uint32_t> packet_triangle;  // ScreenTriangle::id
  std::vector<std::uint32_t> draw_word;        // first word of each draw packet
};
PacketStream build_packets(const Shape& config, const Frame& frame);

}  // namespace wrinkle

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "golden/triangle/coverage.h"
#include "golden/triangle/planes.h"

namespace wrinkle {

std::vector<TriangleWords> set_up(const Shape& config, const ScreenTriangle& triangle, const DrawWords& draw, int width,
                                  int height) {
  if (std::max(width, height) > config.screen_size()) throw std::invalid_argument("the screen exceeds screen_bits");
  const Corners corners = sort_corners(config, triangle);
  const std::vector<Piece> pieces = cover(config, corners, width, height);
  if (pieces.empty()) return {};
  const Planes planes = make_planes(config, corners, draw);
  std::vector<TriangleWords> packets;
  packets.reserve(pieces.size());
  for (const Piece& piece : pieces) {
    TriangleWords packet(config);
    packet.mirror = piece.mirror;
    packet.y = piece.y;
    packet.rows = piece.rows;
    packet.rows_end0 = piece.rows_end0;
    packet.start = piece.start;
    packet.end0 = piece.end0;
    packet.end1 = piece.end1;
    anchor(config, corners, planes, packet);
    packet.lod = planes.lod;
    packets.push_back(std::move(packet));
  }
  return packets;
}

std::vector<TriangleWords> set_up(const Shape& config, const ScreenTriangle& triangle, const DrawState& state,
                                  const std::vector<Texture>& textures, int width, int height) {
  return set_up(config, triangle, quantise(config, state, textures), width, height);
}

PacketStream build_packets(const Shape& config, const Frame& frame) {
  PacketStream stream;
  for (std::uint32_t index = 0; index < frame.draws.size(); ++index) {
    const Draw& draw = frame.draws[index];
    const DrawWords state = quantise(config, draw.state, frame.textures);
    bool drawn = false;
    for (const ScreenTriangle& triangle : draw.triangles) {
      for (const TriangleWords& packet : set_up(config, triangle, state, frame.width, frame.height)) {
        if (!drawn) {
          stream.draw_word.push_back(static_cast<std::uint32_t>(stream.words.size()));
          encode(config, state, stream.words);
          drawn = true;
        }
        stream.packet_word.push_back(static_cast<std::uint32_t>(stream.words.size()));
        stream.packet_draw.push_back(index);
        stream.packet_triangle.push_back(triangle.id);
        encode(config, packet, stream.words);
      }
    }
  }
  return stream;
}

}  // namespace wrinkle

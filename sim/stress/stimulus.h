// Packets made by hand: one-pixel triangles with any value in any interpolator, spans, and triangles through set-up.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "golden/config/config.h"
#include "golden/pixel/pixel.h"
#include "golden/triangle/packet.h"

namespace wrinkle {

// A triangle on the sub-pixel grid, the same attributes at every corner.
ScreenTriangle screen_triangle(std::array<std::array<std::int32_t, 2>, 3> corners, const ScreenVertex& attributes = {});

class Stimulus {
 public:
  explicit Stimulus(const Config& config);

  const Config& config() const { return config_; }

  // Returns the number of the texture, for DrawState::texture.
  int add_texture(Texture texture);
  void add_draw(const DrawState& state);

  // A row of `length` pixels from (x, y) to the right. All planes are zero but for the half that rounds. The caller
  // changes what it wants, and adds it by add().
  TriangleWords row(int x, int y, int length = 1) const;
  // An element of a value of `interpolate` at the first pixel, and its step along the row, in LSB of the value. Nothing
  // is set where the configuration lacks it.
  void set(TriangleWords& words, std::string_view name, std::size_t element, std::int64_t value,
           std::int64_t step = 0) const;
  void add(const TriangleWords& words);
  // A row of one pixel, placed after the one before; N, L and H in LSB of s1.V.
  void add_vectors(std::array<std::int64_t, 3> n, std::array<std::int64_t, 3> l, std::array<std::int64_t, 3> h);

  // Set-up of a triangle on a screen of width x height; returns the number of its packets.
  int add(const ScreenTriangle& triangle, int width, int height);

  // `packet_triangle` of the stream is the number of the add() that made the packet.
  const PacketStream& stream() const { return stream_; }
  const std::vector<Texture>& textures() const { return textures_; }

  // Draws by the golden model and hands on every fragment with all of its values and the number of its add().
  void each_golden(const std::function<void(const FragmentValues&, std::uint32_t owner)>& visit) const;
  std::vector<FragmentValues> golden() const;
  // As golden(), and with each fragment the number of the add() it belongs to.
  std::vector<FragmentValues> golden(std::vector<std::uint32_t>& owners) const;

  // Where values of values.def are in a FragmentValues; the configuration must have them.
  std::size_t index(std::string_view stage, std::string_view name) const;
  // One number of a fragment as a real.
  double real(const FragmentValues& values, std::string_view stage, std::string_view name,
              std::size_t element = 0) const;

 private:
  Config config_;
  std::vector<Value> values_;
  std::vector<PlaneFormat> formats_;
  DrawState state_;
  void append(const TriangleWords& words);

  PacketStream stream_;
  std::vector<Texture> textures_;
  std::uint32_t adds_ = 0;
  int next_ = 0;  // pixel of the next add_vectors()
};

}  // namespace wrinkle

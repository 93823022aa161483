#include "tb/random_packets.h"

#include <algorithm>
#include <cmath>

#include "tb/random_texels.h"
#include "tb/stall.h"

namespace wrinkle {
namespace {

constexpr int kTextures = 4096;
// So that a budget goes to many packets.
constexpr std::int64_t kLargestPacket = 600;

std::int64_t uniform(std::int64_t low, std::int64_t high, Random& random) {
  const auto range = static_cast<std::uint64_t>(high - low) + 1;
  return low + static_cast<std::int64_t>(random.next() % range);
}

// Uniform, near an end, or near the middle.
std::int64_t any_of(std::int64_t low, std::int64_t high, Random& random) {
  const std::int64_t near = std::min<std::int64_t>(high - low, 2), step = uniform(0, near, random);
  switch (random.below(6)) {
    case 0:
      return low + step;
    case 1:
      return high - step;
    case 2:
      return low + (high - low) / 2 + std::min(step, high - (low + (high - low) / 2));
    default:
      return uniform(low, high, random);
  }
}

std::int64_t any_signed(int bits, Random& random) {
  const std::int64_t half = std::int64_t{1} << (bits - 1);
  return any_of(-half, half - 1, random);
}

Texture random_texture(const Shape& config, int number, Random& random) {
  Texture texture;
  const bool long_one = number % 64 == 5;
  texture.log2_width = long_one ? kMaxLog2Size : random.between(0, 3);
  texture.log2_height = random.between(0, 3);
  if (random.below(2) == 0) std::swap(texture.log2_width, texture.log2_height);
  texture.components = config.texels;
  texture.component_bits = config.texel_bits;
  texture.levels.resize(
      static_cast<std::size_t>(random.between(1, std::max(texture.log2_width, texture.log2_height) + 1)));
  for (int level = 0; level <= texture.max_level(); ++level) {
    const int count = texture.width(level) * texture.height(level);
    texture.levels[static_cast<std::size_t>(level)] = random_texels(texture, count, [&] { return random.next(); });
  }
  return texture;
}

DrawWords random_draw(const Shape& config, const std::vector<Texture>& textures, Random& random) {
  DrawWords draw;
  const bool texels = !textures.empty();
  draw.bump = config.bump != 0 && random.below(4) != 0;
  draw.textured = texels && (draw.bump || random.below(4) != 0);
  draw.shadow = config.self_shadow != 0 && random.below(4) != 0;
  draw.exponent_zero = config.glossy != 0 && random.below(8) == 0;
  draw.squarings = config.glossy != 0 ? random.between(0, config.specular_squarings) : 0;
  draw.wrap_u = random.between(0, 2);
  draw.wrap_v = random.between(0, 2);
  if (texels) {
    draw.texture = static_cast<int>(any_of(0, static_cast<std::int64_t>(textures.size()) - 1, random));
    if (random.below(3) == 0) draw.texture = draw.texture / 64 * 64 + 5;
    const Texture& texture = textures[static_cast<std::size_t>(draw.texture)];
    draw.log2_width = texture.log2_width;
    draw.log2_height = texture.log2_height;
    draw.max_level = random.between(0, texture.max_level());
  }
  const std::int64_t one = std::int64_t{1} << config.colour_bits;
  for (auto* colour : {&draw.ambient, &draw.diffuse, &draw.specular})
    for (int c = 0; c < config.count; ++c)
      (*colour)[static_cast<std::size_t>(c)] = static_cast<int>(any_of(0, one, random));
  if (config.has_light_planes != 0) return draw;
  const std::int64_t unit = std::int64_t{1} << config.unit_bits;
  for (int& component : draw.l) component = static_cast<int>(any_of(-unit, unit, random));
  for (int& component : draw.h) component = config.glossy != 0 ? static_cast<int>(any_of(-unit, unit, random)) : 0;
  return draw;
}

// An edge from about `first` to about `last` in so many rows, with a remainder that carries often, never, or always.
EdgeWords random_edge(const Shape& config, std::int64_t first, std::int64_t last, int rows, Random& random) {
  EdgeWords edge;
  edge.w = first;
  edge.step = rows > 1 ? (last - first) / (rows - 1) : any_signed(config.screen_bits + 2, random);
  edge.denominator = any_of(1, (std::int64_t{1} << config.edge_bits) - 1, random);
  edge.remainder = any_of(-edge.denominator, -1, random);
  edge.remainder_step = any_of(0, edge.denominator - 1, random);
  return edge;
}

// The bound of a row after the other.
class Edge {
 public:
  explicit Edge(const EdgeWords& words) : words_(words) {}
  std::int64_t w() const { return words_.w; }
  void step() {
    words_.remainder += words_.remainder_step;
    const bool carry = words_.remainder >= 0;
    if (carry) words_.remainder -= words_.denominator;
    words_.w += words_.step + (carry ? 1 : 0);
  }

 private:
  EdgeWords words_;
};

// The pixels of a packet, or -1 where a row leaves the screen, or a bound its format.
std::int64_t pixels(const Shape& config, const TriangleWords& triangle) {
  const std::int64_t screen = config.screen_size();
  const std::int64_t left = triangle.mirror ? -screen : 0;  // x = -1 - w
  Edge start(triangle.start), end(triangle.end0);
  std::int64_t count = 0;
  for (int row = 0; row < triangle.rows; ++row) {
    if (row > 0) {
      start.step();
      end.step();
    }
    if (row == triangle.rows_end0) end = Edge(triangle.end1);
    if (std::max(std::abs(start.w()), std::abs(end.w())) >= 2 * screen) return -1;
    if (start.w() >= end.w()) continue;
    if (start.w() < left || end.w() > left + screen) return -1;
    count += end.w() - start.w();
  }
  return count;
}

void random_rows(const Shape& config, TriangleWords& triangle, Random& random) {
  const int screen = config.screen_size();
  do {
    triangle.mirror = random.below(2) != 0;
    triangle.rows = random.below(16) == 0 ? screen : random.between(1, std::min(screen, 1 << random.below(7)));
    triangle.y = static_cast<int>(any_of(0, screen - triangle.rows, random));
    triangle.rows_end0 = static_cast<int>(any_of(0, triangle.rows, random));
    const std::int64_t width = random.below(3) == 0 ? screen : 1 << random.below(7);
    const std::int64_t first = triangle.mirror ? -screen : 0;
    const std::int64_t left = first + any_of(0, std::max<std::int64_t>(screen - width, 0), random);
    const auto bound = [&] { return any_of(left, std::min(left + width, first + screen), random); };
    triangle.start = random_edge(config, bound(), bound(), triangle.rows, random);
    triangle.end0 = random_edge(config, bound(), bound(), std::max(triangle.rows_end0, 1), random);
    triangle.end1 = random_edge(config, bound(), bound(), triangle.rows - triangle.rows_end0 + 1, random);
  } while (pixels(config, triangle) < 0 || pixels(config, triangle) > kLargestPacket);
}

// Nothing, a power of two of either sign, or the largest: vectors of these lie along an axis, at the end of a segment
// of a table, or at the end of their format.
std::int64_t special_value(int bits, Random& random) {
  if (random.below(4) == 0) return 0;
  const std::int64_t power = std::int64_t{1} << random.below(static_cast<std::uint32_t>(bits - 1));
  switch (random.below(4)) {
    case 0:
      return (std::int64_t{1} << (bits - 1)) - 1;
    case 1:
      return -(std::int64_t{1} << (bits - 1));
    default:
      return random.below(2) == 0 ? power : -power;
  }
}

// From a plane that stands still to one that runs over its whole range at every pixel.
PlaneWords random_plane(int bits, std::uint32_t slowness, Random& random) {
  const auto gradient = [&] {
    return slowness == 0 ? 0 : any_signed(1 + bits * static_cast<int>(slowness) / 3, random) / 2;
  };
  PlaneWords plane;
  plane.value = any_signed(bits, random);
  plane.row = gradient();
  plane.dw = gradient();
  return plane;
}

void random_planes(const Shape& config, TriangleWords& triangle, Random& random) {
  const bool special = random.below(3) == 0;
  // Vectors come first, three planes each: of all of them only this component is not zero; 3: any may be.
  const std::size_t axis = random.below(6);
  const std::uint32_t slowness = random.below(4);
  std::size_t number = 0;
  for_each_plane(config, [&](const PlaneFormat& format) {
    PlaneWords& plane = triangle.planes[number];
    const int guard = format.is_held ? 0 : config.guard_bits;
    const bool off_axis = axis < 3 && number % 3 != axis;
    ++number;
    if (special) {
      plane = {off_axis ? 0 : special_value(format.width, random) << guard, 0, 0};
    } else {
      plane = random_plane(format.width + guard, format.is_held ? 0 : slowness, random);
    }
  });
  if (config.lod_held != 0)
    triangle.lod = static_cast<int>(any_of(0, (std::int64_t{1} << (4 + config.lod_fraction_bits)) - 1, random));
}

}  // namespace

std::vector<Texture> random_textures(const Config& config, std::uint64_t seed) {
  std::vector<Texture> textures;
  const Shape shape(config);
  if (shape.textured == 0) return textures;
  Random random(seed);
  for (int number = 0; number < kTextures; ++number) textures.push_back(random_texture(shape, number, random));
  return textures;
}

PacketStream random_packets(const Config& config, const std::vector<Texture>& textures, const RandomPackets& wish) {
  const Shape shape(config);
  Random random(wish.seed);
  PacketStream stream;
  for (int draw = 0; draw < wish.draws; ++draw) {
    stream.draw_word.push_back(static_cast<std::uint32_t>(stream.words.size()));
    encode(shape, random_draw(shape, textures, random), stream.words);
    for (double left = wish.fragments / wish.draws; left > 0;) {
      TriangleWords triangle(shape);
      random_rows(shape, triangle, random);
      random_planes(shape, triangle, random);
      left -= 1 + static_cast<double>(pixels(shape, triangle));
      stream.packet_triangle.push_back(static_cast<std::uint32_t>(stream.packet_word.size()));
      stream.packet_word.push_back(static_cast<std::uint32_t>(stream.words.size()));
      stream.packet_draw.push_back(static_cast<std::uint32_t>(draw));
      encode(shape, triangle, stream.words);
    }
  }
  return stream;
}

}  // namespace wrinkle

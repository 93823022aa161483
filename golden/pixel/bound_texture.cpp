#include "golden/pixel/bound_texture.h"

#include <algorithm>

namespace wrinkle {
namespace {

// Stored positions along an axis of 2^n texels, one right of the last included.
int extent(int size, Wrap wrap) {
  if (wrap == Wrap::kMirror) return 2 * size + 1;
  return wrap == Wrap::kClamp ? size + 2 : size + 1;
}

// The texel at a stored position.
int source(int position, int size, Wrap wrap) {
  if (wrap == Wrap::kClamp) return std::clamp(position - 1, 0, size - 1);
  const bool inverted = wrap == Wrap::kMirror && (position & size) != 0;
  return (inverted ? ~position : position) & (size - 1);
}

// A field of at most 32 bits in the words of a texel.
struct Bits {
  int first, count;
};
std::uint32_t bits_of(const std::uint64_t* words, Bits bits) {
  const int word = bits.first / 64, shift = bits.first % 64;
  std::uint64_t value = words[word] >> shift;
  if (shift + bits.count > 64) value |= words[word + 1] << (64 - shift);
  return static_cast<std::uint32_t>(value & ((std::uint64_t{1} << bits.count) - 1));
}

}  // namespace

BoundTexture bind_texture(const Texture& texture, int bump_components, Wrap wrap_u, Wrap wrap_v) {
  BoundTexture bound;
  bound.bump_components = bump_components;
  std::vector<Bits> planes;
  for (int first = 0; first < texture.components;) {
    const int group_end = first < bump_components ? bump_components : texture.components;
    const int end = std::min(first + kPlaneComponents, group_end);
    planes.push_back({first * texture.component_bits, (end - first) * texture.component_bits});
    first = end;
  }
  bound.planes.resize(planes.size());
  const auto words = static_cast<std::size_t>(texture.texel_words());
  for (std::size_t level = 0; level < texture.levels.size(); ++level) {
    const int width = texture.width(static_cast<int>(level)), height = texture.height(static_cast<int>(level));
    const int columns = extent(width, wrap_u), rows = extent(height, wrap_v);
    bound.offset[level] = static_cast<std::int32_t>(bound.planes.empty() ? 0 : bound.planes[0].size() / 2);
    bound.stride[level] = columns;
    for (int y = 0; y + 1 < rows; ++y) {
      for (int x = 0; x < columns; ++x) {
        for (int below = 0; below < 2; ++below) {
          const int index = source(y + below, height, wrap_v) * width + source(x, width, wrap_u);
          const std::uint64_t* texel = &texture.levels[level][static_cast<std::size_t>(index) * words];
          for (std::size_t p = 0; p < planes.size(); ++p) bound.planes[p].push_back(bits_of(texel, planes[p]));
        }
      }
    }
  }
  return bound;
}

}  // namespace wrinkle

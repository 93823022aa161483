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

}  // namespace

BoundTexture bind_texture(const Texture& texture, Wrap wrap_u, Wrap wrap_v) {
  BoundTexture bound;
  const bool has_second = texture.components > 3;
  const int first_components = has_second ? texture.components - 3 : texture.components;
  const int first_bits = first_components * texture.component_bits;
  const std::uint64_t first_mask = (std::uint64_t{1} << first_bits) - 1;
  for (std::size_t level = 0; level < texture.levels.size(); ++level) {
    const int width = texture.width(static_cast<int>(level)), height = texture.height(static_cast<int>(level));
    const int columns = extent(width, wrap_u), rows = extent(height, wrap_v);
    bound.offset[level] = static_cast<std::int32_t>(bound.low.size() / 2);
    bound.stride[level] = columns;
    for (int y = 0; y + 1 < rows; ++y) {
      for (int x = 0; x < columns; ++x) {
        for (int below = 0; below < 2; ++below) {
          const int index = source(y + below, height, wrap_v) * width + source(x, width, wrap_u);
          const std::uint64_t texel = texture.levels[level][static_cast<std::size_t>(index)];
          bound.low.push_back(static_cast<std::uint32_t>(texel & first_mask));
          if (has_second) bound.high.push_back(static_cast<std::uint32_t>(texel >> first_bits));
        }
      }
    }
  }
  return bound;
}

}  // namespace wrinkle

#include "sim/scene/textures.h"

#include <algorithm>

#include "golden/texel/quantise.h"

namespace wrinkle {
namespace {

// The levels of an image whose codes are limited to [0, 1]; none without an image.
MipChain clamped_mips(const std::optional<Image>& image, Wraps wraps) {
  if (!image) return {};
  Grid<Vec3> grid = resample_to_power_of_two(colours_of(*image), wraps);
  for (Vec3& c : grid.samples) c = {std::clamp(c.x, 0.0, 1.0), std::clamp(c.y, 0.0, 1.0), std::clamp(c.z, 0.0, 1.0)};
  return colour_mips(std::move(grid));
}

}  // namespace

Grid<Vec3> colours_of(const Image& image) {
  Grid<Vec3> grid(image.width, image.height);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      grid.at(x, y) = {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
    }
  }
  return grid;
}

Grid<double> heights_of(const Image& image, double scale) {
  Grid<double> grid(image.width, image.height);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) grid.at(x, y) = scale * static_cast<double>(image.at(x, y, 0));
  }
  return grid;
}

MipChain normals_of(const Image& image, double scale, Wraps wraps) {
  return normal_mips(normal_map_from_image(resample_to_power_of_two(colours_of(image), wraps), scale));
}

Grid<double> regular_heights(const Grid<double>& height, Wraps wraps) {
  return resample_to_power_of_two(height, wraps);
}

MipChain normals_from_heights(const Grid<double>& height, const Surface& surface, MipMethod mip, Wraps wraps) {
  return mip == MipMethod::kHeights ? normal_mips(height, surface, wraps)
                                    : normal_mips(normal_map(height, surface, wraps));
}

MipChain normals_from_heights(const Grid<double>& height, double k, MipMethod mip, Wraps wraps) {
  return mip == MipMethod::kHeights ? normal_mips(height, k, wraps) : normal_mips(normal_map(height, k, wraps));
}

MipChain object_normals_from_heights(const Grid<double>& height, const Surface& surface, MipMethod mip, Wraps wraps) {
  if (mip == MipMethod::kNormals) return normal_mips(out_of_tangent_space(normal_map(height, surface, wraps), surface));
  MipChain chain = normal_mips(height, surface, wraps);
  for (NormalMap& level : chain) level = out_of_tangent_space(level, surface);
  return chain;
}

Image gloss_of(Image image, const std::string& place, Notes& notes) {
  if (image.channels == 1) return image;
  bool coloured = false;
  Image gloss{image.width, image.height, 1, {}};
  gloss.pixels.reserve(image.pixels.size() / 3);
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    const float r = image.pixels[i], g = image.pixels[i + 1], b = image.pixels[i + 2];
    const bool grey = r == g && g == b;
    coloured = coloured || !grey;
    gloss.pixels.push_back(grey ? r : luminance(r, g, b));
  }
  if (coloured) notes.push_back(place + ": in colour; its luminance is taken for the gloss, which has no colour");
  return gloss;
}

std::shared_ptr<const ExactTexture> make_texture(const MipChain& normals, const std::optional<Image>& decal,
                                                 const std::optional<Image>& gloss, Wraps wraps) {
  return std::make_shared<const ExactTexture>(
      assemble(normals, clamped_mips(decal, wraps), clamped_mips(gloss, wraps), wraps));
}

}  // namespace wrinkle

#include "sim/scene/textures.h"

#include <algorithm>

#include "golden/texel/quantise.h"

namespace wrinkle {

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

std::shared_ptr<const ExactTexture> make_texture(const MipChain& normals, const std::optional<Image>& decal,
                                                 Wraps wraps) {
  MipChain colours;
  if (decal) {
    Grid<Vec3> grid = resample_to_power_of_two(colours_of(*decal), wraps);
    for (Vec3& c : grid.samples) {
      c = {std::clamp(c.x, 0.0, 1.0), std::clamp(c.y, 0.0, 1.0), std::clamp(c.z, 0.0, 1.0)};
    }
    colours = colour_mips(std::move(grid));
  }
  return std::make_shared<const ExactTexture>(assemble(normals, colours, wraps));
}

}  // namespace wrinkle

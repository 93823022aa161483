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

MipChain normals_of(const Image& image, double scale) {
  return normal_mips(normal_map_from_image(resample_to_power_of_two(colours_of(image)), scale));
}

Grid<double> regular_heights(const Grid<double>& height) { return resample_to_power_of_two(height); }

MipChain normals_from_heights(const Grid<double>& height, const Surface& surface, MipMethod mip) {
  return mip == MipMethod::kHeights ? normal_mips(height, surface) : normal_mips(normal_map(height, surface));
}

MipChain normals_from_heights(const Grid<double>& height, double k, MipMethod mip) {
  return mip == MipMethod::kHeights ? normal_mips(height, k) : normal_mips(normal_map(height, k));
}

MipChain object_normals_from_heights(const Grid<double>& height, const Surface& surface, MipMethod mip) {
  if (mip == MipMethod::kNormals) return normal_mips(out_of_tangent_space(normal_map(height, surface), surface));
  MipChain chain = normal_mips(height, surface);
  for (NormalMap& level : chain) level = out_of_tangent_space(level, surface);
  return chain;
}

std::shared_ptr<const ExactTexture> make_texture(const MipChain& normals, const std::optional<Image>& decal) {
  MipChain colours;
  if (decal) {
    Grid<Vec3> grid = resample_to_power_of_two(colours_of(*decal));
    for (Vec3& c : grid.samples) {
      c = {std::clamp(c.x, 0.0, 1.0), std::clamp(c.y, 0.0, 1.0), std::clamp(c.z, 0.0, 1.0)};
    }
    colours = colour_mips(std::move(grid));
  }
  return std::make_shared<const ExactTexture>(assemble(normals, colours));
}

}  // namespace wrinkle

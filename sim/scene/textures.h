// From images and height fields to the textures of objects.
#pragma once

#include <memory>
#include <optional>

#include "golden/texel/grid.h"
#include "golden/texel/normal_map.h"
#include "golden/texel/texture.h"
#include "sim/scene/image.h"

namespace wrinkle {

Grid<Vec3> colours_of(const Image& image);
// The first channel, times `scale`.
Grid<double> heights_of(const Image& image, double scale);

// The chain of a normal map's image [tangent space, green up], brought to powers of two, filtered and renormalized.
MipChain normals_of(const Image& image, double scale, Wraps wraps);

// Heights brought to powers of two.
Grid<double> regular_heights(const Grid<double>& height, Wraps wraps);

// How the levels above 0 come about: `normals` filters and renormalizes, `heights` filters the field itself.
enum class MipMethod { kNormals, kHeights };
MipChain normals_from_heights(const Grid<double>& height, const Surface& surface, MipMethod mip, Wraps wraps);
MipChain normals_from_heights(const Grid<double>& height, double k, MipMethod mip, Wraps wraps);
// The same in the space that the surface lies in, not in that of its tangents.
MipChain object_normals_from_heights(const Grid<double>& height, const Surface& surface, MipMethod mip, Wraps wraps);

// The image of a gloss map as one channel: an image in colour, which is noted, is taken as its luminance.
Image gloss_of(Image image, const std::string& place, Notes& notes);

// Each may be absent. Of a gloss the first channel is read.
std::shared_ptr<const ExactTexture> make_texture(const MipChain& normals, const std::optional<Image>& decal,
                                                 const std::optional<Image>& gloss, Wraps wraps);

}  // namespace wrinkle

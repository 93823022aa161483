// Images through OpenImageIO, with every header judged before memory is taken for it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "golden/vector.h"
#include "sim/input_error.h"
#include "sim/scene/notes.h"

namespace wrinkle {

inline constexpr int kMaximumImageSide = 16384;
inline constexpr std::uint64_t kMaximumImageBytes = std::uint64_t{1} << 28;  // as floats

// Row-major from the upper left corner, channels interleaved: one (grey) or three (red, green, blue). Integer codes are
// c / (2^n - 1), in [0, 1]; floats are as stored and finite. Codes stay codes: nothing is converted from sRGB, and
// nothing is multiplied by alpha, which is dropped.
struct Image {
  int width = 0, height = 0, channels = 0;
  std::vector<float> pixels;

  float at(int x, int y, int channel) const {
    const auto w = static_cast<std::size_t>(width), c = static_cast<std::size_t>(channels);
    return pixels[(static_cast<std::size_t>(y) * w + static_cast<std::size_t>(x)) * c +
                  static_cast<std::size_t>(channels == 1 ? 0 : channel)];
  }
};

//
// Where an OpenEXR file has a display window other than its data, the display window is the image, 0 outside the data.
Image read_image(const std::filesystem::path& path);
// An image file held in memory, of a format known by its first bytes. `place` is where it was embedded.
Image read_image(const std::string& bytes, const Place& place);
// The same for images of normals: of two channels the third is made, the length being 1; one channel is an error;
// equal ones are noted.
Image read_normal_map(const std::filesystem::path& path, Notes& notes);
Image read_normal_map(const std::string& bytes, const Place& place, Notes& notes);

// Luminance by the weights of ITU-R BT.709.
float luminance(float r, float g, float b);

// The alpha of an image as its one channel; no pixels where the file has none.
Image read_alpha(const std::filesystem::path& path);
Image read_alpha(const std::string& bytes, const Place& place);

// Mean of each channel; grey gives three equal ones.
Vec3 mean_colour(const Image& image);

// Whether an image given as a bump map holds normals, not heights: it is coloured (mean |red - blue| over 0.05), leans
// to blue (mean over 0.65), and its decoded vectors have a mean length within 0.2 of 1.
bool looks_like_normal_map(const Image& image);

}  // namespace wrinkle

// What is written as a picture is what is read again, by libpng or by OpenImageIO.
#include "sim/picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "sim/scene/image.h"

namespace wrinkle {
namespace {

// All codes, the halves between them, and what lies outside of [0, 1].
Picture ramp() {
  Picture picture(32, 16, {"R", "G", "B"});
  for (std::size_t i = 0; i < picture.data.size(); ++i)
    picture.data[i] = (float(i) - 20) / (2 * 255) + (i % 3 == 0 ? 0.0001F : 0);
  return picture;
}

class Written : public testing::TestWithParam<const char*> {};

TEST_P(Written, CodesAreTheNearest) {
  const Picture picture = ramp();
  const auto path = std::filesystem::path(testing::TempDir()) / (std::string("wrinkle_ramp") + GetParam());
  write_picture(path, picture);
  const Image image = read_image(path);
  ASSERT_EQ(image.pixels.size(), picture.data.size());
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const float code = 255 * std::min(std::max(picture.data[i], 0.0F), 1.0F);
    EXPECT_NEAR(255 * image.pixels[i], code, 0.5001) << i;
    EXPECT_NEAR(255 * image.pixels[i], std::round(255 * image.pixels[i]), 1e-4);
  }
  std::filesystem::remove(path);
}

INSTANTIATE_TEST_SUITE_P(Endings, Written, testing::Values(".png", ".tif", ".bmp"),
                         [](const auto& ending) { return std::string(ending.param + 1); });

TEST(Written, PngInMemoryIsTheFile) {
  const auto path = std::filesystem::path(testing::TempDir()) / "wrinkle_memory.png";
  write_picture(path, ramp());
  const Image file = read_image(path), memory = read_image(encode_png(ramp()), Place{"memory"});
  EXPECT_EQ(file.pixels, memory.pixels);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace wrinkle

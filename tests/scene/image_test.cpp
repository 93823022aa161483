// Images: what is read of good ones, and what is said of bad ones.
#include "sim/scene/image.h"

#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <limits>

#include "sim/scene/scene_reader.h"
#include "sim/scene/textures.h"
#include "support.h"

namespace wrinkle::test {
namespace {

// Writes floats in [0, 1] as `type`, by the extension's format.
void write_image(const fs::path& path, int width, int height, int channels, const std::vector<float>& pixels,
                 OIIO::TypeDesc type = OIIO::TypeDesc::UINT8) {
  const auto output = OIIO::ImageOutput::create(path.string());
  ASSERT_TRUE(output);
  ASSERT_TRUE(output->open(path.string(), OIIO::ImageSpec(width, height, channels, type))) << output->geterror();
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, pixels.data())) << output->geterror();
  ASSERT_TRUE(output->close());
}

std::vector<float> ramp(int count) {
  std::vector<float> values(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) values[static_cast<std::size_t>(i)] = static_cast<float>(i % 256) / 255.0F;
  return values;
}

std::uint32_t crc(const std::string& bytes) {
  std::uint32_t c = 0xffffffff;
  for (const char byte : bytes) {
    c ^= static_cast<unsigned char>(byte);
    for (int i = 0; i < 8; ++i) c = (c & 1) != 0 ? 0xedb88320 ^ (c >> 1) : c >> 1;
  }
  return ~c;
}

std::string big_endian(std::uint32_t value) {
  return {static_cast<char>(value >> 24), static_cast<char>(value >> 16), static_cast<char>(value >> 8),
          static_cast<char>(value)};
}

// A PNG whose header claims another size than the image has, with a right check sum.
std::string with_header(std::string png, std::uint32_t width, std::uint32_t height) {
  png.replace(16, 8, big_endian(width) + big_endian(height));
  png.replace(29, 4, big_endian(crc(png.substr(12, 17))));
  return png;
}

class Images : public ::testing::Test {
 protected:
  std::string png() {
    const fs::path path = folder_.path() / "good.png";
    write_image(path, 8, 8, 3, ramp(8 * 8 * 3));
    return read_bytes(path);
  }
  Folder folder_;
};

TEST_F(Images, CodesComeBackAsTheyAre) {
  write_image(folder_.path() / "a.png", 16, 16, 1, ramp(256));
  const Image grey = read_image(folder_.path() / "a.png");
  EXPECT_EQ(grey.channels, 1);
  for (int i = 0; i < 256; ++i) {
    ASSERT_FLOAT_EQ(grey.pixels[static_cast<std::size_t>(i)], static_cast<float>(i) / 255.0F) << i;
  }
}

TEST_F(Images, AlphaIsDroppedWithoutMultiplying) {
  const std::array<float, 4> pixel{1.0F, 0.6F, 0.2F, 0.0F};
  const auto output = OIIO::ImageOutput::create("b.png");
  OIIO::ImageSpec spec(1, 1, 4, OIIO::TypeDesc::UINT8);
  spec["oiio:UnassociatedAlpha"] = 1;
  ASSERT_TRUE(output->open((folder_.path() / "b.png").string(), spec));
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, pixel.data()));
  ASSERT_TRUE(output->close());
  const Image image = read_image(folder_.path() / "b.png");
  EXPECT_EQ(image.channels, 3);
  EXPECT_EQ(image.at(0, 0, 0), 1.0F);
  EXPECT_FLOAT_EQ(image.at(0, 0, 1), 153.0F / 255.0F);
}

TEST_F(Images, FromMemoryAsFromFile) {
  const std::string bytes = png();
  EXPECT_EQ(read_image(bytes, Place{"model.glb"}).pixels, read_image(folder_.path() / "good.png").pixels);
}

TEST_F(Images, NormalMapsAreKnownByTheirColours) {
  const Image tiles = read_image(fs::path(WRINKLE_SOURCE_DIR) / "sim/scenes/maps/tiles.webp");
  EXPECT_TRUE(looks_like_normal_map(tiles));
  EXPECT_FALSE(looks_like_normal_map(Image{8, 8, 3, std::vector<float>(192, 0.9F)}));
  EXPECT_FALSE(looks_like_normal_map(Image{8, 8, 1, std::vector<float>(64, 0.9F)}));
}

TEST_F(Images, TwoChannelsOfNormalsGetTheirThird) {
  const fs::path path = folder_.path() / "two.exr";
  write_image(path, 1, 2, 2, {0.8F, 0.5F, 1.0F, 1.0F}, OIIO::TypeDesc::FLOAT);
  Notes notes;
  const Image image = read_normal_map(path, notes);
  ASSERT_EQ(image.channels, 3);
  EXPECT_NEAR(image.at(0, 0, 2), (std::sqrt(1 - 0.6 * 0.6) + 1) / 2, 1e-6);
  EXPECT_NEAR(image.at(0, 1, 2), 0.5, 1e-6);  // longer than 1: at the rim
  EXPECT_TRUE(notes.empty());
}

TEST_F(Images, GreyIsNoNormalMap) {
  Notes notes;
  write_image(folder_.path() / "grey.png", 4, 4, 1, ramp(16));
  expect_error([&] { read_normal_map(folder_.path() / "grey.png", notes); }, {"grey.png", "one channel", "height"});
  write_image(folder_.path() / "alpha.png", 4, 4, 2, ramp(32));
  expect_error([&] { read_normal_map(folder_.path() / "alpha.png", notes); }, {"alpha.png", "one channel"});
  write_image(folder_.path() / "same.png", 2, 1, 3, {0.25F, 0.25F, 0.25F, 0.75F, 0.75F, 0.75F});
  EXPECT_EQ(read_normal_map(folder_.path() / "same.png", notes).channels, 3);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_THAT(notes[0], ::testing::HasSubstr("same.png"));
}

TEST_F(Images, ChannelsAreTakenByName) {
  OIIO::ImageSpec spec(1, 1, 6, OIIO::TypeDesc::FLOAT);
  spec.channelnames = {"A", "B", "G", "R", "Z", "id"};
  const auto output = OIIO::ImageOutput::create("a.exr");
  const std::array<float, 6> pixel{0.1F, 0.2F, 0.3F, 0.4F, 0.5F, 0.6F};
  ASSERT_TRUE(output->open((folder_.path() / "a.exr").string(), spec));
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, pixel.data()));
  ASSERT_TRUE(output->close());
  const Image image = read_image(folder_.path() / "a.exr");
  EXPECT_EQ(image.pixels, (std::vector<float>{0.4F, 0.3F, 0.2F}));
  spec.channelnames = {"a", "b", "c", "d", "e", "f"};
  ASSERT_TRUE(output->open((folder_.path() / "b.exr").string(), spec));
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, pixel.data()));
  ASSERT_TRUE(output->close());
  expect_error([&] { read_image(folder_.path() / "b.exr"); }, {"b.exr", "6 channels", "R, G and B"});
}

// The display window is the image: what the data window lacks is 0, what it has beyond is cut.
TEST_F(Images, DisplayWindowsOfOpenExr) {
  OIIO::ImageSpec spec(2, 2, 1, OIIO::TypeDesc::FLOAT);
  spec.x = 1;
  spec.y = -1;
  spec.full_x = spec.full_y = 0;
  spec.full_width = 3;
  spec.full_height = 2;
  const auto output = OIIO::ImageOutput::create("a.exr");
  const std::array<float, 4> pixels{1, 2, 3, 4};
  ASSERT_TRUE(output->open((folder_.path() / "a.exr").string(), spec));
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()));
  ASSERT_TRUE(output->close());
  const Image image = read_image(folder_.path() / "a.exr");
  ASSERT_EQ(image.width, 3);
  ASSERT_EQ(image.height, 2);
  EXPECT_EQ(image.pixels, (std::vector<float>{0, 3, 4, 0, 0, 0}));
}

// A gamma and an sRGB chunk say how codes are to be seen, not what they are.
TEST_F(Images, ColourProfilesChangeNoCode) {
  const std::string plain = png();
  const auto chunk = [](const std::string& type, const std::string& data) {
    return big_endian(static_cast<std::uint32_t>(data.size())) + type + data + big_endian(crc(type + data));
  };
  const Image expected = read_image(folder_.path() / "good.png");
  for (const std::string& extra :
       {chunk("gAMA", big_endian(100000)), chunk("gAMA", big_endian(22727)), chunk("sRGB", std::string(1, '\0'))}) {
    std::string marked = plain;
    marked.insert(33, extra);  // behind the header
    EXPECT_EQ(read_image(folder_.write("marked.png", marked)).pixels, expected.pixels);
    EXPECT_EQ(read_image(marked, Place{"model.glb"}).pixels, expected.pixels);
  }
}

TEST_F(Images, FormatsFromMemoryAsFromFile) {
  for (const char* name : {"a.png", "a.exr", "a.tif", "a.bmp", "a.webp", "a.hdr"}) {
    SCOPED_TRACE(name);
    write_image(folder_.path() / name, 8, 8, 3, ramp(8 * 8 * 3));
    const std::string bytes = read_bytes(folder_.path() / name);
    EXPECT_EQ(read_image(bytes, Place{"model.glb"}).pixels, read_image(folder_.path() / name).pixels);
  }
  expect_error([&] { read_image(std::string("no image"), Place{"model.glb"}); }, {"model.glb", "no image format"});
}

TEST_F(Images, Extremes49PngTruncatedAtEveryByte) {
  const std::string whole = png();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    SCOPED_TRACE(size);
    const fs::path path = folder_.write("cut.png", whole.substr(0, size));
    expect_error([&] { read_image(path); }, {"cut.png: "});
  }
  EXPECT_EQ(read_image(folder_.write("cut.png", whole)).width, 8);
}

TEST_F(Images, Extremes49JpegTruncatedAtEveryByte) {
  write_image(folder_.path() / "good.jpg", 16, 16, 3, ramp(768));
  const std::string whole = read_bytes(folder_.path() / "good.jpg");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    SCOPED_TRACE(size);
    const fs::path path = folder_.write("cut.jpg", whole.substr(0, size));
    expect_error([&] { read_image(path); }, {"cut.jpg: "});
  }
}

TEST_F(Images, Extremes49ExrTruncated) {
  write_image(folder_.path() / "good.exr", 8, 8, 3, ramp(192), OIIO::TypeDesc::FLOAT);
  const std::string whole = read_bytes(folder_.path() / "good.exr");
  for (std::size_t size = 1; size < whole.size(); size += 7) {
    SCOPED_TRACE(size);
    const fs::path path = folder_.write("cut.exr", whole.substr(0, size));
    expect_error([&] { read_image(path); }, {"cut.exr: "});
  }
}

TEST_F(Images, Extremes49WrongMagic) {
  std::string bytes = png();
  bytes[0] = 'x';
  expect_error([&] { read_image(folder_.write("wrong.png", bytes)); }, {"wrong.png: ", "no image"});
  expect_error([&] { read_image(folder_.write("text.png", "this is text")); }, {"text.png: ", "no image"});
  expect_error([&] { read_image(bytes, Place{"model.glb", 0, 0, "/images/0"}); }, {"model.glb: /images/0", "PNG"});
  expect_error([&] { read_image(folder_.write("empty.png", "")); }, {"empty.png", "empty"});
}

TEST_F(Images, Extremes49HeaderLiesWithoutMemoryForIt) {
  const std::string whole = png();
  const long before = peak_kilobytes();
  for (const auto& [width, height] : std::vector<std::pair<std::uint32_t, std::uint32_t>>{{0, 8},
                                                                                          {8, 0},
                                                                                          {0, 0},
                                                                                          {0x7fffffff, 1},
                                                                                          {0xffffffff, 0xffffffff},
                                                                                          {65536, 32768},
                                                                                          {16385, 1},
                                                                                          {16384, 16384}}) {
    const fs::path path = folder_.write("lie.png", with_header(whole, width, height));
    expect_error([&] { read_image(path); }, {"lie.png: "});
  }
  EXPECT_LT(peak_kilobytes() - before, 64 * 1024);
}

TEST_F(Images, Extremes64HeaderClaimsTwoToThe31Pixels) {
  const fs::path path = folder_.write("claim.png", with_header(png(), 16384, 16384));
  const long before = peak_kilobytes();
  expect_error([&] { read_image(path); }, {"claim.png: ", "16384 x 16384", "at most 268435456"});
  expect_error([&] { read_image(folder_.write("claim.png", with_header(png(), 65536, 32768))); },
               {"claim.png: ", "65536", "16384 on a side"});
  EXPECT_LT(peak_kilobytes() - before, 64 * 1024);
}

TEST_F(Images, HeaderTallerThanTheData) {
  const fs::path path = folder_.write("tall.png", with_header(png(), 8, 4096));
  expect_error([&] { read_image(path); }, {"tall.png: ", "cannot be decoded"});
}

TEST_F(Images, Extremes48FloatsThatAreNoNumbers) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e38F}) {
    std::vector<float> pixels = ramp(192);
    pixels[3 * (8 * 2 + 5) + 1] = bad;
    write_image(folder_.path() / "bad.exr", 8, 8, 3, pixels, OIIO::TypeDesc::FLOAT);
    expect_error([&] { read_image(folder_.path() / "bad.exr"); }, {"bad.exr: ", "at pixel (5, 2)"});
  }
}

TEST_F(Images, Extremes51SizesThatAreNoPowersOfTwo) {
  for (const auto& [width, height, log2_width, log2_height] :
       std::vector<std::array<int, 4>>{{5, 3, 3, 2}, {1, 1, 0, 0}, {100, 64, 7, 6}}) {
    write_image(folder_.path() / "map.png", width, height, 3,
                std::vector<float>(static_cast<std::size_t>(3 * width * height), 0.5F));
    const fs::path scene = folder_.write("s.toml", "[[objects]]\nmesh = \"patch\"\nnormal_map = \"map.png\"\n");
    const auto texture = read_scene(scene).objects[0].texture;
    EXPECT_EQ(texture->log2_width, log2_width);
    EXPECT_EQ(texture->log2_height, log2_height);
  }
}

TEST_F(Images, Extremes64OneBy16384) {
  write_image(folder_.path() / "map.png", 1, 16384, 3, std::vector<float>(3 * 16384, 0.5F));
  const fs::path scene = folder_.write("s.toml", "[[objects]]\nmesh = \"patch\"\nnormal_map = \"map.png\"\n");
  const auto texture = read_scene(scene).objects[0].texture;
  EXPECT_EQ(texture->log2_width, 0);
  EXPECT_EQ(texture->log2_height, 12);  // what the hardware addresses
}

}  // namespace
}  // namespace wrinkle::test

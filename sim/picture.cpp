#include "sim/picture.h"

#include <fmt/format.h>
#include <png.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "sim/input_error.h"
#include "sim/oiio/library.h"
#include "sim/scene/files.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

// A name beside `path` with the same ending, which the format is chosen by.
fs::path temporary_beside(const fs::path& path) {
  fs::path name = path;
  name.replace_filename(fmt::format(".{}.{}{}", path.stem().string(), getpid(), path.extension().string()));
  return name;
}

// Runs `write` on a temporary name and moves the result to `path`; removes it when `write` throws.
template <class Write>
void write_whole(const fs::path& path, Write write) {
  check_not_read(path);
  std::error_code error;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), error);
  const fs::path temporary = temporary_beside(path);
  try {
    write(temporary);
    fs::rename(temporary, path, error);
    if (error) throw InputError(Place{path.string()}, "cannot be written: " + error.message());
  } catch (...) {
    fs::remove(temporary, error);
    throw;
  }
}

// The codes of a picture of three channels, as libpng takes them.
std::vector<std::uint8_t> codes_of(const Picture& image) {
  std::vector<std::uint8_t> codes(image.data.size());
  std::transform(image.data.begin(), image.data.end(), codes.begin(),
                 [](float value) { return std::uint8_t(255 * std::clamp(value, 0.0F, 1.0F) + 0.5F); });
  return codes;
}

void write_with_openimageio(const fs::path& path, const fs::path& temporary, const Picture& image) {
  if (!oiio::library().writes(temporary.string()))
    throw InputError(Place{path.string()}, "an unknown ending", ".png or .exr");
  const oiio::View view{image.width, image.height, int(image.channels.size()), const_cast<float*>(image.data.data())};
  const std::string error =
      oiio::library().write(temporary.string(), view, image.channels, extension_of(path) == ".exr");
  if (!error.empty()) throw InputError(Place{path.string()}, "cannot be written: " + error);
}

}  // namespace

void write_picture(const fs::path& path, const Picture& image) {
  // Most pictures are PNG files of colours. They are written without OpenImageIO, which takes long to load.
  if (extension_of(path) == ".png" && image.channels.size() == 3) return write_text(path, encode_png(image));
  write_whole(path, [&](const fs::path& temporary) { write_with_openimageio(path, temporary, image); });
}

std::string encode_png(const Picture& image) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = png_uint_32(image.width);
  png.height = png_uint_32(image.height);
  png.format = PNG_FORMAT_RGB;
  const std::vector<std::uint8_t> codes = codes_of(image);
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(png), '\0');
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&png, bytes.data(), &size, 0, codes.data(), 0, nullptr) == 0)
    throw std::runtime_error(std::string("a picture cannot be encoded: ") + png.message);
  bytes.resize(size);
  return bytes;
}

void write_text(const fs::path& path, const std::string& text) {
  write_whole(path, [&](const fs::path& temporary) {
    errno = 0;
    std::ofstream file(temporary, std::ios::binary);
    file << text;
    file.close();
    if (!file) throw InputError(Place{path.string()}, std::string("cannot be written: ") + std::strerror(errno));
  });
}

PictureDifference compare(const Picture& a, const Picture& b, const std::vector<std::uint8_t>& mask) {
  PictureDifference result;
  double sum = 0;
  const std::size_t n = a.channels.size();
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (!mask[i]) continue;
    ++result.pixels;
    double worst = 0;
    for (std::size_t c = 0; c < n; ++c) {
      const double error = std::abs(double(a.data[n * i + c]) - double(b.data[n * i + c]));
      sum += error * error;
      worst = std::max(worst, error);
    }
    result.different += worst > 0;
    result.max_error = std::max(result.max_error, worst);
  }
  if (sum > 0) result.psnr_db = std::min(kPsnrOfEqual, -10 * std::log10(sum / (double(result.pixels) * double(n))));
  return result;
}

Picture difference_picture(const Picture& a, const Picture& b, double gain) {
  Picture image(a.width, a.height, a.channels);
  for (std::size_t i = 0; i < image.data.size(); ++i)
    image.data[i] = float(std::clamp(0.5 + gain * (double(a.data[i]) - double(b.data[i])), 0.0, 1.0));
  return image;
}

}  // namespace wrinkle

#include "sim/picture.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "sim/input_error.h"
#include "sim/scene/files.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

// A name beside `path` with the same ending, which OpenImageIO chooses the format by.
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

// Writes the picture through `output`, which is to make `name`; false where it cannot; output.geterror() says why.
bool encode(OIIO::ImageOutput& output, const std::string& name, const Picture& image, OIIO::TypeDesc type) {
  OIIO::ImageSpec spec(image.width, image.height, int(image.channels.size()), type);
  spec.channelnames = image.channels;
  return output.open(name, spec) && output.write_image(OIIO::TypeDesc::FLOAT, image.data.data()) && output.close();
}

}  // namespace

void write_picture(const fs::path& path, const Picture& image) {
  write_whole(path, [&](const fs::path& temporary) {
    auto output = OIIO::ImageOutput::create(temporary.string());
    if (!output) {
      OIIO::geterror();
      throw InputError(Place{path.string()}, "an unknown ending", ".png or .exr");
    }
    const auto type = extension_of(path) == ".exr" ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
    if (!encode(*output, temporary.string(), image, type))
      throw InputError(Place{path.string()}, "cannot be written: " + output->geterror());
  });
}

std::string encode_png(const Picture& image) {
  OIIO::Filesystem::IOVecOutput memory;
  auto output = OIIO::ImageOutput::create("png", &memory);
  if (!output || !encode(*output, "memory.png", image, OIIO::TypeDesc::UINT8))
    throw std::runtime_error("a picture cannot be encoded: " + (output ? output->geterror() : OIIO::geterror()));
  return {memory.buffer().begin(), memory.buffer().end()};
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

#include "sim/scene/image.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>

#include "sim/scene/files.h"

namespace wrinkle {
namespace {

using namespace std::string_view_literals;

bool is_png(std::string_view bytes) { return bytes.starts_with("\x89PNG\r\n\x1a\n"sv); }
bool is_jpeg(std::string_view bytes) { return bytes.starts_with("\xff\xd8\xff"sv); }
bool is_webp(std::string_view bytes) { return bytes.starts_with("RIFF"sv) && bytes.substr(0, 12).ends_with("WEBP"sv); }

std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

// Decoders fill what is missing with grey and say nothing: a file that was cut short is known by its end.
void check_complete(std::string_view bytes, const Place& place) {
  bool complete = true;
  if (is_png(bytes)) complete = bytes.rfind("IEND\xae\x42\x60\x82"sv) != std::string_view::npos;
  if (is_jpeg(bytes)) {
    const std::size_t scan = bytes.rfind("\xff\xda"sv), end = bytes.rfind("\xff\xd9"sv);
    complete = scan != std::string_view::npos && end != std::string_view::npos && scan < end;
  }
  if (is_webp(bytes)) complete = std::uint64_t{little_endian(bytes, 4)} + 8 <= bytes.size();
  if (!complete) throw InputError(place, "an image that is cut short", "the whole file");
}

std::string oiio_error(const OIIO::ImageInput* input) {
  std::string text = input != nullptr ? input->geterror() : std::string();
  const std::string global = OIIO::geterror();  // always fetched, or it is printed at exit
  if (text.empty()) text = global;
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text.empty() ? "not an image of a known format" : text;
}

void check_header(const OIIO::ImageSpec& spec, const Place& place) {
  const std::string size = std::to_string(spec.width) + " x " + std::to_string(spec.height);
  if (spec.width < 1 || spec.height < 1) throw InputError(place, "an image of " + size + " pixels", "at least 1 x 1");
  if (spec.width > kMaximumImageSide || spec.height > kMaximumImageSide) {
    throw InputError(place, "an image of " + size + " pixels", "at most 16384 on a side");
  }
  if (spec.depth > 1) throw InputError(place, "a volume of depth " + std::to_string(spec.depth), "an image");
  if (spec.deep) throw InputError(place, "a deep image", "one value for each pixel and channel");
  if (spec.nchannels < 1) throw InputError(place, "an image without channels", "one to four");
  const auto channels = static_cast<std::uint64_t>(spec.nchannels >= 3 ? 3 : 1);
  const std::uint64_t bytes =
      channels * static_cast<std::uint64_t>(spec.width) * static_cast<std::uint64_t>(spec.height) * sizeof(float);
  if (bytes > kMaximumImageBytes) {
    throw InputError(place, "an image of " + size + " pixels, " + std::to_string(bytes) + " bytes as floats",
                     "at most " + std::to_string(kMaximumImageBytes));
  }
}

void check_finite(const Image& image, const Place& place) {
  const auto bad = std::find_if(image.pixels.begin(), image.pixels.end(),
                                [](float value) { return !std::isfinite(value) || std::abs(value) > 1e6F; });
  if (bad == image.pixels.end()) return;
  const auto pixel = (bad - image.pixels.begin()) / image.channels;
  throw InputError(place,
                   (std::isnan(*bad)   ? "NaN"
                    : std::isinf(*bad) ? "infinity"
                                       : std::to_string(*bad)) +
                       " at pixel (" + std::to_string(pixel % image.width) + ", " +
                       std::to_string(pixel / image.width) + ")",
                   "finite values of at most 1e6");
}

// Pixel values as floats; grey with alpha, and whatever has fewer than three channels, gives its first channel.
Image decode(OIIO::ImageInput& input, const Place& place) {
  check_header(input.spec(), place);
  Image image;
  image.width = input.spec().width;
  image.height = input.spec().height;
  image.channels = input.spec().nchannels >= 3 ? 3 : 1;
  image.pixels.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) *
                      static_cast<std::size_t>(image.channels));
  if (!input.read_image(0, 0, 0, image.channels, OIIO::TypeDesc::FLOAT, image.pixels.data())) {
    throw InputError(place, "an image that cannot be decoded (" + oiio_error(&input) + ")", "a whole, sound image");
  }
  input.close();
  oiio_error(&input);
  check_finite(image, place);
  return image;
}

OIIO::ImageSpec open_hints() {
  OIIO::ImageSpec hints;
  hints["oiio:UnassociatedAlpha"] = 1;
  return hints;
}

}  // namespace

Image read_image(const std::filesystem::path& path) {
  const Place place{path.string(), 0, 0, {}};
  check_complete(read_file(path, kMaximumImageBytes), place);
  const OIIO::ImageSpec hints = open_hints();
  const auto input = OIIO::ImageInput::open(path.string(), &hints);
  if (!input) throw InputError(place, "no image (" + oiio_error(nullptr) + ")", "an image OpenImageIO reads");
  return decode(*input, place);
}

Image read_image(const std::string& bytes, const Place& place) {
  const bool known = is_png(bytes) || is_jpeg(bytes) || is_webp(bytes);
  if (!known) throw InputError(place, "bytes that are neither PNG, JPEG nor WebP", "an embedded image");
  check_complete(bytes, place);
  const std::string name = is_png(bytes) ? "embedded.png" : is_jpeg(bytes) ? "embedded.jpg" : "embedded.webp";
  OIIO::Filesystem::IOMemReader memory(const_cast<char*>(bytes.data()), bytes.size());
  const OIIO::ImageSpec hints = open_hints();
  const auto input = OIIO::ImageInput::create(name, false, &hints, &memory);
  OIIO::ImageSpec spec;
  if (!input || !input->set_ioproxy(&memory) || !input->open(name, spec, hints)) {
    throw InputError(place, "no image (" + oiio_error(input.get()) + ")", "an image OpenImageIO reads");
  }
  return decode(*input, place);
}

Vec3 mean_colour(const Image& image) {
  Vec3 sum;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) sum = sum + Vec3{image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
  }
  return (1.0 / (static_cast<double>(image.width) * image.height)) * sum;
}

bool looks_like_normal_map(const Image& image) {
  if (image.channels < 3) return false;
  double colour = 0, blue = 0, vector_length = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const Vec3 c{image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
      colour += std::abs(c.x - c.z);
      blue += c.z;
      vector_length += length(2.0 * c - Vec3{1, 1, 1});
    }
  }
  const double count = static_cast<double>(image.width) * image.height;
  return colour / count > 0.05 && blue / count > 0.65 && std::abs(vector_length / count - 1) < 0.2;
}

}  // namespace wrinkle

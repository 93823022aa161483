#include "sim/scene/image.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <memory>
#include <string_view>
#include <utility>

#include "sim/oiio/library.h"
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

std::string or_unknown(const std::string& error) { return error.empty() ? "not an image of a known format" : error; }

bool equals_in_any_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

void check_header(const oiio::Header& spec, std::size_t channels, const Place& place) {
  const std::string size = std::to_string(spec.width) + " x " + std::to_string(spec.height);
  if (spec.width < 1 || spec.height < 1) throw InputError(place, "an image of " + size + " pixels", "at least 1 x 1");
  if (spec.width > kMaximumImageSide || spec.height > kMaximumImageSide) {
    throw InputError(place, "an image of " + size + " pixels", "at most 16384 on a side");
  }
  if (spec.depth > 1) throw InputError(place, "a volume of depth " + std::to_string(spec.depth), "an image");
  if (spec.is_deep) throw InputError(place, "a deep image", "one value for each pixel and channel");
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

enum class Use { kColours, kNormals, kAlpha };

// The channels of the file that make up the image, in order. Alpha and depth are none of those of a colour or normal.
std::vector<int> channels_of(const oiio::Header& spec, Use use, const Place& place) {
  const auto named = [&](std::string_view name) {
    const auto found = std::find_if(spec.channels.begin(), spec.channels.end(),
                                    [&](const std::string& c) { return equals_in_any_case(c, name); });
    return found == spec.channels.end() ? -1 : static_cast<int>(found - spec.channels.begin());
  };
  if (use == Use::kAlpha) return spec.alpha_channel < 0 ? std::vector<int>{} : std::vector<int>{spec.alpha_channel};
  if (named("R") >= 0 && named("G") >= 0 && named("B") >= 0) return {named("R"), named("G"), named("B")};
  const int count = static_cast<int>(spec.channels.size());
  std::vector<int> all;
  for (int c = 0; c < count; ++c) {
    if (c != spec.alpha_channel && c != spec.z_channel) all.push_back(c);
  }
  if (all.empty() && count < 1) throw InputError(place, "an image without channels", "one to four");
  if (all.empty()) all = {0};
  if (all.size() > 4 || named("RY") >= 0) {
    throw InputError(place, std::to_string(count) + " channels (" + joined(spec.channels) + ")",
                     "one to four, or R, G and B among them");
  }
  if (all.size() >= 3) return {all[0], all[1], all[2]};
  return use == Use::kNormals ? all : std::vector<int>{all[0]};
}

// The data window of the file within the window that is to be seen.
struct Window {
  int width, height, x, y;
};
Window window_of(const oiio::Header& spec, std::string_view format) {
  if (format != "openexr" || spec.full_width < 1 || spec.full_height < 1) return {spec.width, spec.height, 0, 0};
  return {spec.full_width, spec.full_height, spec.x, spec.y};
}

// Pixel values as floats.
Image decode(oiio::Input& input, Use use, const Place& place) {
  const oiio::Header& spec = input.header();
  const std::vector<int> channels = channels_of(spec, use, place);
  if (channels.empty()) return {};
  const auto stored = static_cast<std::size_t>(1 + *std::max_element(channels.begin(), channels.end()));
  check_header(spec, stored, place);
  const Window window = window_of(spec, input.format());
  oiio::Header seen = spec;
  seen.width = window.width;
  seen.height = window.height;
  check_header(seen, channels.size(), place);
  std::vector<float> pixels(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) * stored);
  const std::string error = input.read(static_cast<int>(stored), pixels.data());
  if (!error.empty())
    throw InputError(place, "an image that cannot be decoded (" + error + ")", "a whole, sound image");
  Image image{window.width, window.height, static_cast<int>(channels.size()), {}};
  image.pixels.reserve(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) *
                       channels.size());
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const int dx = x - window.x, dy = y - window.y;
      const bool inside = dx >= 0 && dx < spec.width && dy >= 0 && dy < spec.height;
      const std::size_t at = static_cast<std::size_t>(inside ? dy : 0) * static_cast<std::size_t>(spec.width) +
                             static_cast<std::size_t>(inside ? dx : 0);
      for (const int c : channels) {
        image.pixels.push_back(inside ? pixels[at * stored + static_cast<std::size_t>(c)] : 0.0F);
      }
    }
  }
  check_finite(image, place);
  return image;
}

// Two channels of normals with the third, which is at least 0; all three as codes, (n + 1) / 2.
Image with_z(const Image& two) {
  Image image{two.width, two.height, 3, {}};
  image.pixels.reserve(two.pixels.size() / 2 * 3);
  for (std::size_t i = 0; i < two.pixels.size(); i += 2) {
    const float x = 2 * two.pixels[i] - 1, y = 2 * two.pixels[i + 1] - 1;
    const float z = std::sqrt(std::max(0.0F, 1 - x * x - y * y));
    image.pixels.insert(image.pixels.end(), {two.pixels[i], two.pixels[i + 1], (z + 1) / 2});
  }
  return image;
}

Image checked_normals(Image image, const Place& place, Notes& notes) {
  if (image.channels == 1) {
    throw InputError(place, "an image of one channel as a normal map",
                     "red and green, or red, green and blue; heights go into a height map");
  }
  if (image.channels == 2) return with_z(image);
  bool grey = true;
  for (std::size_t i = 0; grey && i < image.pixels.size(); i += 3) {
    grey = image.pixels[i] == image.pixels[i + 1] && image.pixels[i] == image.pixels[i + 2];
  }
  if (grey) notes.push_back(place.text() + ": this normal map is grey; are these heights?");
  return image;
}

// What OpenImageIO is to take bytes in memory for; empty for what it does not know by its first bytes.
std::string name_of(std::string_view bytes) {
  if (is_png(bytes)) return "embedded.png";
  if (is_jpeg(bytes)) return "embedded.jpg";
  if (is_webp(bytes)) return "embedded.webp";
  const std::pair<std::string_view, const char*> kinds[] = {{"\x76\x2f\x31\x01"sv, "embedded.exr"},
                                                            {"II*\0"sv, "embedded.tif"},
                                                            {"MM\0*"sv, "embedded.tif"},
                                                            {"GIF8"sv, "embedded.gif"},
                                                            {"DDS "sv, "embedded.dds"},
                                                            {"#?"sv, "embedded.hdr"},
                                                            {"8BPS"sv, "embedded.psd"},
                                                            {"BM"sv, "embedded.bmp"}};
  for (const auto& [magic, name] : kinds) {
    if (bytes.starts_with(magic)) return name;
  }
  return {};
}

Image read_as(const std::filesystem::path& path, Use use) {
  const Place place{path.string(), 0, 0, {}};
  check_complete(read_file(path, kMaximumImageBytes), place);
  std::string error;
  const auto input = oiio::library().open(path.string(), error);
  if (!input) throw InputError(place, "no image (" + or_unknown(error) + ")", "an image OpenImageIO reads");
  return decode(*input, use, place);
}

Image read_as(const std::string& bytes, const Place& place, Use use) {
  const std::string name = name_of(bytes);
  if (name.empty()) throw InputError(place, "bytes of no image format", "an embedded image, such as PNG or JPEG");
  check_complete(bytes, place);
  std::string error;
  const auto input = oiio::library().open(bytes, name, error);
  if (!input) throw InputError(place, "no image (" + or_unknown(error) + ")", "an image OpenImageIO reads from memory");
  return decode(*input, use, place);
}

}  // namespace

Image read_image(const std::filesystem::path& path) { return read_as(path, Use::kColours); }
Image read_image(const std::string& bytes, const Place& place) { return read_as(bytes, place, Use::kColours); }

Image read_alpha(const std::filesystem::path& path) { return read_as(path, Use::kAlpha); }
Image read_alpha(const std::string& bytes, const Place& place) { return read_as(bytes, place, Use::kAlpha); }

Image read_normal_map(const std::filesystem::path& path, Notes& notes) {
  return checked_normals(read_as(path, Use::kNormals), Place{path.string()}, notes);
}
Image read_normal_map(const std::string& bytes, const Place& place, Notes& notes) {
  return checked_normals(read_as(bytes, place, Use::kNormals), place, notes);
}

float luminance(float r, float g, float b) { return 0.2126F * r + 0.7152F * g + 0.0722F * b; }

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

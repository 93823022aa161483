#include "sim/report/columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/oiio/library.h"

namespace wrinkle {
namespace {

using nlohmann::json;

constexpr std::size_t kChannels = 3;  // of a PNG

// What a reader asks of a pixel: the vectors that are lit, and what lighting makes of them.
std::vector<AovChannel> shown_values(const Config& config) {
  std::vector<std::string> names{"N", "L"};
  const Shape shape(config);
  if (shape.glossy != 0) names.push_back("H");
  names.insert(names.end(), {"NL", "diffuse"});
  if (shape.glossy != 0) names.insert(names.end(), {"NH", "specular"});
  return aov_channels(config, names);
}

// Channels [first, first + count) of the framebuffer's values behind the colours, as two pictures of bytes.
json column(const Picture& all, const std::vector<std::uint8_t>& covered, std::size_t first, std::size_t count) {
  Picture high(all.width, all.height, {"R", "G", "B"}), low = high;
  const std::size_t stride = all.channels.size();
  for (std::size_t pixel = 0; pixel < covered.size(); ++pixel) {
    for (std::size_t k = 0; k < count && covered[pixel] != 0; ++k) {
      const double value = double(all.data[pixel * stride + kChannels + first + k]);
      const auto code = static_cast<int>(std::clamp(std::round((value - kColumnOffset) / kColumnStep), 1.0, 65535.0));
      high.data[pixel * kChannels + k] = float(code / 256) / 255;
      low.data[pixel * kChannels + k] = float(code % 256) / 255;
    }
  }
  json values = json::array();
  for (std::size_t k = 0; k < count; ++k) values.push_back(all.channels[kChannels + first + k]);
  return {{"values", values}, {"high", data_uri(high)}, {"low", data_uri(low)}};
}

}  // namespace

std::string data_uri(const Picture& picture) {
  return "data:image/png;base64," + oiio::library().base64(encode_png(picture));
}

json picture_with_columns(Engine engine, const Config& config, const Frame& frame) {
  const std::vector<AovChannel> values = shown_values(config);
  const Framebuffer framebuffer = drawn(engine, config, frame, values);
  const Picture all = framebuffer.all_channels();
  json result{{"png", data_uri(framebuffer.colour())}, {"columns", json::array()}};
  for (std::size_t first = 0; first < values.size(); first += kChannels) {
    const std::size_t count = std::min(kChannels, values.size() - first);
    result["columns"].push_back(column(all, framebuffer.covered(), first, count));
  }
  return result;
}

}  // namespace wrinkle

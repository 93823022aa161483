// Stands in the place of sim/oiio: the decoders of OpenImageIO are not ours. The bytes behind the first eight of an
// image say what its header says, so that the readers meet every header, and pixels are a pattern.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <numeric>

#include "sim/oiio/library.h"
#include "tests/fuzz/fuzz.h"

namespace wrinkle::oiio {
namespace {

// Up to 15 pixels on a side, or by a byte over 250 one of the sizes that no reader may take memory for.
int side_of(std::uint8_t byte) {
  constexpr int kSizes[] = {-1, 0, 16385, 1 << 30, std::numeric_limits<int>::max()};
  return byte > 250 ? kSizes[byte - 251] : byte % 16;
}

Header header_of(std::string_view bytes) {
  const auto at = [&](std::size_t i) { return i < bytes.size() ? static_cast<std::uint8_t>(bytes[i]) : 0; };
  Header header;
  header.width = header.full_width = side_of(static_cast<std::uint8_t>(at(8)));
  header.height = header.full_height = side_of(static_cast<std::uint8_t>(at(9)));
  const char* const names[] = {"R", "G", "B", "A", "Z", "RY", "x"};
  for (int c = 0; c < at(10) % 8; ++c) header.channels.push_back(names[at(10) < 128 ? c % 7 : at(11) % 7]);
  header.is_deep = at(12) == 1;
  header.depth = at(12) == 2 ? 2 : 1;
  const auto alpha = std::find(header.channels.begin(), header.channels.end(), "A");
  if (alpha != header.channels.end()) header.alpha_channel = static_cast<int>(alpha - header.channels.begin());
  if (at(13) < 128) return header;
  header.x = at(14) % 8 - 4;
  header.y = at(15) % 8 - 4;
  header.full_width = side_of(static_cast<std::uint8_t>(at(16)));
  header.full_height = side_of(static_cast<std::uint8_t>(at(17)));
  return header;
}

class Pattern : public Input {
 public:
  explicit Pattern(std::string_view bytes) : header_(header_of(bytes)), seed_(bytes.size()) {}

  const Header& header() const override { return header_; }
  std::string_view format() const override { return seed_ % 2 == 0 ? "openexr" : "png"; }
  std::string read(int channels, float* pixels) override {
    if (seed_ % 13 == 0) return "the pattern cannot be decoded";
    const std::size_t count = static_cast<std::size_t>(header_.width) * static_cast<std::size_t>(header_.height) *
                              static_cast<std::size_t>(channels);
    for (std::size_t i = 0; i < count; ++i) pixels[i] = static_cast<float>((i * 37 + seed_) % 256) / 255.0F;
    if (seed_ % 17 == 0) pixels[count - 1] = std::numeric_limits<float>::quiet_NaN();
    return {};
  }

 private:
  Header header_;
  std::size_t seed_;
};

// Nothing of the readers writes pictures.
class NoDecoders : public Library {
 public:
  std::unique_ptr<Input> open(const std::string& path, std::string& error) const override {
    std::ifstream stream(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    return open(bytes, path, error);
  }
  std::unique_ptr<Input> open(std::string_view bytes, const std::string&, std::string& error) const override {
    if (bytes.size() >= 12) return std::make_unique<Pattern>(bytes);
    error = "too short";
    return nullptr;
  }
  bool writes(const std::string&) const override { return false; }
  std::string write(const std::string&, const View&, const std::vector<std::string>&, bool) const override {
    fuzz::fail("a reader writes a picture");
  }
  void fill(const View&, float) const override { fuzz::fail("a reader fills a picture"); }
  void paste(const View&, const View&, int, int) const override { fuzz::fail("a reader pastes a picture"); }
  void magnify(const View&, int, int, int, const View&) const override { fuzz::fail("a reader magnifies a picture"); }
  void draw_box(const View&, int, int, int, int, std::array<float, 3>) const override {
    fuzz::fail("a reader draws a box");
  }
  // Levenshtein's.
  std::size_t edit_distance(std::string_view a, std::string_view b) const override {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
      std::size_t diagonal = row[0]++;
      for (std::size_t j = 0; j < b.size(); ++j) {
        const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
        diagonal = row[j + 1];
        row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
      }
    }
    return row.back();
  }
  std::string base64(std::string_view) const override { fuzz::fail("a reader writes base64"); }
};

}  // namespace

const Library& library() {
  static const NoDecoders none;
  return none;
}

}  // namespace wrinkle::oiio

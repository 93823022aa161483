#include "sim/layout.h"

#include <algorithm>

namespace wrinkle {

Picture blank_sheet(int width, int height) {
  Picture sheet(width, height, {"R", "G", "B"});
  std::fill(sheet.data.begin(), sheet.data.end(), 1.0F);
  return sheet;
}

void paste(Picture& sheet, const Picture& picture, int x, int y) {
  for (int row = 0; row < picture.height; ++row) {
    const auto from = picture.data.begin() + std::ptrdiff_t(3) * row * picture.width;
    std::copy(from, from + std::ptrdiff_t(3) * picture.width,
              sheet.data.begin() + std::ptrdiff_t(3) * ((y + row) * sheet.width + x));
  }
}

Picture magnified(const Picture& picture, Region region, int factor) {
  Picture out(region.side * factor, region.side * factor, picture.channels);
  const std::size_t n = picture.channels.size();
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      const int from = (region.y + y / factor) * picture.width + region.x + x / factor;
      std::copy_n(&picture.data[n * std::size_t(from)], n, &out.data[n * std::size_t(y * out.width + x)]);
    }
  }
  return out;
}

void outline(Picture& picture, Region region, std::array<float, 3> colour, int thickness) {
  const auto inside = [](int at, int from, int side) { return at >= from && at < from + side; };
  for (int y = std::max(region.y - thickness, 0); y < std::min(region.y + region.side + thickness, picture.height);
       ++y) {
    for (int x = std::max(region.x - thickness, 0); x < std::min(region.x + region.side + thickness, picture.width);
         ++x) {
      if (inside(x, region.x, region.side) && inside(y, region.y, region.side)) continue;
      std::copy(colour.begin(), colour.end(), &picture.data[std::size_t(3) * std::size_t(y * picture.width + x)]);
    }
  }
}

Picture contact_sheet(const std::vector<Picture>& pictures, int columns) {
  int width = 0, height = 0;
  for (const Picture& picture : pictures) {
    width = std::max(width, picture.width);
    height = std::max(height, picture.height);
  }
  const int rows = (int(pictures.size()) + columns - 1) / columns;
  Picture sheet =
      blank_sheet(columns * (width + kSheetMargin) + kSheetMargin, rows * (height + kSheetMargin) + kSheetMargin);
  for (int i = 0; i < int(pictures.size()); ++i)
    paste(sheet, pictures[std::size_t(i)], kSheetMargin + (i % columns) * (width + kSheetMargin),
          kSheetMargin + (i / columns) * (height + kSheetMargin));
  return sheet;
}

}  // namespace wrinkle

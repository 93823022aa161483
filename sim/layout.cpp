#include "sim/layout.h"

#include <algorithm>

#include "sim/oiio/library.h"

namespace wrinkle {
namespace {

oiio::View view(Picture& picture) {
  return {picture.width, picture.height, int(picture.channels.size()), picture.data.data()};
}
// There is no view of constant pixels. This one is only read.
oiio::View view(const Picture& picture) { return view(const_cast<Picture&>(picture)); }

}  // namespace

Picture blank_sheet(int width, int height) {
  Picture sheet(width, height, {"R", "G", "B"});
  oiio::library().fill(view(sheet), 1);
  return sheet;
}

void paste(Picture& sheet, const Picture& picture, int x, int y) {
  oiio::library().paste(view(sheet), view(picture), x, y);
}

Picture magnified(const Picture& picture, Region region, int factor) {
  Picture out(region.side * factor, region.side * factor, picture.channels);
  oiio::library().magnify(view(picture), region.x, region.y, region.side, view(out));
  return out;
}

void outline(Picture& picture, Region region, std::array<float, 3> colour, int thickness) {
  for (int distance = 1; distance <= thickness; ++distance)
    oiio::library().draw_box(view(picture), region.x - distance, region.y - distance,
                             region.x + region.side - 1 + distance, region.y + region.side - 1 + distance, colour);
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

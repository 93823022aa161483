#include "sim/layout.h"

#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>

namespace wrinkle {
namespace {

using OIIO::ImageBuf;
using OIIO::ROI;
namespace algo = OIIO::ImageBufAlgo;

// OpenImageIO's view of the pixels of a picture, which it reads and writes where they are.
ImageBuf view(Picture& picture) {
  return {OIIO::ImageSpec(picture.width, picture.height, int(picture.channels.size()), OIIO::TypeDesc::FLOAT),
          picture.data.data()};
}
// ImageBuf has no view of constant pixels. This one is only read.
const ImageBuf view(const Picture& picture) { return view(const_cast<Picture&>(picture)); }

}  // namespace

Picture blank_sheet(int width, int height) {
  Picture sheet(width, height, {"R", "G", "B"});
  ImageBuf pixels = view(sheet);
  algo::fill(pixels, {1.0F, 1.0F, 1.0F});
  return sheet;
}

void paste(Picture& sheet, const Picture& picture, int x, int y) {
  ImageBuf pixels = view(sheet);
  algo::paste(pixels, x, y, 0, 0, view(picture));
}

Picture magnified(const Picture& picture, Region region, int factor) {
  Picture out(region.side * factor, region.side * factor, picture.channels);
  const ImageBuf cut = algo::cut(view(picture), {region.x, region.x + region.side, region.y, region.y + region.side});
  ImageBuf pixels = view(out);
  algo::resample(pixels, cut, /*interpolate=*/false);
  return out;
}

void outline(Picture& picture, Region region, std::array<float, 3> colour, int thickness) {
  ImageBuf pixels = view(picture);
  for (int distance = 1; distance <= thickness; ++distance)
    algo::render_box(pixels, region.x - distance, region.y - distance, region.x + region.side - 1 + distance,
                     region.y + region.side - 1 + distance, colour);
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

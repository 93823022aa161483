// On a sheet of pictures every pixel is where it belongs.
#include "sim/layout.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace wrinkle {
namespace {

// A picture whose red is the column and whose green is the row.
Picture ramp(int width, int height) {
  Picture picture(width, height, {"R", "G", "B"});
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      picture.data[std::size_t(3 * (y * width + x))] = float(x);
      picture.data[std::size_t(3 * (y * width + x) + 1)] = float(y);
    }
  }
  return picture;
}

float red(const Picture& picture, int x, int y) { return picture.data[std::size_t(3 * (y * picture.width + x))]; }
float green(const Picture& picture, int x, int y) { return picture.data[std::size_t(3 * (y * picture.width + x) + 1)]; }

TEST(Layout, MagnifiedRepeatsEachPixel) {
  const Picture out = magnified(ramp(20, 10), {7, 3, 5}, 4);
  ASSERT_EQ(out.width, 20);
  ASSERT_EQ(out.height, 20);
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 20; ++x) {
      EXPECT_EQ(red(out, x, y), float(7 + x / 4));
      EXPECT_EQ(green(out, x, y), float(3 + y / 4));
    }
  }
}

TEST(Layout, OutlineIsOutsideAndStopsAtTheBorder) {
  for (const Region region : {Region{7, 3, 5}, Region{0, 0, 5}, Region{15, 5, 5}}) {
    Picture picture = ramp(20, 10);
    outline(picture, region, {-1, -1, -1}, 2);
    for (int y = 0; y < 10; ++y) {
      for (int x = 0; x < 20; ++x) {
        const int dx = std::max(region.x - x, x - region.x - region.side + 1);
        const int dy = std::max(region.y - y, y - region.y - region.side + 1);
        const int distance = std::max(dx, dy);  // 0 and below: inside
        EXPECT_EQ(red(picture, x, y) < 0, distance == 1 || distance == 2) << x << ' ' << y;
      }
    }
  }
}

TEST(Layout, ContactSheetHasMarginsAndOrder) {
  const Picture sheet = contact_sheet({ramp(4, 3), ramp(4, 3), ramp(4, 3)}, 2);
  EXPECT_EQ(sheet.width, 2 * 4 + 3 * kSheetMargin);
  EXPECT_EQ(sheet.height, 2 * 3 + 3 * kSheetMargin);
  EXPECT_EQ(red(sheet, kSheetMargin + 3, kSheetMargin), 3);
  EXPECT_EQ(red(sheet, 2 * kSheetMargin + 4 + 2, kSheetMargin + 1), 2);
  EXPECT_EQ(green(sheet, kSheetMargin, 2 * kSheetMargin + 3 + 2), 2);
  EXPECT_EQ(red(sheet, sheet.width - 1, sheet.height - 1), 1) << "white";
  EXPECT_EQ(green(sheet, 2 * kSheetMargin + 4, 2 * kSheetMargin + 4), 1) << "the fourth place is empty";
}

}  // namespace
}  // namespace wrinkle

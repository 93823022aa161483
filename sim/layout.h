// Pictures put together: magnified, outlined, side by side.
#pragma once

#include <array>
#include <vector>

#include "sim/picture.h"

namespace wrinkle {

// A square of pixels: left column, top row, and side.
struct Region {
  int x = 0, y = 0, side = 0;
};

inline constexpr int kSheetMargin = 8;

// A white sheet of red, green and blue.
Picture blank_sheet(int width, int height);
// Puts an RGB picture with its upper left corner at (x, y). It must fit.
void paste(Picture& sheet, const Picture& picture, int x, int y);

// The region with every pixel repeated `factor` times in both directions. Nothing is interpolated.
Picture magnified(const Picture& picture, Region region, int factor);

// Draws a line of `thickness` pixels around the region. It lies outside of the region, and ends where the picture ends.
void outline(Picture& picture, Region region, std::array<float, 3> colour, int thickness);

// Pictures of one size in rows of `columns`, with a margin.
Picture contact_sheet(const std::vector<Picture>& pictures, int columns);

}  // namespace wrinkle

// Which pixels a triangle covers, as the packets say it: pieces of rows between one start edge and up to two end edges.
#pragma once

#include <vector>

#include "golden/triangle/corners.h"

namespace wrinkle {

// The scan part of a packet. The first and the last row of a piece cover at least one pixel.
struct Piece {
  bool mirror = false;
  int y = 0, rows = 1, rows_end0 = 1;
  EdgeWords start, end0, end1;
};

// Exact top-left coverage of [0, width) x [0, height): row y where ceil(y_top - 1/2) <= y < ceil(y_bottom - 1/2), in it
// pixels ceil(X_left - 1/2) <= x < ceil(X_right - 1/2), X at the pixel centre. Empty when no pixel is covered. Of the
// two walks the one with fewer pieces; the unmirrored one when equal.
std::vector<Piece> cover(const Shape& config, const Corners& corners, int width, int height);

}  // namespace wrinkle

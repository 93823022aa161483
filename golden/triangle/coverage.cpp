#include "golden/triangle/coverage.h"

#include <algorithm>

#include "golden/triangle/exact_division.h"

namespace wrinkle {
namespace {

// A straight side over rows [first, end): the line through (x, y) with direction (dx, dy > 0), in sub-pixels, or, where
// the chain is cut off by the side of the screen, a standing bound.
struct Side {
  int first = 0, end = 0;
  bool standing = false;
  std::int64_t bound = 0;  // standing
  std::int64_t x = 0, y = 0, dx = 0, dy = 1;

  // ceil(dy * (X - 1/2)), X in pixels at the centre of `row`. With c = numerator(row), the bound of the pixels
  // is ceil(c / dy), and from row to row c grows by dx: what is lost to the sub-pixels is the same in every row.
  std::int64_t numerator(int row, int subpixel_bits) const {
    const std::int64_t one = std::int64_t{1} << subpixel_bits;
    const std::int64_t centre = row * one + one / 2;
    return -((-(x * dy + (centre - y) * dx - dy * (one / 2))) >> subpixel_bits);
  }
  std::int64_t bound_at(int row, int subpixel_bits) const {
    return standing ? bound : ceil_divide(numerator(row, subpixel_bits), dy);
  }
};

// The left or the right boundary of a triangle, from top to bottom. At most two edges, each cut at both screen sides.
struct Chain {
  std::array<Side, 6> sides;
  std::size_t count = 0;

  void add(const Side& side) {
    if (side.first >= side.end) return;
    if (count > 0 && side.standing && sides[count - 1].standing && side.bound == sides[count - 1].bound) {
      sides[count - 1].end = side.end;
    } else {
      sides[count++] = side;
    }
  }
  const Side& at(int row) const {
    return *std::find_if(sides.begin(), sides.begin() + count, [row](const Side& side) { return row < side.end; });
  }
};

struct Screen {
  int width, height, subpixel_bits;
};

// First pixel row whose centre is at or below y.
int first_row(std::int32_t y, int subpixel_bits) { return (y + (1 << (subpixel_bits - 1)) - 1) >> subpixel_bits; }

// -1, 0, 1: the bound lies left of the screen, in it, right of it.
int place(const Screen& screen, const Side& side, int row) {
  const std::int64_t bound = side.bound_at(row, screen.subpixel_bits);
  return bound < 0 ? -1 : bound > screen.width ? 1 : 0;
}

// Adds the edge from a down to b, cut where it crosses the sides of the screen.
void add_edge(const Screen& screen, const ScreenVertex& a, const ScreenVertex& b, Chain& chain) {
  Side line;
  line.first = std::max(first_row(a.y, screen.subpixel_bits), 0);
  line.end = std::min(first_row(b.y, screen.subpixel_bits), screen.height);
  line.x = a.x, line.y = a.y;
  line.dx = std::int64_t{b.x} - a.x, line.dy = std::int64_t{b.y} - a.y;
  while (line.first < line.end) {
    const int here = place(screen, line, line.first);
    // The bound is monotonic along the edge: bisect for the first row at another place.
    int same = line.first, other = line.end;
    while (other - same > 1) {
      const int middle = same + (other - same) / 2;
      (place(screen, line, middle) == here ? same : other) = middle;
    }
    Side part = line;
    part.end = other;
    if (here != 0) part.standing = true, part.bound = here < 0 ? 0 : screen.width;
    chain.add(part);
    line.first = other;
  }
}

// `side` from `row` on for `rows` rows, in walk coordinates.
EdgeWords edge_words(const Side& side, int row, int rows, bool mirror, int subpixel_bits) {
  EdgeWords edge;
  const std::int64_t bound = side.bound_at(row, subpixel_bits);
  edge.w = mirror ? -bound : bound;
  if (side.standing || rows == 1) return edge;
  // w = floor(n / dy), with ceil(c / dy) = floor((c + dy - 1) / dy) and -ceil(c / dy) = floor(-c / dy).
  const std::int64_t c = side.numerator(row, subpixel_bits);
  const std::int64_t n = mirror ? -c : c + side.dy - 1;
  const std::int64_t slope = mirror ? -side.dx : side.dx;
  edge.denominator = side.dy;
  edge.remainder = n - edge.w * side.dy - side.dy;
  edge.step = floor_divide(slope, side.dy);
  edge.remainder_step = slope - edge.step * side.dy;
  return edge;
}

struct Coverage {
  Screen screen;
  Chain left, right;

  bool empty(int row) const {
    return left.at(row).bound_at(row, screen.subpixel_bits) >= right.at(row).bound_at(row, screen.subpixel_bits);
  }
  // Drops rows without pixels from both ends.
  void trim(int& first, int& end) const {
    while (first < end && empty(first)) ++first;
    while (first < end && empty(end - 1)) --end;
  }
};

std::vector<Piece> cut(const Coverage& coverage, int first, int end, bool mirror) {
  const Chain& starts = mirror ? coverage.right : coverage.left;
  const Chain& ends = mirror ? coverage.left : coverage.right;
  const int bits = coverage.screen.subpixel_bits;
  std::vector<Piece> pieces;
  for (int stop; first < end; first = stop) {
    stop = std::min(starts.at(first).end, end);
    const int end0_stop = ends.at(first).end;
    if (end0_stop < stop) stop = std::min(stop, ends.at(end0_stop).end);
    int top = first, bottom = stop;
    coverage.trim(top, bottom);
    if (top == bottom) continue;
    Piece piece;
    piece.mirror = mirror;
    piece.y = top;
    piece.rows = bottom - top;
    piece.rows_end0 = std::min(ends.at(top).end, bottom) - top;
    piece.start = edge_words(starts.at(top), top, piece.rows, mirror, bits);
    piece.end0 = edge_words(ends.at(top), top, piece.rows_end0, mirror, bits);
    if (piece.rows_end0 < piece.rows) {
      const int row = top + piece.rows_end0;
      piece.end1 = edge_words(ends.at(row), row, bottom - row, mirror, bits);
    }
    pieces.push_back(piece);
  }
  return pieces;
}

}  // namespace

std::vector<Piece> cover(const Shape& config, const Corners& corners, int width, int height) {
  if (corners.area == 0) return {};
  const auto [top, middle, bottom] = corners.v;
  Coverage coverage{{width, height, config.subpixel_bits}, {}, {}};
  Chain& one = corners.area > 0 ? coverage.left : coverage.right;
  Chain& two = corners.area > 0 ? coverage.right : coverage.left;
  add_edge(coverage.screen, *top, *bottom, one);
  add_edge(coverage.screen, *top, *middle, two);
  add_edge(coverage.screen, *middle, *bottom, two);
  if (one.count == 0) return {};
  int first = one.sides[0].first, end = one.sides[one.count - 1].end;
  coverage.trim(first, end);

  std::vector<Piece> forward = cut(coverage, first, end, false);
  std::vector<Piece> backward = cut(coverage, first, end, true);
  return backward.size() < forward.size() ? backward : forward;
}

}  // namespace wrinkle

// scan: the row engine. A triangle packet becomes its non-empty rows, each with the planes at its first pixel.
#pragma once

#include "golden/pixel/context.h"
#include "golden/pixel/spans.h"

namespace wrinkle {

// The exact bound of one edge, a digital differential analyser with remainder.
class EdgeWalk {
 public:
  EdgeWalk() = default;
  explicit EdgeWalk(const EdgeWords& words) : words_(words), w_(words.w), remainder_(words.remainder) {}
  std::int64_t w() const { return w_; }
  // One row down; whether the remainder carried.
  bool step() {
    remainder_ += words_.remainder_step;
    const bool carry = remainder_ >= 0;
    if (carry) remainder_ -= words_.denominator;
    w_ += words_.step + (carry ? 1 : 0);
    return carry;
  }

 private:
  EdgeWords words_;
  std::int64_t w_ = 0, remainder_ = -1;
};

template <class Int>
class RowEngine {
 public:
  // `context` must outlive it.
  explicit RowEngine(const Context& context);

  void start(const TriangleWords& triangle);
  // The next row with pixels, if there is one: its start, length, y and planes hold until the next call.
  bool next_row();
  int w() const { return w_; }
  int count() const { return count_; }
  int y() const { return y_; }
  // Padded, and left-aligned as in Spans.
  const std::vector<Int>& value() const { return value_; }
  const std::vector<Int>& dw() const { return dw_; }

 private:
  void step_down();

  const std::vector<Plane>& planes_;
  EdgeWalk start_, end_, end1_;
  int row_ = 0, rows_ = 0, rows_end0_ = 0, first_y_ = 0;
  int w_ = 0, count_ = 0, y_ = 0;
  std::vector<Int> value_, step_, dw_;
};

}  // namespace wrinkle

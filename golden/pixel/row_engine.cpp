#include "golden/pixel/row_engine.h"

#include <algorithm>
#include <array>
#include <type_traits>

namespace wrinkle {

template <class Int>
RowEngine<Int>::RowEngine(const Context& context)
    : planes_(context.planes), value_(padded_planes(planes_.size())), step_(value_.size()), dw_(value_.size()) {}

template <class Int>
void RowEngine<Int>::start(const TriangleWords& triangle) {
  start_ = EdgeWalk(triangle.start);
  end_ = EdgeWalk(triangle.end0);
  end1_ = EdgeWalk(triangle.end1);
  row_ = 0;
  rows_ = triangle.rows;
  rows_end0_ = triangle.rows_end0;
  first_y_ = triangle.y;
  for (std::size_t p = 0; p < planes_.size(); ++p) {
    const int up = static_cast<int>(8 * sizeof(Int)) - planes_[p].width - planes_[p].guard_bits;
    const auto align = [up](std::int64_t x) { return static_cast<Int>(static_cast<std::uint64_t>(x) << up); };
    value_[p] = align(triangle.planes[p].value);
    step_[p] = align(triangle.planes[p].row);
    dw_[p] = align(triangle.planes[p].dw);
  }
}

template <class Int>
void RowEngine<Int>::step_down() {
  using Unsigned = std::make_unsigned_t<Int>;
  const auto carried = static_cast<Unsigned>(start_.step() ? 1 : 0);
  for (std::size_t first = 0; first < value_.size(); first += kPlaneBlock) {
    Int *value = &value_[first], *step = &step_[first], *dw = &dw_[first];
    std::array<Int, kPlaneBlock> sum;
    for (std::size_t i = 0; i < kPlaneBlock; ++i)
      sum[i] = static_cast<Int>(static_cast<Unsigned>(value[i]) + static_cast<Unsigned>(step[i]) +
                                carried * static_cast<Unsigned>(dw[i]));
    std::copy_n(sum.data(), kPlaneBlock, value);
  }
  end_.step();
}

template <class Int>
bool RowEngine<Int>::next_row() {
  while (row_ < rows_) {
    if (row_ > 0) step_down();
    if (row_ == rows_end0_) end_ = end1_;
    w_ = static_cast<int>(start_.w());
    count_ = static_cast<int>(end_.w() - start_.w());
    y_ = first_y_ + row_++;
    if (count_ > 0) return true;
  }
  return false;
}

template class RowEngine<std::int32_t>;
template class RowEngine<std::int64_t>;

}  // namespace wrinkle

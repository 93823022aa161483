#include "golden/pixel/row_engine.h"

#include <type_traits>

namespace wrinkle {

template <class Int>
RowEngine<Int>::RowEngine(const Context& context, const TriangleWords& triangle)
    : start_(triangle.start),
      end_(triangle.end0),
      end1_(triangle.end1),
      rows_(triangle.rows),
      rows_end0_(triangle.rows_end0),
      first_y_(triangle.y),
      planes_(context.config.frame_vectors > 1 ? kPlanes : kPlanesWithoutCross) {
  for (const Plane& plane : context.planes) {
    const auto i = static_cast<std::size_t>(plane.component);
    const int up = static_cast<int>(8 * sizeof(Int)) - plane.width - plane.guard_bits;
    const auto align = [up](std::int64_t x) { return static_cast<Int>(static_cast<std::uint64_t>(x) << up); };
    value_[i] = align(triangle.planes[i].value);
    step_[i] = align(triangle.planes[i].row);
    dw_[i] = align(triangle.planes[i].dw);
  }
}

template <class Int>
void RowEngine<Int>::step_down() {
  using Unsigned = std::make_unsigned_t<Int>;
  const auto carried = static_cast<Unsigned>(start_.step() ? 1 : 0);
  for (std::size_t i = 0; i < planes_; ++i) {
    const auto step = static_cast<Unsigned>(step_[i]) + carried * static_cast<Unsigned>(dw_[i]);
    value_[i] = static_cast<Int>(static_cast<Unsigned>(value_[i]) + step);
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

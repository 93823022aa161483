#include "golden/pixel/pixel.h"

namespace wrinkle {

std::vector<Value> values(const Shape& c) {
  return {
#define WRINKLE_VALUE(stage, name, elements, width, fraction_bits, is_signed, present) \
  {#stage, #name, elements, width, fraction_bits, is_signed, present, #stage "_" #name, 0},
#include "golden/pixel/components.def"
#undef WRINKLE_VALUE
  };
}

template <class Int>
void extract(const Batch<Int>& batch, int index, FragmentValues& out) {
  out.clear();
  const auto i = static_cast<std::size_t>(index);
#define WRINKLE_VALUE(stage, name, elements, width, fraction_bits, is_signed, present) \
  out.push_back({batch.stage##_##name[0][i], batch.stage##_##name[1][i], batch.stage##_##name[2][i]});
#include "golden/pixel/components.def"
#undef WRINKLE_VALUE
}

template <class Int>
const Int* column(const Batch<Int>& batch, std::size_t value, std::size_t element) {
  const std::array columns{
#define WRINKLE_VALUE(stage, name, elements, width, fraction_bits, is_signed, present) batch.stage##_##name.data(),
#include "golden/pixel/components.def"
#undef WRINKLE_VALUE
  };
  return columns[value][element].data();
}

template <class Int>
Fragment fragment(const Batch<Int>& batch, int index) {
  const auto i = static_cast<std::size_t>(index);
  Fragment out;
  out.x = static_cast<std::int32_t>(batch.scan_x[0][i]);
  out.y = static_cast<std::int32_t>(batch.scan_y[0][i]);
  out.last = batch.scan_last[0][i] != 0;
  out.zero = batch.normalize_zero[0][i] != 0;
  out.z = static_cast<std::uint32_t>(batch.interpolate_z[0][i]);
  for (std::size_t k = 0; k < 3; ++k) out.colour[k] = static_cast<std::uint16_t>(batch.output_colour[k][i]);
  return out;
}

template void extract(const Batch<std::int32_t>&, int, FragmentValues&);
template void extract(const Batch<std::int64_t>&, int, FragmentValues&);
template const std::int32_t* column(const Batch<std::int32_t>&, std::size_t, std::size_t);
template const std::int64_t* column(const Batch<std::int64_t>&, std::size_t, std::size_t);
template Fragment fragment(const Batch<std::int32_t>&, int);
template Fragment fragment(const Batch<std::int64_t>&, int);

}  // namespace wrinkle

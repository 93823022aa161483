#include "golden/pixel/pixel.h"

namespace wrinkle {

template <class Int>
Batch<Int>::Batch(const Shape& c) {
  const std::vector<Value> list = values(c);
  std::size_t size = 0;
  for (const Value& v : list) size += static_cast<std::size_t>(v.elements);
  columns_.resize(size);
  std::size_t used = 0;
  const auto take = [&](int elements) {
    const auto n = static_cast<std::size_t>(elements);
    used += n;
    return Columns<Int>(columns_).subspan(used - n, n);
  };
#define WRINKLE_VALUE(stage, name, elements, width, fraction_bits, is_signed, present, kind) \
  if (present) stage##_##name = take(elements);
#define WRINKLE_FRAME(stage, name, reader) stage##_##name = take(3 * c.frame_vectors);
#define WRINKLE_BUMP(stage, name) stage##_##name = take(c.bump_components);
#include "golden/values.def"
  used = 0;
  for (const Value& v : list) value.push_back(take(v.elements));
}

template <class Int>
void extract(const Batch<Int>& batch, int index, FragmentValues& out) {
  out.assign(batch.value.size(), {});
  for (std::size_t v = 0; v < out.size(); ++v) {
    for (std::size_t k = 0; k < batch.value[v].size(); ++k)
      out[v][k] = batch.value[v][k][static_cast<std::size_t>(index)];
  }
}

template <class Int>
Fragment fragment(const Batch<Int>& batch, int index) {
  const auto i = static_cast<std::size_t>(index);
  Fragment out;
  out.x = static_cast<std::int32_t>(batch.scan_x[0][i]);
  out.y = static_cast<std::int32_t>(batch.scan_y[0][i]);
  out.last = batch.scan_last[0][i] != 0;
  out.zero = batch.normalize_zero[0][i] != 0;
  if (!batch.interpolate_z.empty()) out.z = static_cast<std::uint32_t>(batch.interpolate_z[0][i]);
  for (std::size_t k = 0; k < batch.output_colour.size(); ++k)
    out.colour[k] = static_cast<std::uint16_t>(batch.output_colour[k][i]);
  return out;
}

template struct Batch<std::int32_t>;
template struct Batch<std::int64_t>;
template void extract(const Batch<std::int32_t>&, int, FragmentValues&);
template void extract(const Batch<std::int64_t>&, int, FragmentValues&);
template Fragment fragment(const Batch<std::int32_t>&, int);
template Fragment fragment(const Batch<std::int64_t>&, int);

}  // namespace wrinkle

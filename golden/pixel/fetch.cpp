#include "golden/pixel/fetch.h"

#include <cstring>

namespace wrinkle {

template <class Int>
void fetch(const std::uint32_t* texels, const TexelAddresses<Int>& addresses, int count, TexelRows& rows) {
#pragma GCC unroll 8
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const std::uint32_t* texel = texels + addresses.position[i];
    std::memcpy(&rows.upper[i], texel, 8);
    std::memcpy(&rows.lower[i], texel + addresses.stride[i], 8);
  }
}

template void fetch(const std::uint32_t*, const TexelAddresses<std::int32_t>&, int, TexelRows&);
template void fetch(const std::uint32_t*, const TexelAddresses<std::int64_t>&, int, TexelRows&);

}  // namespace wrinkle

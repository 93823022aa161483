#include "golden/pixel/fetch.h"

#include <cstring>

namespace wrinkle {

template <class Int>
void fetch(const std::uint32_t* texels, const TexelAddresses<Int>& addresses, int count, TexelQuads& quads) {
#pragma GCC unroll 8
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
    std::memcpy(&quads.texels[4 * i], texels + 2 * static_cast<std::ptrdiff_t>(addresses.position[i]), 16);
}

template void fetch(const std::uint32_t*, const TexelAddresses<std::int32_t>&, int, TexelQuads&);
template void fetch(const std::uint32_t*, const TexelAddresses<std::int64_t>&, int, TexelQuads&);

}  // namespace wrinkle

// One vector, one sample, one fragment at a time, through the scalar instance of the same source: for tests and for
// comparison with vectors made elsewhere. Not fast.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "golden/config/config.h"
#include "golden/texel/texture.h"

namespace wrinkle {

// normalize with normalizer_n: s1.V in, s1.F out.
std::array<std::int64_t, 3> normalize_vector(const Shape& config, const std::array<std::int64_t, 3>& v);

// rsqrt of unit_bits: T of SB bits in, u1.RB out (golden/pixel/rsqrt.h).
std::int64_t rsqrt_of(int unit_bits, std::int64_t t);

// texture at explicit coordinates: u and v as s(UI-1).UF, lod as s5.LB.
struct TextureSample {
  std::vector<std::int64_t> bump;       // as the datapath has it
  std::array<std::int64_t, 3> decal{};  // u0.T
  std::int64_t gloss = 0;
};
TextureSample sample_texture(const Shape& config, const Texture& texture, Wrap wrap_u, Wrap wrap_v, std::int64_t u,
                             std::int64_t v, std::int64_t lod);

}  // namespace wrinkle

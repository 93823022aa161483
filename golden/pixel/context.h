// What the stages read besides the fragments: configuration, draw state, tables, textures. Constant during a batch.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "golden/config/config.h"
#include "golden/pixel/bound_texture.h"
#include "golden/pixel/reciprocal.h"
#include "golden/pixel/rsqrt.h"
#include "golden/triangle/packet.h"

namespace wrinkle {

// Slopes of a packed segment; the base above them has its leading bit, always set, left out.
inline constexpr int kSlopeBits = 13;

// Entries of a table that lookup32() reads, at least.
inline constexpr std::size_t kSmallTable = 32;

// Tables in lanes of one width.
template <class Int>
struct Tables {
  std::vector<Int> rsqrt, compact_rsqrt, lite_rsqrt;  // (base - 2^(RB+g)) << kSlopeBits | slope
  std::vector<Int> reciprocal_base, reciprocal_slope;
  std::array<Int, kLevels> level_offset{}, level_stride{};
};

// What a stage takes along into its loops, by value: a store to a column could otherwise change it, as far as the
// compiler knows.
template <class Int>
struct Constants {
  Shape config;
  DrawWords draw;
  RsqrtGeometry rsqrt;
  ReciprocalGeometry reciprocal;
  const Int *rsqrt_table, *compact_rsqrt_table, *lite_rsqrt_table;
  const Int *reciprocal_base, *reciprocal_slope, *level_offset, *level_stride;
};

// One plane, and which element of which value it is.
struct Plane {
  std::size_t value, element;
  int width;  // without guard bits
  int guard_bits;
  bool is_signed;
};

struct Context {
  Shape config = Config();
  DrawWords draw;
  std::vector<Plane> planes;  // in packet order
  RsqrtGeometry rsqrt;
  ReciprocalGeometry reciprocal;
  Tables<std::int32_t> narrow;
  Tables<std::int64_t> wide;
  std::shared_ptr<const BoundTexture> texture;  // null where the draw fetches no texels

  template <class Int>
  Constants<Int> constants() const {
    const Tables<Int>* tables;
    if constexpr (sizeof(Int) == 4)
      tables = &narrow;
    else
      tables = &wide;
    return {config,
            draw,
            rsqrt,
            reciprocal,
            tables->rsqrt.data(),
            tables->compact_rsqrt.data(),
            tables->lite_rsqrt.data(),
            tables->reciprocal_base.data(),
            tables->reciprocal_slope.data(),
            tables->level_offset.data(),
            tables->level_stride.data()};
  }
};

// The configuration must be legal.
Context make_context(const Shape& config);
// Replaces the draw state; `texture` as DrawWords::texture names it, null where nothing is fetched.
void set_draw(Context& context, const DrawWords& draw, std::shared_ptr<const BoundTexture> texture);

}  // namespace wrinkle

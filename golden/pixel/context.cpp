#include "golden/pixel/context.h"

#include <algorithm>
#include <utility>

#include "golden/config/values.h"
#include "golden/pixel/compact_geometry.h"

namespace wrinkle {
namespace {

template <class Int, class Geometry>
std::vector<Int> packed(const Geometry& g, const std::vector<Segment>& segments) {
  const std::int64_t leading = std::int64_t{1} << (g.output_bits + g.guard_bits);
  std::vector<Int> table;
  for (const Segment& s : segments) table.push_back(static_cast<Int>(((s.base - leading) << kSlopeBits) | s.slope));
  table.resize(std::max(table.size(), kSmallTable));
  return table;
}

template <class Int>
void fill(const Context& context, Tables<Int>& tables) {
  const CompactRsqrtGeometry& compact = compact_rsqrt_geometry(context.config.unit_bits);
  tables.rsqrt = packed<Int>(context.rsqrt, rsqrt_table(context.rsqrt));
  tables.compact_rsqrt = packed<Int>(compact, compact_rsqrt_table(compact));
  tables.lite_rsqrt = packed<Int>(kLiteRsqrt, compact_rsqrt_table(kLiteRsqrt));
  if (context.config.perspective == 0) return;
  for (const Segment& s : reciprocal_table(context.reciprocal)) {
    tables.reciprocal_base.push_back(s.base);
    tables.reciprocal_slope.push_back(s.slope);
  }
}

// The planes of a packet and the values of `interpolate` are in one order.
std::vector<Plane> planes_of(const Shape& config) {
  const std::vector<Value> list = values(config);
  std::size_t value = 0;
  while (list[value].stage != "interpolate") ++value;
  std::vector<Plane> planes;
  for_each_plane(config, [&](const PlaneFormat& format) {
    while (list[value].name != format.name) ++value;
    planes.push_back({value, format.element, format.width, format.is_held ? 0 : config.guard_bits, format.is_signed});
  });
  return planes;
}

}  // namespace

Context make_context(const Shape& config) {
  Context context;
  context.config = config;
  context.planes = planes_of(config);
  context.rsqrt = rsqrt_geometry(config.unit_bits);
  context.reciprocal = {config.q_bits, config.reciprocal_bits};
  fill(context, context.narrow);
  fill(context, context.wide);
  return context;
}

void set_draw(Context& context, const DrawWords& draw, std::shared_ptr<const BoundTexture> texture) {
  context.draw = draw;
  context.texture = std::move(texture);
  if (context.texture == nullptr) return;
  for (std::size_t level = 0; level < kLevels; ++level) {
    context.narrow.level_offset[level] = context.texture->offset[level];
    context.narrow.level_stride[level] = context.texture->stride[level];
    context.wide.level_offset[level] = context.texture->offset[level];
    context.wide.level_stride[level] = context.texture->stride[level];
  }
}

}  // namespace wrinkle

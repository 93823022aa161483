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

// The planes of a packet in their order, which is that of the values of `interpolate`.
std::vector<Plane> planes_of(const Shape& config) {
  std::vector<Plane> planes;
  const std::vector<Value> list = values(config);
  const std::vector<ComponentFormat> formats = component_formats(config);
  for (std::size_t v = 0; v < list.size(); ++v) {
    if (list[v].stage != "interpolate") continue;
    for (std::size_t k = 0; k < static_cast<std::size_t>(list[v].elements) && planes.size() < formats.size(); ++k) {
      if (list[v].name == "lod" && config.lod_held != 0) break;
      const ComponentFormat& format = formats[planes.size()];
      planes.push_back(
          {format.component, v, k, format.width, format.is_constant ? 0 : config.guard_bits, format.is_signed});
    }
  }
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

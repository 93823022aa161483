#include "golden/config/values.h"

#include "golden/datapath/datapaths.h"

namespace wrinkle {
namespace {

// The values in the place of N: vectors of one format, the last `frame_held` of them held over a triangle.
void add_frame(const Shape& c, std::string_view stage, std::string_view wire, std::vector<Value>& list) {
  const auto names = with_datapath(c, [](const auto& datapath) {
    const auto said = datapath.frame_names();
    return std::vector<std::string_view>(said.begin(), said.end());
  });
  for (int i = 0; i < c.frame_vectors; ++i) {
    const ValueKind kind = i < c.frame_vectors - c.frame_held ? ValueKind::plane : ValueKind::held;
    list.push_back({stage, names[static_cast<std::size_t>(i)], 3, c.frame_width, c.frame_bits, true, kind, wire,
                    3 * i * c.frame_width});
  }
}

void add_bump(const Shape& c, std::string_view stage, std::string_view wire, std::vector<Value>& list) {
  if (c.bump_components == 0) return;
  const std::string_view name = with_datapath(c, [](const auto& datapath) { return datapath.bump_name(); });
  list.push_back({stage, name, c.bump_components, c.bump_width, c.bump_fraction, true, ValueKind::texel, wire, 0});
}

}  // namespace

std::vector<Value> values(const Shape& c) {
  const ValueKind plane = ValueKind::plane, texel = ValueKind::texel, wire = ValueKind::wire;
  const ValueKind level = c.divides != 0 ? ValueKind::plane : ValueKind::held;
  std::vector<Value> list;
#define WRINKLE_VALUE(stage, name, elements, width, fraction_bits, is_signed, present, kind) \
  if (present) list.push_back({#stage, #name, elements, width, fraction_bits, is_signed, kind, #stage "_" #name, 0});
#define WRINKLE_FRAME(stage, name) add_frame(c, #stage, #stage "_" #name, list);
#define WRINKLE_BUMP(stage, name) add_bump(c, #stage, #stage "_" #name, list);
#include "golden/values.def"
  return list;
}

}  // namespace wrinkle

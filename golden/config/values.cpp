#include "golden/config/values.h"

#include "golden/datapath/datapaths.h"

namespace wrinkle {
namespace {

void add_frame(const Shape& c, std::string_view stage, std::string_view wire, std::vector<Value>& list) {
  int lowest_bit = 0, element = 0;
  for (const FrameVector& v : frame_vectors(c)) {
    if (v.width == 0) continue;
    const ValueKind kind = v.is_held ? ValueKind::held : ValueKind::plane;
    list.push_back({stage, v.name, 3, v.width, v.fraction_bits, true, kind, wire, lowest_bit, element});
    lowest_bit += 3 * v.width;
    element += 3;
  }
}

void add_bump(const Shape& c, std::string_view stage, std::string_view wire, std::vector<Value>& list) {
  if (c.bump_components == 0) return;
  const std::string_view name = with_datapath(c, [](const auto& datapath) { return datapath.bump_name(); });
  list.push_back({stage, name, c.bump_components, c.bump_width, c.bump_fraction, true, ValueKind::texel, wire, 0, 0});
}

}  // namespace

std::array<FrameVector, kMaxFrameVectors> frame_vectors(const Shape& c) {
  std::array<FrameVector, kMaxFrameVectors> list{{{"", c.frame_0_width, c.frame_0_bits, c.frame_0_held != 0},
                                                  {"", c.frame_1_width, c.frame_1_bits, c.frame_1_held != 0},
                                                  {"", c.frame_2_width, c.frame_2_bits, c.frame_2_held != 0}}};
  with_datapath(c, [&](const auto& datapath) {
    std::size_t i = 0;
    for (const std::string_view name : datapath.frame_names()) list.at(i++).name = name;
  });
  return list;
}

std::vector<Value> values(const Shape& c) {
  const ValueKind plane = ValueKind::plane, texel = ValueKind::texel, wire = ValueKind::wire;
  const ValueKind level = c.divides != 0 ? ValueKind::plane : ValueKind::held;
  std::vector<Value> list;
#define WRINKLE_VALUE(stage, name, elements, width, fraction_bits, is_signed, present, kind) \
  if (present) list.push_back({#stage, #name, elements, width, fraction_bits, is_signed, kind, #stage "_" #name, 0, 0});
#define WRINKLE_FRAME(stage, name, reader) add_frame(c, #stage, #stage "_" #name, list);
#define WRINKLE_BUMP(stage, name) add_bump(c, #stage, #stage "_" #name, list);
#include "golden/values.def"
  return list;
}

}  // namespace wrinkle

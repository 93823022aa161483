// A scene in TOML, whose objects may be cube.obj and triangle.gltf, and its images image.png.
#include <toml++/toml.h>

#include "sim/scene/scene_reader.h"
#include "tests/fuzz/fuzz.h"

namespace {

constexpr std::int64_t kFinestTessellation = 12;

bool is_fine(const toml::node* divisions) {
  if (divisions == nullptr) return false;
  if (const toml::array* each = divisions->as_array()) return is_fine(each->get(0)) || is_fine(each->get(1));
  const auto* number = divisions->as_integer();
  return number != nullptr && number->get() > kFinestTessellation;
}

// What is legal and takes long: finer tessellations, and the height map of 512 by 512 that has a name.
bool takes_long(std::string_view text) {
  if (text.find("pinwheel") != std::string_view::npos) return true;
  try {
    const toml::table scene = toml::parse(text);
    const toml::array* objects = scene["objects"].as_array();
    if (objects == nullptr) return false;
    for (const toml::node& object : *objects) {
      const toml::table* table = object.as_table();
      if (table == nullptr) continue;
      if (is_fine(table->get("tessellation"))) return true;
    }
  } catch (const toml::parse_error&) {
    // The reader says what is wrong.
  }
  return false;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wrinkle;
  const auto text = fuzz::text_of(data, size);
  if (takes_long(text)) return 0;
  const auto path = fuzz::scratch().write("input.toml", text);
  fuzz::read_or_refuse([&] { read_scene(path); });
  return 0;
}

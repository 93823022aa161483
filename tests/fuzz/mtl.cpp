// Wavefront MTL: the file by itself, and as the library of a cube, whose faces show its first material, "skin". A map
// may be image.png.
#include "sim/scene/mtl_file.h"
#include "sim/scene/scene_reader.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wrinkle;
  const auto text = fuzz::text_of(data, size);
  fuzz::read_or_refuse([&] {
    Notes notes;
    parse_mtl("input.mtl", text, notes);
  });
  fuzz::scratch().write("cube.mtl", text);
  static const auto cube = fuzz::scratch().path() / "cube.obj";
  fuzz::read_or_refuse([&] { read_scene(cube); });
  return 0;
}

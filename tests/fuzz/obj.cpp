// Wavefront OBJ: the file and the model that is made of it. It may name cube.mtl as its library.
#include "sim/scene/scene_reader.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wrinkle;
  const auto path = fuzz::scratch().write("input.obj", fuzz::text_of(data, size));
  fuzz::read_or_refuse([&] { read_scene(path); });
  return 0;
}

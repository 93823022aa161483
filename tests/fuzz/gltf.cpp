// glTF, text or binary; buffers and images in data URIs.
#include "sim/scene/scene_reader.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wrinkle;
  const auto bytes = fuzz::text_of(data, size);
  const auto path = fuzz::scratch().write(bytes.starts_with('g') ? "input.glb" : "input.gltf", bytes);
  fuzz::read_or_refuse([&] { read_scene(path); });
  return 0;
}

// A configuration file. What it says must come back from the file that write_config() makes of it.
#include "sim/config_file.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wrinkle;
  const auto path = fuzz::scratch().write("input.toml", fuzz::text_of(data, size));
  fuzz::read_or_refuse([&] {
    const Config config = load_config(path.string());
    const auto again = fuzz::scratch().write("again.toml", write_config(config));
    if (load_config(again.string()) != config) fuzz::fail("a configuration that is written is read as another");
  });
  return 0;
}

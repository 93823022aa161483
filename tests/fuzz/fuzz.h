// What the fuzz targets share. A target is one file with LLVMFuzzerTestOneInput(): libFuzzer links it (./wrinkle fuzz),
// and so does the driver of the tests (driver.cpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "sim/input_error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace wrinkle::fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

// Ends the process with a message, as a sanitizer does.
[[noreturn]] void fail(const std::string& message);

// What a reader says of bad input: one line, which is not as long as the input.
void check_message(const InputError& error);

// Calls `read`, which reads the input or refuses it. Whatever it throws but an InputError ends the process.
template <class Read>
void read_or_refuse(const Read& read) {
  try {
    read();
  } catch (const InputError& error) {
    check_message(error);
  }
}

// A folder in memory for readers that take paths, with the files that an input may name: cube.obj, cube.mtl,
// triangle.gltf, image.png and base.toml. It is removed at the end of the process.
class Scratch {
 public:
  Scratch();
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path write(const std::string& name, std::string_view bytes) const;

 private:
  std::filesystem::path path_;
};

// The one of this process.
const Scratch& scratch();

}  // namespace wrinkle::fuzz

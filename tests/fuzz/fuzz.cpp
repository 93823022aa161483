#include "tests/fuzz/fuzz.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace wrinkle::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestMessage = 2000;

constexpr std::string_view kCube =
    "mtllib cube.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl skin\n"
    "f 4/4 3/3 2/2 1/1\nf 5/1 6/2 7/3 8/4\nf 1/1 2/2 6/3 5/4\nf 2/1 3/2 7/3 6/4\nf 3/1 4/2 8/3 7/4\nf 4/1 1/2 5/3 "
    "8/4\n";
constexpr std::string_view kCubeMaterial = "newmtl skin\nKd 0.8 0.6 0.4\n";
constexpr std::string_view kTriangle =
    R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
    R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
    R"("accessors":[{"bufferView":0,"componentType":5121,"count":3,"type":"VEC3"}],)"
    R"("bufferViews":[{"buffer":0,"byteLength":12,"byteStride":4}],)"
    R"("buffers":[{"byteLength":12,"uri":"data:application/octet-stream;base64,AAAAAAEAAAAAAQAA"}]})";
constexpr std::string_view kBase = "unit_bits = 10\n";
// The first and the last bytes of a PNG file: all that the readers themselves look at.
constexpr std::string_view kImage{"\x89PNG\r\n\x1a\n\x04\x04\x03gradientIEND\xae\x42\x60\x82", 27};

}  // namespace

void fail(const std::string& message) {
  std::fprintf(stderr, "fuzz: %s\n", message.c_str());
  std::abort();
}

void check_message(const InputError& error) {
  const std::string_view message = error.what();
  if (message.find('\n') != std::string_view::npos) fail("a message of several lines: " + std::string(message));
  if (message.size() > kLongestMessage) fail("a message of " + std::to_string(message.size()) + " bytes");
}

Scratch::Scratch() {
  const fs::path memory = "/dev/shm";
  std::string name = ((fs::is_directory(memory) ? memory : fs::temp_directory_path()) / "wrinkle_fuzz_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder for the inputs");
  path_ = name;
  write("cube.obj", kCube);
  write("cube.mtl", kCubeMaterial);
  write("triangle.gltf", kTriangle);
  write("image.png", kImage);
  write("base.toml", kBase);
}

Scratch::~Scratch() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

fs::path Scratch::write(const std::string& name, std::string_view bytes) const {
  std::ofstream(path_ / name, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return path_ / name;
}

const Scratch& scratch() {
  static const Scratch folder;
  return folder;
}

}  // namespace wrinkle::fuzz

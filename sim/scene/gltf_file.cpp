#define TINYGLTF_IMPLEMENTATION
#include "sim/scene/gltf_file.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "sim/scene/files.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;
using namespace std::string_view_literals;

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

// The container of a .glb: header, a JSON chunk, then at most a binary one, all inside the file.
void check_binary_container(std::string_view bytes, const Place& place) {
  if (bytes.size() < 20) throw InputError(place, std::to_string(bytes.size()) + " bytes", "a .glb of at least 20");
  if (!bytes.starts_with("glTF"sv)) throw InputError(place, "a wrong magic number", "\"glTF\"");
  if (word_at(bytes, 4) != 2) {
    throw InputError(place, "version " + std::to_string(word_at(bytes, 4)) + " of the container", "2");
  }
  if (word_at(bytes, 8) != bytes.size()) {
    throw InputError(place, "a length of " + std::to_string(word_at(bytes, 8)) + " bytes in the header",
                     std::to_string(bytes.size()) + ", the size of the file");
  }
  for (std::size_t at = 12, chunk = 0; at < bytes.size(); ++chunk) {
    const std::string name = "chunk " + std::to_string(chunk);
    if (bytes.size() - at < 8) throw InputError(place, name + " cut short", "its length and type");
    const std::size_t length = word_at(bytes, at);
    if (length > bytes.size() - at - 8) {
      throw InputError(place, name + " of " + std::to_string(length) + " bytes",
                       "at most " + std::to_string(bytes.size() - at - 8) + ", what is left of the file");
    }
    if (chunk == 0 && bytes.substr(at + 4, 4) != "JSON"sv) throw InputError(place, "another chunk first", "JSON");
    at += 8 + length;
  }
}

std::string one_line(std::string text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

bool keep_encoded_image(tinygltf::Image* image, const int, std::string*, std::string*, int, int,
                        const unsigned char* bytes, int size, void*) {
  image->image.assign(bytes, bytes + size);
  return true;
}

// tinygltf opens buffers through these; a buffer that is missing or no regular file is our own error.
tinygltf::FsCallbacks file_callbacks(fs::path& path) {
  tinygltf::FsCallbacks callbacks;
  callbacks.FileExists = [](const std::string&, void*) { return true; };
  callbacks.ExpandFilePath = [](const std::string& name, void*) { return name; };
  callbacks.ReadWholeFile = [](std::vector<unsigned char>* out, std::string*, const std::string& name, void* user) {
    const Place place{static_cast<const fs::path*>(user)->string(), 0, 0, "/buffers"};
    const std::string bytes = read_file(find_file({}, name, place));
    out->assign(bytes.begin(), bytes.end());
    return true;
  };
  callbacks.WriteWholeFile = nullptr;
  callbacks.user_data = &path;
  return callbacks;
}

void check_extensions(const GltfFile& file) {
  constexpr std::array kKnown = {"KHR_lights_punctual"sv, "KHR_mesh_quantization"sv};
  for (std::size_t i = 0; i < file.model.extensionsRequired.size(); ++i) {
    const std::string& name = file.model.extensionsRequired[i];
    if (std::find(kKnown.begin(), kKnown.end(), name) != kKnown.end()) continue;
    throw InputError(file.place("/extensionsRequired/" + std::to_string(i)), "\"" + name + "\"",
                     "KHR_lights_punctual or KHR_mesh_quantization");
  }
}

}  // namespace

GltfFile load_gltf(const fs::path& path) {
  GltfFile file{path, {}};
  const Place place{path.string(), 0, 0, {}};
  const std::string bytes = read_file(path);
  const bool binary = extension_of(path) == ".glb" || std::string_view(bytes).starts_with("glTF"sv);
  if (binary) check_binary_container(bytes, place);

  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(keep_encoded_image, nullptr);
  loader.SetFsCallbacks(file_callbacks(file.path));
  std::string error, warning;
  bool loaded = false;
  const auto size = static_cast<unsigned>(bytes.size());
  const std::string folder = path.parent_path().string();
  try {
    loaded = binary ? loader.LoadBinaryFromMemory(&file.model, &error, &warning,
                                                  reinterpret_cast<const unsigned char*>(bytes.data()), size, folder)
                    : loader.LoadASCIIFromString(&file.model, &error, &warning, bytes.data(), size, folder);
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& exception) {
    error = exception.what();
  }
  if (!loaded) throw InputError(place, "no sound glTF (" + one_line(error) + ")", "glTF 2.0");
  if (!file.model.asset.version.starts_with("2.")) {
    throw InputError(file.place("/asset/version"), "\"" + file.model.asset.version + "\"", "\"2.0\"");
  }
  check_extensions(file);
  return file;
}

int checked_index(const GltfFile& file, int index, std::size_t size, const std::string& what,
                  const std::string& pointer) {
  if (index >= 0 && static_cast<std::size_t>(index) < size) return index;
  throw InputError(file.place(pointer), "index " + std::to_string(index),
                   size == 0
                       ? "no reference, for there are no " + what
                       : "0 to " + std::to_string(size - 1) + ", for there are " + std::to_string(size) + " " + what);
}

std::string decode_uri(const std::string& uri, const Place& place) {
  const std::size_t colon = uri.find(':');
  if (colon != std::string::npos && colon < uri.find('/')) {
    throw InputError(place, "the URI \"" + uri.substr(0, 60) + "\"", "a path relative to the file");
  }
  const auto digit = [](char c) {
    return c >= '0' && c <= '9' ? c - '0' : 10 + (std::tolower(static_cast<unsigned char>(c)) - 'a');
  };
  std::string name;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool escaped = uri[i] == '%' && i + 2 < uri.size() && std::isxdigit(static_cast<unsigned char>(uri[i + 1])) &&
                         std::isxdigit(static_cast<unsigned char>(uri[i + 2]));
    name += escaped ? static_cast<char>(16 * digit(uri[i + 1]) + digit(uri[i + 2])) : uri[i];
    if (escaped) i += 2;
  }
  return name;
}

Image read_gltf_image(const GltfFile& file, int image) {
  const std::string pointer = "/images/" + std::to_string(image);
  const tinygltf::Image& source = file.model.images[static_cast<std::size_t>(image)];
  if (!source.image.empty()) {
    return read_image(std::string(source.image.begin(), source.image.end()), file.place(pointer));
  }
  if (source.uri.empty()) throw InputError(file.place(pointer), "neither uri nor bufferView with bytes", "one of them");
  const Place place = file.place(pointer + "/uri");
  return read_image(find_file(file.path.parent_path(), decode_uri(source.uri, place), place));
}

}  // namespace wrinkle

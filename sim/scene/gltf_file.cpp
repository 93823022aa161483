#define TINYGLTF_IMPLEMENTATION
#include "sim/scene/gltf_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <utility>

#include "sim/scene/files.h"
#include "sim/scene/uri.h"

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

std::string_view without_mark(std::string_view text) {
  return text.starts_with("\xef\xbb\xbf"sv) ? text.substr(3) : text;
}

std::string one_line(std::string text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

using nlohmann::json;

// JSON of at most this depth: all that follows walks it by recursion.
json parse_json(std::string_view text, const Place& place) {
  constexpr int kMaximumDepth = 512;
  const auto check_depth = [&](int depth, json::parse_event_t, json&) {
    if (depth > kMaximumDepth)
      throw InputError(place, "JSON nested deeper than " + std::to_string(kMaximumDepth), "less");
    return true;
  };
  try {
    json parsed = json::parse(text, check_depth);
    if (!parsed.is_object()) throw InputError(place, "no sound glTF (no JSON object)", "glTF 2.0");
    return parsed;
  } catch (const json::exception& error) {
    throw InputError(place, "no sound glTF (" + one_line(error.what()) + ")", "glTF 2.0");
  }
}

// Integers that are written as 3.0, which JSON takes for the same number, and tinygltf does not.
void make_integers(json& value) {
  if (value.is_structured()) {
    for (json& element : value) make_integers(element);
  } else if (value.is_number_float()) {
    const double number = value.get<double>();
    if (number == std::floor(number) && std::abs(number) < 9e15) value = static_cast<std::int64_t>(number);
  }
}

// The string `key` of an object, empty where there is none.
std::string string_of(const json& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return object.is_object() && found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

// The elements of an array of the document, none where it is no array.
template <typename Visitor>
void for_each_element(json& document, const char* key, const Visitor& visit) {
  const auto found = document.find(key);
  if (found == document.end() || !found->is_array()) return;
  for (std::size_t i = 0; i < found->size(); ++i) visit((*found)[i], i);
}

std::string read_buffer(const GltfFile& file, const std::string& uri, const Place& place) {
  if (!is_data_uri(uri)) return read_file(find_uri(file.path.parent_path(), uri, place));
  DataUri data = decode_data_uri(uri, place);
  const bool is_binary =
      data.media_type.empty() || data.media_type.starts_with("application/") || data.media_type == "text/plain";
  if (is_binary && !data.media_type.starts_with("application/json")) return std::move(data.bytes);
  throw InputError(place, "a buffer of the media type \"" + data.media_type.substr(0, 60) + "\"",
                   "\"application/octet-stream\" or \"application/gltf-buffer\"");
}

// The bytes of each buffer; `chunk` is the binary one of a .glb. In the document numbers stand for the URIs after this,
// which load_from_memory() resolves.
std::vector<std::string> take_buffers(GltfFile& file, std::string&& chunk, bool binary) {
  std::vector<std::string> buffers;
  for_each_element(file.json, "buffers", [&](json& buffer, std::size_t i) {
    const std::string pointer = "/buffers/" + std::to_string(i);
    const std::string uri = string_of(buffer, "uri");
    if (uri.empty() && !(binary && i == 0)) throw InputError(file.place(pointer), "a buffer without uri", "a uri");
    buffers.push_back(uri.empty() ? std::move(chunk) : read_buffer(file, uri, file.place(pointer + "/uri")));
    const auto length = buffer.is_object() ? buffer.find("byteLength") : buffer.end();
    if (!buffer.is_object() || length == buffer.end() || !length->is_number_unsigned()) {
      throw InputError(file.place(pointer + "/byteLength"), "no length", "the number of bytes");
    }
    const auto size = length->get<std::uint64_t>();
    if (size < 1 || size > buffers.back().size()) {
      throw InputError(file.place(pointer + "/byteLength"), std::to_string(size) + " bytes",
                       "1 to " + std::to_string(buffers.back().size()) + ", what there is");
    }
    buffers.back().resize(size);
    buffer["uri"] = std::to_string(i);
  });
  return buffers;
}

// Images are left out of what tinygltf sees, which takes bytes of a bufferView without a look at its bounds.
void take_images(GltfFile& file) {
  for_each_element(file.json, "images", [&](json& image, std::size_t i) {
    const std::string pointer = "/images/" + std::to_string(i);
    GltfImage& taken = file.images.emplace_back();
    taken.uri = string_of(image, "uri");
    if (image.is_object() && image.contains("bufferView")) {
      const json view = image["bufferView"];
      const std::int64_t index = view.is_number_integer() ? view.get<std::int64_t>() : -1;
      if (index < 0 || index > std::numeric_limits<int>::max()) {
        throw InputError(file.place(pointer + "/bufferView"), shortened(view.dump()), "the index of a bufferView");
      }
      if (!taken.uri.empty()) throw InputError(file.place(pointer), "both uri and bufferView", "one of them");
      taken.view = static_cast<int>(index);
      image.erase("bufferView");
    }
    if (taken.view || !taken.uri.empty()) image["uri"] = "image";
  });
}

void load_from_memory(GltfFile& file, std::vector<std::string> buffers) {
  tinygltf::TinyGLTF loader;
  tinygltf::FsCallbacks callbacks;
  callbacks.FileExists = [](const std::string&, void*) { return true; };
  callbacks.ExpandFilePath = [](const std::string& name, void*) { return name; };
  callbacks.ReadWholeFile = [](std::vector<unsigned char>* out, std::string*, const std::string& name, void* user) {
    const std::string& bytes = (*static_cast<std::vector<std::string>*>(user))[std::stoul(name)];
    out->assign(bytes.begin(), bytes.end());
    return true;
  };
  callbacks.WriteWholeFile = nullptr;
  callbacks.user_data = &buffers;
  loader.SetFsCallbacks(callbacks);
  std::string error, warning;
  bool loaded = false;
  try {
    const std::string text = file.json.dump();
    loaded =
        loader.LoadASCIIFromString(&file.model, &error, &warning, text.data(), static_cast<unsigned>(text.size()), "");
  } catch (const std::exception& exception) {
    error = exception.what();
  }
  if (!loaded) throw InputError(file.place(""), "no sound glTF (" + one_line(error) + ")", "glTF 2.0");
}

void check_required_extensions(const GltfFile& file) {
  const auto required = file.json.find("extensionsRequired");
  if (required == file.json.end() || !required->is_array()) return;
  for (std::size_t i = 0; i < required->size(); ++i) {
    const std::string name = (*required)[i].is_string() ? (*required)[i].get<std::string>() : (*required)[i].dump();
    if (is_applied_extension(name)) continue;
    const bool packed =
        name == "KHR_draco_mesh_compression" || name == "EXT_meshopt_compression" || name == "KHR_texture_basisu";
    throw InputError(file.place("/extensionsRequired/" + std::to_string(i)),
                     "the required extension \"" + shortened(name) + "\", which is not known",
                     packed ? "a file without it: export or convert it uncompressed" : "a file that does without it");
  }
}

// Every extension that is not applied, where it is first and how often. `pointer` grows with the walk.
void note_extensions(const json& value, const std::string& pointer, const GltfFile& file, PassedOver& passed_over) {
  if (!value.is_structured()) return;
  for (const auto& [key, element] : value.items()) {
    const std::string inner = pointer + "/" + key.substr(0, 80);
    if (key == "extras") continue;
    note_extensions(element, inner, file, passed_over);
    if (!value.is_object() || key != "extensions" || !element.is_object()) continue;
    for (const auto& [name, content] : element.items()) {
      if (!is_applied_extension(name)) {
        passed_over.see("the extension " + name.substr(0, 80) + " is not applied", file.place(inner));
      }
    }
  }
}

}  // namespace

bool is_applied_extension(const std::string& name) {
  constexpr std::array kApplied = {"KHR_lights_punctual"sv,    "KHR_mesh_quantization"sv,
                                   "KHR_texture_transform"sv,  "KHR_materials_pbrSpecularGlossiness"sv,
                                   "KHR_materials_specular"sv, "EXT_texture_webp"sv,
                                   "MSFT_texture_dds"sv};
  return std::find(kApplied.begin(), kApplied.end(), name) != kApplied.end();
}

GltfFile load_gltf(const fs::path& path, Notes& notes) {
  GltfFile file{path, {}, {}, {}};
  const Place place{path.string(), 0, 0, {}};
  std::string bytes = read_file(path);
  const bool binary = extension_of(path) == ".glb" || std::string_view(bytes).starts_with("glTF"sv);
  std::string chunk;
  if (binary) {
    check_binary_container(bytes, place);
    const std::size_t length = word_at(bytes, 12), next = 20 + length;
    if (next + 8 <= bytes.size()) chunk = bytes.substr(next + 8, word_at(bytes, next));
    bytes = bytes.substr(20, length);
  }
  file.json = parse_json(without_mark(bytes), place);
  make_integers(file.json);
  check_required_extensions(file);
  std::vector<std::string> buffers = take_buffers(file, std::move(chunk), binary);
  take_images(file);
  load_from_memory(file, std::move(buffers));
  if (!file.model.asset.version.starts_with("2.")) {
    throw InputError(file.place("/asset/version"), "\"" + file.model.asset.version + "\"", "\"2.0\"");
  }
  PassedOver passed_over;
  note_extensions(file.json, "", file, passed_over);
  passed_over.add_to(notes);
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

namespace {

// Bytes of an image that is embedded, empty for one in a file of its own.
std::string embedded_image(const GltfFile& file, std::size_t image, const Place& place) {
  const auto& [uri, view] = file.images[image];
  if (!uri.empty() && !is_data_uri(uri)) return {};
  if (view) {
    const std::string_view bytes = view_bytes(file, *view, "/images/" + std::to_string(image));
    if (!bytes.empty()) return std::string(bytes);
  }
  if (uri.empty()) throw InputError(place, "neither uri nor bufferView with bytes", "one of them");
  DataUri data = decode_data_uri(uri, place);
  const bool is_image =
      data.media_type.empty() || data.media_type.starts_with("image/") || data.media_type == "application/octet-stream";
  if (!is_image) {
    throw InputError(place, "an image of the media type \"" + data.media_type.substr(0, 60) + "\"", "\"image/...\"");
  }
  if (data.bytes.empty()) throw InputError(place, "an image without bytes", "an embedded image");
  return std::move(data.bytes);
}

// `read` takes a path, or bytes and their place.
template <class Read>
Image read_by(const GltfFile& file, int image, const Read& read) {
  const auto at = static_cast<std::size_t>(image);
  const Place place = file.place("/images/" + std::to_string(image) + "/uri");
  const std::string bytes = embedded_image(file, at, place);
  return bytes.empty() ? read(find_uri(file.path.parent_path(), file.images[at].uri, place)) : read(bytes, place);
}

}  // namespace

Image read_gltf_image(const GltfFile& file, int image) {
  return read_by(file, image, [](const auto&... source) { return read_image(source...); });
}

Image read_gltf_alpha(const GltfFile& file, int image) {
  return read_by(file, image, [](const auto&... source) { return read_alpha(source...); });
}

Image read_gltf_normal_map(const GltfFile& file, int image, Notes& notes) {
  return read_by(file, image, [&](const auto&... source) { return read_normal_map(source..., notes); });
}

}  // namespace wrinkle

// A glTF file, parsed by tinygltf and then checked by us, since tinygltf trusts what it reads.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Before tinygltf, which hides the symbols of what it includes.
#include <nlohmann/json.hpp>

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include <tiny_gltf.h>

#include "sim/input_error.h"
#include "sim/scene/image.h"

namespace wrinkle {

// Extensions that are applied; all others are noted, or, where the file requires them, an error.
bool is_applied_extension(const std::string& name);

// Where an image is: one of both.
struct GltfImage {
  std::string uri;
  std::optional<int> view;  // a bufferView
};

struct GltfFile {
  std::filesystem::path path;
  nlohmann::json json;  // as written, but for the URIs, and the bufferViews of images
  std::vector<GltfImage> images;
  tinygltf::Model model;

  // A place in the JSON, such as /accessors/3/count.
  Place place(const std::string& pointer) const { return {path.string(), 0, 0, pointer}; }
};

// Parses .gltf (text) or .glb (binary), with its buffers; images are left for read_gltf_image(). Extensions that are
// used and not applied are noted; those that the file requires are an error.
GltfFile load_gltf(const std::filesystem::path& path, Notes& notes);

// `index` if it is in [0, size), else an error at `pointer`: "found index 7 of 3 meshes".
int checked_index(const GltfFile& file, int index, std::size_t size, const std::string& what,
                  const std::string& pointer);

// The bytes of a bufferView, which are all inside its buffer.
std::string_view view_bytes(const GltfFile& file, int view, const std::string& pointer);

Image read_gltf_image(const GltfFile& file, int image);
// Its alpha as the one channel; no pixels where it has none.
Image read_gltf_alpha(const GltfFile& file, int image);
Image read_gltf_normal_map(const GltfFile& file, int image, Notes& notes);

struct AccessorData {
  std::size_t count = 0;
  int components = 0;
  std::vector<double> values;  // count * components

  double at(std::size_t element, int component) const {
    return values[element * static_cast<std::size_t>(components) + static_cast<std::size_t>(component)];
  }
};

// The values of an accessor, normalized integers as fractions, sparse substitution done; zeros where it has no
// bufferView. Checked before any memory is
// taken: component type, bounds, stride, count; and every float is finite and of at most 1e12.
// `components` is what it must have, `pointer` who refers to it.
AccessorData read_accessor(const GltfFile& file, int accessor, int components, const std::string& pointer);

// The same for indices: unsigned integers, each less than `vertices`.
std::vector<std::uint32_t> read_indices(const GltfFile& file, int accessor, std::size_t vertices,
                                        const std::string& pointer);

}  // namespace wrinkle

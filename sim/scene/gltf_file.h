// A glTF file, parsed by tinygltf and then checked by us, since tinygltf trusts what it reads.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include <tiny_gltf.h>

#include "sim/input_error.h"
#include "sim/scene/image.h"

namespace wrinkle {

struct GltfFile {
  std::filesystem::path path;
  tinygltf::Model model;

  // A place in the JSON, such as /accessors/3/count.
  Place place(const std::string& pointer) const { return {path.string(), 0, 0, pointer}; }
};

// Parses .gltf (text) or .glb (binary), with its buffers; images are left for read_gltf_image(). Extensions that the
// file requires and we do not know are an error.
GltfFile load_gltf(const std::filesystem::path& path);

// `index` if it is in [0, size), else an error at `pointer`: "found index 7 of 3 meshes".
int checked_index(const GltfFile& file, int index, std::size_t size, const std::string& what,
                  const std::string& pointer);

Image read_gltf_image(const GltfFile& file, int image);

// A name in a URI: %20 and the like decoded. Schemes other than a relative path are an error.
std::string decode_uri(const std::string& uri, const Place& place);

struct AccessorData {
  std::size_t count = 0;
  int components = 0;
  std::vector<double> values;  // count * components

  double at(std::size_t element, int component) const {
    return values[element * static_cast<std::size_t>(components) + static_cast<std::size_t>(component)];
  }
};

// The values of an accessor, normalized integers as fractions, sparse substitution done. Checked before any memory is
// taken: component type, bounds, stride, count; and every float is finite and of at most 1e9.
// `components` is what it must have, `pointer` who refers to it.
AccessorData read_accessor(const GltfFile& file, int accessor, int components, const std::string& pointer);

// The same for indices: unsigned integers, each less than `vertices`.
std::vector<std::uint32_t> read_indices(const GltfFile& file, int accessor, std::size_t vertices,
                                        const std::string& pointer);

}  // namespace wrinkle

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstring>
#include <limits>

#include "sim/scene/gltf_file.h"

namespace wrinkle {
namespace {

constexpr std::size_t kMaximumCount = std::size_t{1} << 26;  // elements of one accessor
// The same where no byte of the file stands for them: a file of some hundred bytes must not take gigabytes.
constexpr std::size_t kMaximumZeros = std::size_t{1} << 16;
constexpr double kMaximumMagnitude = 1e12;

// Where the elements lie. Constructed only when every byte of them is inside the buffer.
struct Span {
  const unsigned char* first = nullptr;
  std::size_t stride = 0;
};

std::size_t component_bytes(const GltfFile& file, int type, const std::string& pointer) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      throw InputError(file.place(pointer + "/componentType"), std::to_string(type),
                       "5120, 5121, 5122, 5123, 5125 or 5126");
  }
}

const tinygltf::BufferView& checked_view(const GltfFile& file, int index, const std::string& pointer) {
  const auto& views = file.model.bufferViews;
  const int v = checked_index(file, index, views.size(), "bufferViews", pointer + "/bufferView");
  const tinygltf::BufferView& view = views[static_cast<std::size_t>(v)];
  const std::string own = "/bufferViews/" + std::to_string(v);
  const int b = checked_index(file, view.buffer, file.model.buffers.size(), "buffers", own + "/buffer");
  const std::size_t size = file.model.buffers[static_cast<std::size_t>(b)].data.size();
  if (view.byteOffset > size || view.byteLength > size - view.byteOffset) {
    throw InputError(file.place(own),
                     "bytes " + std::to_string(view.byteOffset) + " to +" + std::to_string(view.byteLength),
                     "a range within the " + std::to_string(size) + " bytes of buffer " + std::to_string(b));
  }
  return view;
}

const unsigned char* first_byte(const GltfFile& file, const tinygltf::BufferView& view) {
  return file.model.buffers[static_cast<std::size_t>(view.buffer)].data.data() + view.byteOffset;
}

Span checked_span(const GltfFile& file, int v, std::size_t offset, std::size_t count, std::size_t bytes,
                  const std::string& pointer) {
  const tinygltf::BufferView& view = checked_view(file, v, pointer);
  if (view.byteStride != 0 && (view.byteStride < bytes || view.byteStride > 252)) {
    throw InputError(file.place("/bufferViews/" + std::to_string(v) + "/byteStride"), std::to_string(view.byteStride),
                     "0, or " + std::to_string(bytes) + " to 252");
  }
  const std::size_t stride = view.byteStride != 0 ? view.byteStride : bytes;
  if (offset > view.byteLength || (count - 1) * stride + bytes > view.byteLength - offset) {
    throw InputError(file.place(pointer + "/count"),
                     std::to_string(count) + " elements of " + std::to_string(stride) + " bytes from offset " +
                         std::to_string(offset),
                     "what fits the " + std::to_string(view.byteLength) + " bytes of bufferView " + std::to_string(v));
  }
  return {first_byte(file, view) + offset, stride};
}

template <typename Integer>
double integer_at(const unsigned char* bytes, bool normalized) {
  Integer value;
  std::memcpy(&value, bytes, sizeof value);
  if (!normalized) return static_cast<double>(value);
  return std::max(static_cast<double>(value) / static_cast<double>(std::numeric_limits<Integer>::max()), -1.0);
}

double component_at(const unsigned char* bytes, int type, bool normalized) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return integer_at<std::int8_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return integer_at<std::uint8_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return integer_at<std::int16_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return integer_at<std::uint16_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return integer_at<std::uint32_t>(bytes, normalized);
    default: {
      float value;
      std::memcpy(&value, bytes, sizeof value);
      return static_cast<double>(value);
    }
  }
}

// A float of a file: finite, not denormal, at most 1e9 in magnitude; -0 becomes 0.
double checked_float(const GltfFile& file, double value, std::size_t element, const std::string& pointer) {
  const char* fault = nullptr;
  if (std::isnan(value)) fault = "NaN";
  if (std::isinf(value)) fault = "infinity";
  if (value != 0 && std::abs(value) < static_cast<double>(FLT_MIN)) fault = "a denormal number";
  if (fault == nullptr && std::abs(value) > kMaximumMagnitude) fault = "a number over 1e12";
  if (fault == nullptr) return value + 0.0;
  throw InputError(file.place(pointer), std::string(fault) + " in element " + std::to_string(element),
                   "finite numbers of at most 1e12");
}

const tinygltf::Accessor& checked_accessor(const GltfFile& file, int index, int components,
                                           const std::string& pointer) {
  const auto& accessors = file.model.accessors;
  const int a = checked_index(file, index, accessors.size(), "accessors", pointer);
  const tinygltf::Accessor& accessor = accessors[static_cast<std::size_t>(a)];
  const std::string own = "/accessors/" + std::to_string(a);
  const int found = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
  if (found != components || accessor.type == TINYGLTF_TYPE_MAT2) {
    throw InputError(file.place(own + "/type"), std::to_string(found) + " components",
                     std::to_string(components) + ", for it is " + pointer);
  }
  if (accessor.count < 1 || accessor.count > kMaximumCount) {
    throw InputError(file.place(own + "/count"), std::to_string(accessor.count),
                     "1 to " + std::to_string(kMaximumCount));
  }
  if (accessor.bufferView == -1 && accessor.count > kMaximumZeros) {
    throw InputError(file.place(own + "/count"), std::to_string(accessor.count) + " elements without bufferView",
                     "at most " + std::to_string(kMaximumZeros));
  }
  return accessor;
}

void substitute(const GltfFile& file, const tinygltf::Accessor& accessor, const std::string& own, AccessorData& data) {
  if (!accessor.sparse.isSparse) return;
  const auto& sparse = accessor.sparse;
  const std::string pointer = own + "/sparse";
  if (sparse.count < 1 || static_cast<std::size_t>(sparse.count) > data.count) {
    throw InputError(file.place(pointer + "/count"), std::to_string(sparse.count),
                     "1 to " + std::to_string(data.count));
  }
  const auto count = static_cast<std::size_t>(sparse.count);
  const auto offset = [&](int value, const std::string& where) {
    if (value < 0) throw InputError(file.place(where + "/byteOffset"), std::to_string(value), "at least 0");
    return static_cast<std::size_t>(value);
  };
  const std::size_t index_bytes = component_bytes(file, sparse.indices.componentType, pointer + "/indices");
  const Span indices =
      checked_span(file, sparse.indices.bufferView, offset(sparse.indices.byteOffset, pointer + "/indices"), count,
                   index_bytes, pointer + "/indices");
  const std::size_t bytes = component_bytes(file, accessor.componentType, own);
  const Span values =
      checked_span(file, sparse.values.bufferView, offset(sparse.values.byteOffset, pointer + "/values"), count,
                   bytes * static_cast<std::size_t>(data.components), pointer + "/values");
  for (std::size_t i = 0; i < count; ++i) {
    const double at = component_at(indices.first + i * indices.stride, sparse.indices.componentType, false);
    if (!(at >= 0 && at < static_cast<double>(data.count))) {
      throw InputError(file.place(pointer + "/indices"), std::to_string(at), "less than " + std::to_string(data.count));
    }
    for (std::size_t c = 0; c < static_cast<std::size_t>(data.components); ++c) {
      const double value =
          component_at(values.first + i * values.stride + c * bytes, accessor.componentType, accessor.normalized);
      data.values[static_cast<std::size_t>(at) * static_cast<std::size_t>(data.components) + c] =
          checked_float(file, value, static_cast<std::size_t>(at), own);
    }
  }
}

}  // namespace

std::string_view view_bytes(const GltfFile& file, int index, const std::string& pointer) {
  const tinygltf::BufferView& view = checked_view(file, index, pointer);
  return {reinterpret_cast<const char*>(first_byte(file, view)), view.byteLength};
}

AccessorData read_accessor(const GltfFile& file, int index, int components, const std::string& pointer) {
  const tinygltf::Accessor& accessor = checked_accessor(file, index, components, pointer);
  const std::string own = "/accessors/" + std::to_string(index);
  const std::size_t bytes = component_bytes(file, accessor.componentType, own);
  const auto per_element = static_cast<std::size_t>(components);
  const bool zeros = accessor.bufferView == -1;  // also what sparse accessors start from
  Span span;
  if (!zeros) {
    span = checked_span(file, accessor.bufferView, accessor.byteOffset, accessor.count, bytes * per_element, own);
  }
  AccessorData data{accessor.count, components, std::vector<double>(accessor.count * per_element)};
  for (std::size_t i = 0; !zeros && i < accessor.count; ++i) {
    for (std::size_t c = 0; c < per_element; ++c) {
      const double value =
          component_at(span.first + i * span.stride + c * bytes, accessor.componentType, accessor.normalized);
      data.values[i * per_element + c] = checked_float(file, value, i, own);
    }
  }
  substitute(file, accessor, own, data);
  return data;
}

std::vector<std::uint32_t> read_indices(const GltfFile& file, int index, std::size_t vertices,
                                        const std::string& pointer) {
  const tinygltf::Accessor& accessor = checked_accessor(file, index, 1, pointer);
  const std::string own = "/accessors/" + std::to_string(index);
  const int type = accessor.componentType;
  if (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE && type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
      type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) {
    throw InputError(file.place(own + "/componentType"), std::to_string(type),
                     "5121, 5123 or 5125, for it is " + pointer);
  }
  const AccessorData data = read_accessor(file, index, 1, pointer);
  std::vector<std::uint32_t> indices;
  indices.reserve(data.count);
  for (std::size_t i = 0; i < data.count; ++i) {
    if (!(data.values[i] < static_cast<double>(vertices))) {
      throw InputError(
          file.place(own),
          "vertex " + std::to_string(static_cast<std::uint64_t>(data.values[i])) + " in element " + std::to_string(i),
          "less than " + std::to_string(vertices));
    }
    indices.push_back(static_cast<std::uint32_t>(data.values[i]));
  }
  return indices;
}

}  // namespace wrinkle

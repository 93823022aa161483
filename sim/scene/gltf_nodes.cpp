#include <algorithm>
#include <cmath>

#include "golden/vertex/transform.h"
#include "sim/scene/gltf_parts.h"
#include "sim/scene/toml_table.h"

namespace wrinkle {
namespace {

constexpr int kMaximumDepth = 256;

// `count` finite numbers, or none.
std::vector<double> checked_numbers(const GltfFile& file, const std::vector<double>& values, std::size_t count,
                                    const std::string& pointer) {
  if (!values.empty() && values.size() != count) {
    throw InputError(file.place(pointer), std::to_string(values.size()) + " numbers", std::to_string(count));
  }
  std::vector<double> checked;
  for (std::size_t i = 0; i < values.size(); ++i) {
    checked.push_back(checked_number(values[i], -kMaximumCoordinate, kMaximumCoordinate, "element " + std::to_string(i),
                                     file.place(pointer)));
  }
  return checked;
}

Mat4 matrix_of(const GltfFile& file, const std::vector<double>& columns, const std::string& pointer) {
  Mat4 m;
  for (int i = 0; i < 16; ++i) m(i % 4, i / 4) = columns[static_cast<std::size_t>(i)];
  // Exporters leave rounding errors in the last row; another w scales all.
  const double w = m(3, 3);
  const double projective = std::max({std::abs(m(3, 0)), std::abs(m(3, 1)), std::abs(m(3, 2))});
  if (w == 0 || projective > 1e-6 * std::abs(w)) {
    throw InputError(file.place(pointer), "a matrix that is not affine", "a last row of 0 0 0 1");
  }
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 4; ++c) m(r, c) = w == 1 ? m(r, c) : m(r, c) / w;
  }
  for (int c = 0; c < 4; ++c) m(3, c) = c == 3 ? 1 : 0;
  return m;
}

Mat4 rotation_of(const GltfFile& file, const std::vector<double>& q, const std::string& pointer) {
  const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (std::abs(norm - 1) > 0.01) {
    throw InputError(file.place(pointer), "a quaternion of length " + std::to_string(norm), "length 1");
  }
  const double x = q[0] / norm, y = q[1] / norm, z = q[2] / norm, w = q[3] / norm;
  Mat4 m;
  m.m = {1 - 2 * (y * y + z * z),
         2 * (x * y - z * w),
         2 * (x * z + y * w),
         0,
         2 * (x * y + z * w),
         1 - 2 * (x * x + z * z),
         2 * (y * z - x * w),
         0,
         2 * (x * z - y * w),
         2 * (y * z + x * w),
         1 - 2 * (x * x + y * y),
         0,
         0,
         0,
         0,
         1};
  return m;
}

Mat4 local_matrix(const GltfFile& file, const tinygltf::Node& node, const std::string& pointer) {
  const auto matrix = checked_numbers(file, node.matrix, 16, pointer + "/matrix");
  const auto t = checked_numbers(file, node.translation, 3, pointer + "/translation");
  const auto r = checked_numbers(file, node.rotation, 4, pointer + "/rotation");
  const auto s = checked_numbers(file, node.scale, 3, pointer + "/scale");
  if (!matrix.empty()) return matrix_of(file, matrix, pointer + "/matrix");
  Mat4 m;
  if (!t.empty()) m = translation({t[0], t[1], t[2]});
  if (!r.empty()) m = m * rotation_of(file, r, pointer + "/rotation");
  if (!s.empty()) m = m * scaling({s[0], s[1], s[2]});
  return m;
}

struct Walk {
  const GltfFile& file;
  std::vector<bool> seen;
  GltfNodes nodes;

  void visit(int index, const Mat4& parent, int depth) {
    const std::string pointer = "/nodes/" + std::to_string(index);
    if (seen[static_cast<std::size_t>(index)]) {
      throw InputError(file.place(pointer), "a node reached twice", "a tree");
    }
    if (depth > kMaximumDepth) {
      throw InputError(file.place(pointer), "nodes nested deeper than " + std::to_string(kMaximumDepth), "fewer");
    }
    seen[static_cast<std::size_t>(index)] = true;
    const tinygltf::Node& node = file.model.nodes[static_cast<std::size_t>(index)];
    const Mat4 world = parent * local_matrix(file, node, pointer);
    for (const double value : world.m) {
      checked_number(std::abs(value) < 1e-30 ? 0 : value, -kMaximumCoordinate, kMaximumCoordinate,
                     "an element of the world matrix", file.place(pointer));
    }
    hang(node, world, pointer);
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      visit(checked_index(file, node.children[i], file.model.nodes.size(), "nodes",
                          pointer + "/children/" + std::to_string(i)),
            world, depth + 1);
    }
  }

  void hang(const tinygltf::Node& node, const Mat4& world, const std::string& pointer) {
    const auto add = [&](std::vector<GltfInstance>& list, int item, std::size_t size, const std::string& what,
                         const std::string& key) {
      list.push_back({checked_index(file, item, size, what, pointer + key), world, node.name, pointer});
    };
    if (node.mesh != -1) add(nodes.meshes, node.mesh, file.model.meshes.size(), "meshes", "/mesh");
    if (node.camera != -1) add(nodes.cameras, node.camera, file.model.cameras.size(), "cameras", "/camera");
    const auto extension = node.extensions.find("KHR_lights_punctual");
    if (extension == node.extensions.end()) return;
    const std::string key = "/extensions/KHR_lights_punctual/light";
    if (!extension->second.Get("light").IsNumber()) {
      throw InputError(file.place(pointer + key), "no number", "the index of a light");
    }
    add(nodes.lights, extension->second.Get("light").GetNumberAsInt(), file.model.lights.size(), "lights", key);
  }
};

// The nodes that are no children.
void visit_all_roots(Walk& walk) {
  const auto& nodes = walk.file.model.nodes;
  std::vector<bool> is_child(nodes.size());
  for (const tinygltf::Node& node : nodes) {
    for (const int child : node.children) {
      if (child >= 0 && static_cast<std::size_t>(child) < nodes.size())
        is_child[static_cast<std::size_t>(child)] = true;
    }
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!is_child[i]) walk.visit(static_cast<int>(i), Mat4{}, 0);
  }
}

}  // namespace

GltfNodes read_gltf_nodes(const GltfFile& file, Notes& notes) {
  const tinygltf::Model& model = file.model;
  Walk walk{file, std::vector<bool>(model.nodes.size()), {}};
  if (!file.json.contains("scenes")) {
    visit_all_roots(walk);
    notes.push_back(file.place("/scenes").text() + ": there is no scene; all nodes are drawn");
    return std::move(walk.nodes);
  }
  if (model.scenes.empty()) throw InputError(file.place("/scenes"), "no scene", "at least one");
  if (model.scenes.size() > 1) {
    notes.push_back(file.place("/scenes").text() + ": of " + std::to_string(model.scenes.size()) +
                    " scenes only one is drawn");
  }
  const int chosen =
      checked_index(file, model.defaultScene == -1 ? 0 : model.defaultScene, model.scenes.size(), "scenes", "/scene");
  const std::vector<int>& roots = model.scenes[static_cast<std::size_t>(chosen)].nodes;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const std::string pointer = "/scenes/" + std::to_string(chosen) + "/nodes/" + std::to_string(i);
    walk.visit(checked_index(file, roots[i], model.nodes.size(), "nodes", pointer), Mat4{}, 0);
  }
  return std::move(walk.nodes);
}

}  // namespace wrinkle

// Generated tangents: against published answers of the reference, and by their properties.
#include "golden/vertex/tangents.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "golden/vertex/surfaces.h"
#include "golden/vertex/tessellate.h"

namespace wrinkle {
namespace {

const std::string kAssets = std::string(WRINKLE_SHARED_DIR) + "/assets/";

struct Expected {
  std::vector<TangentCorner> corners;
  std::vector<Tangent> tangents;
};

struct Difference {
  std::size_t signs = 0;         // corners whose handedness differs
  double median = 0, worst = 0;  // length of the difference of the tangents
};

Difference compare(const Expected& expected) {
  const std::vector<Tangent> got = generate_tangents(expected.corners);
  Difference difference;
  std::vector<double> distances;
  for (std::size_t i = 0; i < got.size(); ++i) {
    distances.push_back(length(got[i].T - expected.tangents[i].T));
    difference.signs += got[i].sign != expected.tangents[i].sign ? 1 : 0;
  }
  std::sort(distances.begin(), distances.end());
  difference.median = distances[distances.size() / 2];
  difference.worst = distances.back();
  std::printf("%zu corners: %zu signs differ, tangents by %.2e (median), %.2e (worst)\n", got.size(), difference.signs,
              difference.median, difference.worst);
  return difference;
}

// 24 triangles with mirrored and degenerate uv, as published with the Rust port of the reference.
TEST(Tangents, PublishedCube) {
  std::ifstream file(kAssets + "vectors/mikktspace_cube_published.txt");
  if (!file) GTEST_SKIP() << "mikktspace_cube_published.txt is not in ../shared/assets";
  Expected expected;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream in(line);
    TangentCorner c;
    Tangent t;
    in >> c.P.x >> c.P.y >> c.P.z >> c.N.x >> c.N.y >> c.N.z >> c.uv.x >> c.uv.y >> t.T.x >> t.T.y >> t.T.z >> t.sign;
    ASSERT_TRUE(in) << line;
    expected.corners.push_back(c);
    expected.tangents.push_back(t);
  }
  ASSERT_EQ(expected.corners.size(), 72u);
  const Difference difference = compare(expected);
  EXPECT_EQ(difference.signs, 0u);
  EXPECT_LT(difference.worst, 1e-6);
}

// 2,046 corners of a real model. The positions are published with six decimals, three digits of the size of a triangle:
// that, not the method, limits the agreement.
TEST(Tangents, PublishedAvocado) {
  std::ifstream file(kAssets + "vectors/mikktspace_avocado_published.json");
  if (!file) GTEST_SKIP() << "mikktspace_avocado_published.json is not in ../shared/assets";
  Expected expected;
  const auto vec3 = [](const nlohmann::json& a) { return Vec3{a[0], a[1], a[2]}; };
  const nlohmann::json document = nlohmann::json::parse(file);
  for (const auto& v : document["vlist"]) {
    expected.corners.push_back({vec3(v["v"]), vec3(v["vn"]), {v["vt"][0], v["vt"][1]}});
    expected.tangents.push_back({vec3(v["vx"]), v["vx"][3]});
  }
  ASSERT_EQ(expected.corners.size(), 2046u);
  const Difference difference = compare(expected);
  EXPECT_EQ(difference.signs, 0u);
  EXPECT_LT(difference.median, 2e-4);
  EXPECT_LT(difference.worst, 5e-3);
}

std::string read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<float> unpack_floats(const std::string& path) {
  std::vector<float> values;
  std::FILE* pipe = popen(("xz -dc '" + path + "' 2>/dev/null").c_str(), "r");
  if (pipe == nullptr) return values;
  float buffer[1024];
  for (std::size_t n; (n = std::fread(buffer, sizeof(float), 1024, pipe)) > 0;) {
    values.insert(values.end(), buffer, buffer + n);
  }
  pclose(pipe);
  return values;
}

// Element `index` of an accessor of floats or 16-bit indices.
struct Accessor {
  Accessor(const nlohmann::json& gltf, const std::string& buffer, int number) {
    const auto& accessor = gltf["accessors"][static_cast<std::size_t>(number)];
    const auto& view = gltf["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const std::size_t element = accessor["type"] == "VEC3" ? 12 : accessor["type"] == "VEC2" ? 8 : 2;
    stride = view.value("byteStride", element);
    data = buffer.data() + view.value("byteOffset", std::size_t{0}) + accessor.value("byteOffset", std::size_t{0});
    count = accessor["count"];
  }
  template <class T>
  T get(std::size_t index, std::size_t component = 0) const {
    T value;
    std::memcpy(&value, data + index * stride + component * sizeof(T), sizeof(T));
    return value;
  }
  const char* data;
  std::size_t stride, count;
};

// 23,322 corners; the answers are the reference's own, fed with (u, 1 - v).
TEST(Tangents, ReferenceOnNormalTangentTest) {
  const std::string folder = kAssets + "gltf/NormalTangentTest/glTF/";
  const std::string text = read(folder + "NormalTangentTest.gltf"), buffer = read(folder + "NormalTangentTest0.bin");
  const std::vector<float> answers = unpack_floats(kAssets + "vectors/mikk_tangents_NormalTangentTest.f32.xz");
  if (text.empty() || buffer.empty() || answers.empty()) GTEST_SKIP() << "NormalTangentTest is not in ../shared/assets";
  const auto gltf = nlohmann::json::parse(text);
  const auto& primitive = gltf["meshes"][0]["primitives"][0];
  const auto& attributes = primitive["attributes"];
  const Accessor index(gltf, buffer, primitive["indices"]), P(gltf, buffer, attributes["POSITION"]),
      N(gltf, buffer, attributes["NORMAL"]), uv(gltf, buffer, attributes["TEXCOORD_0"]);
  const auto vec3 = [](const Accessor& a, std::size_t i) {
    return Vec3{a.get<float>(i, 0), a.get<float>(i, 1), a.get<float>(i, 2)};
  };
  Expected expected;
  ASSERT_EQ(answers.size(), 4 * index.count);
  for (std::size_t i = 0; i < index.count; ++i) {
    const std::size_t v = index.get<std::uint16_t>(i);
    expected.corners.push_back({vec3(P, v), vec3(N, v), {uv.get<float>(v, 0), 1.0f - uv.get<float>(v, 1)}});
    const float* t = &answers[4 * i];
    expected.tangents.push_back({{t[0], t[1], t[2]}, t[3]});
  }
  const Difference difference = compare(expected);
  EXPECT_EQ(difference.signs, 0u);
  EXPECT_LT(difference.worst, 1e-6);
}

std::vector<TangentCorner> corners_of(const Mesh& mesh, bool mirror_u = false) {
  std::vector<TangentCorner> corners;
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t i : t) {
      const Vertex& v = mesh.vertices[i];
      corners.push_back({v.P, v.N, {mirror_u ? 1 - v.uv.x : v.uv.x, 1 - v.uv.y}});
    }
  }
  return corners;
}

TEST(Tangents, AgreeWithTheDerivativesOfAFineSurface) {
  Mesh mesh = tessellate({std::make_shared<Torus>(2, 0.7)}, 64, 64);
  const Mesh analytic = mesh;
  add_tangents(mesh);
  ASSERT_EQ(mesh.triangles.size(), analytic.triangles.size());
  for (std::size_t n = 0; n < mesh.triangles.size(); ++n) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vertex &a = analytic.vertices[analytic.triangles[n][i]], &b = mesh.vertices[mesh.triangles[n][i]];
      ASSERT_EQ(a.P, b.P);
      ASSERT_EQ(b.sign, 1);  // v up in the image, N = Pu x Pv: right-handed
      ASSERT_LT(length(a.T - b.T), 0.06);
    }
  }
}

// A mirrored image turns u round and changes the handedness [extremes 29].
TEST(Tangents, Extreme29MirroredUv) {
  const Mesh mesh = tessellate(make_rectangle(), 2, 2);
  const auto plain = generate_tangents(corners_of(mesh)), mirrored = generate_tangents(corners_of(mesh, true));
  for (std::size_t i = 0; i < plain.size(); ++i) {
    EXPECT_NEAR(length(plain[i].T - Vec3{1, 0, 0}), 0, 1e-12);
    EXPECT_NEAR(length(mirrored[i].T - Vec3{-1, 0, 0}), 0, 1e-12);
    EXPECT_EQ(plain[i].sign, 1);
    EXPECT_EQ(mirrored[i].sign, -1);
  }
}

// Two halves of a strip with the image mirrored at the seam: one position, two tangents.
TEST(Tangents, MirrorSeamSplitsVertices) {
  Mesh mesh;
  const auto vertex = [](double x, double y, double u) {
    Vertex v;
    v.P = {x, y, 0}, v.N = {0, 0, 1}, v.uv = {u, 1 - y};
    return v;
  };
  mesh.vertices = {vertex(-1, 0, 1), vertex(0, 0, 0), vertex(0, 1, 0),
                   vertex(-1, 1, 1), vertex(1, 0, 1), vertex(1, 1, 1)};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}};
  add_tangents(mesh);
  EXPECT_EQ(mesh.vertices.size(), 8u);
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t i : t) {
      const bool right = mesh.vertices[t[0]].P.x + mesh.vertices[t[1]].P.x + mesh.vertices[t[2]].P.x > 0;
      EXPECT_NEAR(length(mesh.vertices[i].T - Vec3{right ? 1.0 : -1.0, 0, 0}), 0, 1e-12);
      EXPECT_EQ(mesh.vertices[i].sign, right ? 1 : -1);
    }
  }
}

// Where uv have no area [extremes 30] the tangent still is defined and finite: it is that of a neighbour over an edge.
TEST(Tangents, Extreme30DegenerateUv) {
  std::vector<TangentCorner> alone{
      {{0, 0, 0}, {0, 0, 1}, {0.5, 0.5}}, {{1, 0, 0}, {0, 0, 1}, {0.5, 0.5}}, {{0, 1, 0}, {0, 0, 1}, {0.5, 0.5}}};
  for (const Tangent& t : generate_tangents(alone)) EXPECT_EQ(t.T, (Vec3{1, 0, 0}));

  // The second triangle's uv lie on a line; two of its corners are shared.
  const TangentCorner a{{0, 0, 0}, {0, 0, 1}, {0, 0}}, b{{0, 1, 0}, {0, 0, 1}, {1, 0}},
      c{{-1, 0, 0}, {0, 0, 1}, {0, 1}}, d{{1, 1, 0}, {0, 0, 1}, {0.5, 0}};
  const auto tangents = generate_tangents(std::vector{a, b, c, b, a, d});
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(length(tangents[i].T - Vec3{0, 1, 0}), 0, 1e-12) << i;
  EXPECT_EQ(tangents[3].sign, tangents[0].sign);
}

TEST(Tangents, DegenerateTrianglesCopyFromTheSameCorner) {
  const TangentCorner a{{0, 0, 0}, {0, 0, 1}, {0, 0}}, b{{0, 1, 0}, {0, 0, 1}, {1, 0}},
      c{{-1, 0, 0}, {0, 0, 1}, {0, 1}};
  const auto tangents = generate_tangents(std::vector{a, a, b, a, b, c});
  EXPECT_EQ(tangents[0].T, tangents[3].T);
  EXPECT_EQ(tangents[2].T, tangents[4].T);
  EXPECT_EQ(tangents[2].sign, tangents[4].sign);
}

TEST(Tangents, NothingInNothingOut) { EXPECT_TRUE(generate_tangents({}).empty()); }

TEST(Tangents, ALongFanTakesLinearTime) {
  constexpr int kTriangles = 100000;
  std::vector<TangentCorner> corners;
  const auto rim = [](int i) {
    const double a = 6.28 * i / kTriangles;
    return TangentCorner{{std::cos(a), std::sin(a), 0}, {0, 0, 1}, {std::cos(a), std::sin(a)}};
  };
  for (int i = 0; i < kTriangles; ++i) {
    corners.insert(corners.end(), {TangentCorner{{}, {0, 0, 1}, {}}, rim(i), rim(i + 1)});
  }
  for (const Tangent& t : generate_tangents(corners)) ASSERT_NEAR(length(t.T - Vec3{1, 0, 0}), 0, 1e-6);
}

// Round a pole of the texture coordinates every direction meets its opposite, and coordinates may have no area: each
// takes the time of a sort.
TEST(Tangents, ThousandsOfTrianglesRoundOnePole) {
  constexpr int kTriangles = 16000;
  std::vector<TangentCorner> corners;
  const auto rim = [](int i, double u) {
    const double a = 2 * 3.14159265358979 * i / kTriangles;
    return TangentCorner{{std::cos(a), std::sin(a), 0}, {0, 0, 1}, {u, 0}};
  };
  for (int i = 0; i < kTriangles; ++i) {
    const double u = static_cast<double>(i) / kTriangles;
    // The pole has one coordinate for all: the welded corner is shared, and each triangle's s is along its rim.
    corners.insert(corners.end(),
                   {TangentCorner{{}, {0, 0, 1}, {0.5, 1}}, rim(i, u), rim(i + 1, u + 1.0 / kTriangles)});
    corners.insert(corners.end(), {TangentCorner{{}, {0, 0, 1}, {0.5, 1}}, rim(i, 0.25), rim(i + 1, 0.25)});
  }
  const auto start = std::chrono::steady_clock::now();
  const auto tangents = generate_tangents(corners);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  for (const Tangent& t : tangents) ASSERT_TRUE(std::isfinite(t.T.x) && std::isfinite(t.T.y));
  EXPECT_LT(seconds.count(), 2);  // of a machine that does other work too; the square of the number takes half a minute
}

}  // namespace
}  // namespace wrinkle

// glTF: one small sound model, and everything that may be wrong with it.
#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "golden/vertex/scene.h"
#include "sim/config_file.h"
#include "sim/scene/scene_reader.h"
#include "support.h"

namespace wrinkle::test {
namespace {

using nlohmann::json;

template <typename T>
void append(std::string& bytes, std::initializer_list<T> values) {
  for (const T value : values) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    bytes.append(raw, sizeof(T));
  }
}

// A unit square: positions at 0, normals at 48, uv at 96, indices at 128, a sparse index at 140, its value at 144.
std::string buffer() {
  std::string bytes;
  append<float>(bytes, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
  append<float>(bytes, {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
  append<float>(bytes, {0, 1, 1, 1, 1, 0, 0, 0});
  append<std::uint16_t>(bytes, {0, 1, 2, 0, 2, 3});
  append<std::uint16_t>(bytes, {2, 0});
  append<float>(bytes, {5, 6, 7});
  return bytes;
}

json square() {
  return json::parse(R"({
    "asset": {"version": "2.0"},
    "scene": 0,
    "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}, "indices": 3}]}],
    "buffers": [{"byteLength": 156, "uri": "square.bin"}],
    "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 48},
                    {"buffer": 0, "byteOffset": 96, "byteLength": 32}, {"buffer": 0, "byteOffset": 128, "byteLength": 12},
                    {"buffer": 0, "byteOffset": 140, "byteLength": 2}, {"buffer": 0, "byteOffset": 144, "byteLength": 12}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
                  {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC3"},
                  {"bufferView": 2, "componentType": 5126, "count": 4, "type": "VEC2"},
                  {"bufferView": 3, "componentType": 5123, "count": 6, "type": "SCALAR"}]
  })");
}

fs::path write(const Folder& folder, const json& model, const std::string& bytes = buffer()) {
  folder.write("square.bin", bytes);
  return folder.write("square.gltf", model.dump());
}

std::string binary(const json& model, const std::string& bytes) {
  std::string text = model.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::string glb = "glTF";
  append<std::uint32_t>(glb, {2, static_cast<std::uint32_t>(12 + 8 + text.size() + 8 + bytes.size())});
  append<std::uint32_t>(glb, {static_cast<std::uint32_t>(text.size())});
  glb += "JSON" + text;
  append<std::uint32_t>(glb, {static_cast<std::uint32_t>(bytes.size())});
  return glb + std::string("BIN\0", 4) + bytes;
}

json embedded() {
  json model = square();
  model["buffers"][0].erase("uri");
  return model;
}

// A value that is put at a place of the sound model, and what the reader must say of it. A null value removes the key.
struct BadGltf {
  const char* name;
  const char* pointer;
  const char* value;
  std::vector<std::string> message;
};

class BadGltfs : public ::testing::TestWithParam<BadGltf> {};

TEST_P(BadGltfs, SayWhereAndWhy) {
  const Folder folder;
  json model = square();
  model[json::json_pointer(GetParam().pointer)] = json::parse(GetParam().value);
  const fs::path path = write(folder, model);
  std::vector<std::string> parts = GetParam().message;
  parts.push_back("square.gltf: ");
  const long before = peak_kilobytes();
  expect_error([&] { read_scene(path); }, parts);
  EXPECT_LT(peak_kilobytes() - before, 64 * 1024);
}

INSTANTIATE_TEST_SUITE_P(
    Extremes49Counts, BadGltfs,
    ::testing::Values(
        BadGltf{"CountZero", "/accessors/0/count", "0", {"/accessors/0/count", "found 0"}},
        BadGltf{"CountOneTooMany", "/accessors/0/count", "5", {"/accessors/0/count", "5 elements", "bufferView 0"}},
        BadGltf{"CountHuge", "/accessors/0/count", "4294967295", {"/accessors/0/count", "4294967295"}},
        BadGltf{"IndexCountHuge", "/accessors/3/count", "4294967295", {"/accessors/3/count", "4294967295"}},
        BadGltf{"IndexCountLarge", "/accessors/3/count", "60000000", {"/accessors/3/count", "60000000 elements"}},
        BadGltf{"CountNegative", "/accessors/0/count", "-1", {"count"}},
        BadGltf{"CountAsString", "/accessors/0/count", "\"4\"", {"count"}},
        BadGltf{"OffsetBeyond", "/accessors/0/byteOffset", "40", {"/accessors/0/count", "offset 40"}},
        BadGltf{"OffsetHuge", "/accessors/0/byteOffset", "4294967295", {"accessors", ""}},
        BadGltf{"ViewBeyondBuffer", "/bufferViews/1/byteOffset", "120", {"/bufferViews/1", "156 bytes of buffer 0"}},
        BadGltf{"ViewHuge", "/bufferViews/1/byteLength", "4294967295", {"/bufferViews/1", "4294967295"}},
        BadGltf{"StrideTooSmall", "/bufferViews/0/byteStride", "4", {"/bufferViews/0/byteStride", "12 to 252"}},
        BadGltf{"StrideTooLarge", "/bufferViews/0/byteStride", "300", {"tride"}},
        BadGltf{"BufferLongerThanFile", "/buffers/0/byteLength", "157", {"157"}},
        BadGltf{"BufferHuge", "/buffers/0/byteLength", "4294967295", {"4294967295"}},
        BadGltf{"FewerNormals", "/accessors/1/count", "3", {"/attributes/NORMAL", "3 elements", "4"}},
        BadGltf{"CornersNotInThrees", "/accessors/3/count", "5", {"/primitives/0", "5 corners", "multiple of 3"}}),
    CaseName());

INSTANTIATE_TEST_SUITE_P(
    Extremes50References, BadGltfs,
    ::testing::Values(
        BadGltf{"SceneIndex", "/scene", "1", {"/scene", "index 1"}},
        BadGltf{"RootIndex", "/scenes/0/nodes/0", "9", {"/scenes/0/nodes/0", "index 9", "1 nodes"}},
        BadGltf{"MeshIndex", "/nodes/0/mesh", "3", {"/nodes/0/mesh", "index 3", "1 meshes"}},
        BadGltf{"MeshNegative", "/nodes/0/mesh", "-2", {"/nodes/0/mesh", "index -2"}},
        BadGltf{"ChildIndex", "/nodes/0/children", "[7]", {"/nodes/0/children/0", "index 7"}},
        BadGltf{"Cycle", "/nodes/0/children", "[0]", {"/nodes/0", "reached twice", "a tree"}},
        BadGltf{
            "AccessorIndex", "/meshes/0/primitives/0/attributes/POSITION", "9", {"/attributes/POSITION", "index 9"}},
        BadGltf{"IndicesIndex", "/meshes/0/primitives/0/indices", "4", {"indices", "out of bounds"}},
        BadGltf{"ViewIndex", "/accessors/0/bufferView", "6", {"/accessors/0/bufferView", "index 6"}},
        BadGltf{"BufferIndex", "/bufferViews/0/buffer", "1", {"/bufferViews/0/buffer", "index 1", "1 buffers"}},
        BadGltf{"MaterialIndex", "/meshes/0/primitives/0/material", "0", {"/primitives/0/material", "no materials"}},
        BadGltf{"CameraIndex", "/nodes/0/camera", "0", {"/nodes/0/camera", "no cameras"}},
        BadGltf{"LightIndex",
                "/nodes/0/extensions",
                "{\"KHR_lights_punctual\": {\"light\": 3}}",
                {"/nodes/0", "no lights"}}),
    CaseName());

INSTANTIATE_TEST_SUITE_P(
    Types, BadGltfs,
    ::testing::Values(
        BadGltf{"PositionsAsVec2", "/accessors/0/type", "\"VEC2\"", {"/accessors/0/type", "2 components", "3"}},
        BadGltf{"TypeUnknown", "/accessors/0/type", "\"VEC5\"", {"accessor"}},
        BadGltf{"ComponentTypeUnknown", "/accessors/0/componentType", "5124", {"5124"}},
        BadGltf{"IndicesAsFloats", "/accessors/3/componentType", "5126", {"/accessors/3/componentType", "5126"}},
        BadGltf{"ModeUnknown", "/meshes/0/primitives/0/mode", "9", {"/mode", "9"}},
        BadGltf{"PointsOnly", "/meshes/0/primitives/0/mode", "0", {"no triangles"}},
        BadGltf{"NoPosition", "/meshes/0/primitives/0/attributes", "{\"NORMAL\": 1}", {"/attributes", "no POSITION"}},
        BadGltf{"NoScenes", "/scenes", "[]", {"/scenes"}}, BadGltf{"NoMeshes", "/nodes/0", "{}", {"no triangles"}},
        BadGltf{"Version1", "/asset/version", "\"1.0\"", {"/asset/version", "1.0"}},
        BadGltf{"Draco", "/extensionsRequired", "[\"KHR_draco_mesh_compression\"]", {"/extensionsRequired/0", "draco"}},
        BadGltf{"BufferMissing", "/buffers/0/uri", "\"no.bin\"", {"/buffers", "no.bin", "exists"}},
        BadGltf{"BufferFromTheNet", "/buffers/0/uri", "\"http://x/y.bin\"", {"x/y.bin"}},
        BadGltf{"TranslationOfTwo", "/nodes/0/translation", "[1, 2]", {"/nodes/0/translation", "2 numbers", "3"}},
        BadGltf{"Extremes48_1e38", "/nodes/0/translation", "[1, 1e38, 2]", {"/nodes/0/translation", "1e+38"}},
        BadGltf{"Extremes48_Denormal", "/nodes/0/scale", "[1, 1e-40, 2]", {"/nodes/0/scale", "denormal"}},
        BadGltf{"MatrixOfNine", "/nodes/0/matrix", "[1, 0, 0, 0, 1, 0, 0, 0, 1]", {"/nodes/0/matrix", "9 numbers"}},
        BadGltf{"MatrixProjective",
                "/nodes/0/matrix",
                "[1,0,0,1, 0,1,0,0, 0,0,1,0, 0,0,0,1]",
                {"/nodes/0/matrix", "0 0 0 1"}},
        BadGltf{"QuaternionLong", "/nodes/0/rotation", "[0, 0, 0, 2]", {"/nodes/0/rotation", "length 2"}}),
    CaseName());

TEST(Gltf, SquareIsReadWithItsFrame) {
  const Folder folder;
  const Scene scene = read_scene(write(folder, square()));
  const Mesh& mesh = scene.objects.at(0).mesh;
  ASSERT_EQ(mesh.vertices.size(), 4U);
  EXPECT_EQ(mesh.triangles[1], (std::array<std::uint32_t, 3>{0, 2, 3}));
  EXPECT_EQ(mesh.vertices[2].P, (Vec3{1, 1, 0}));
  EXPECT_EQ(mesh.vertices[2].uv, (Vec2{1, 0}));
  EXPECT_EQ(mesh.vertices[2].N, (Vec3{0, 0, 1}));
  EXPECT_EQ(scene.config, "perspective");
}

TEST(Gltf, BinaryAndEmbeddedBuffersAreTheSame) {
  const Folder folder;
  const Mesh mesh = read_scene(write(folder, square())).objects.at(0).mesh;
  const Mesh glb = read_scene(folder.write("a.glb", binary(embedded(), buffer()))).objects.at(0).mesh;
  ASSERT_EQ(glb.vertices.size(), mesh.vertices.size());
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(glb.vertices[i].P, mesh.vertices[i].P);
}

TEST(Gltf, SparseSubstitutes) {
  const Folder folder;
  json model = square();
  model["accessors"][0]["sparse"] =
      json::parse(R"({"count": 1, "indices": {"bufferView": 4, "componentType": 5123}, "values": {"bufferView": 5}})");
  EXPECT_EQ(read_scene(write(folder, model)).objects[0].mesh.vertices[2].P, (Vec3{5, 6, 7}));
  model["accessors"][0]["sparse"]["count"] = 2;
  expect_error([&] { read_scene(write(folder, model)); }, {"/accessors/0/sparse/indices/count", "bufferView 4"});
  model["accessors"][0]["sparse"]["count"] = 5;
  expect_error([&] { read_scene(write(folder, model)); }, {"/accessors/0/sparse/count", "1 to 4"});
  model["accessors"][0]["sparse"]["count"] = 1;
  std::string bytes = buffer();
  bytes[140] = 4;
  expect_error([&] { read_scene(write(folder, model, bytes)); }, {"/accessors/0/sparse/indices", "less than 4"});
}

TEST(Gltf, Extremes48FloatsThatAreNoNumbers) {
  const Folder folder;
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity(), 1e-40F, 1e38F}) {
    std::string bytes = buffer();
    std::memcpy(bytes.data() + 2 * 12 + 4, &bad, sizeof bad);
    expect_error([&] { read_scene(write(folder, square(), bytes)); }, {"square.gltf: /accessors/0", "element 2"});
  }
  std::string bytes = buffer();
  const float minus_zero = -0.0F;
  std::memcpy(bytes.data() + 2 * 12 + 4, &minus_zero, sizeof minus_zero);
  EXPECT_FALSE(std::signbit(read_scene(write(folder, square(), bytes)).objects[0].mesh.vertices[2].P.y));
}

TEST(Gltf, Extremes50VertexIndexOutOfRange) {
  const Folder folder;
  std::string bytes = buffer();
  bytes[128 + 10] = 4;
  expect_error([&] { read_scene(write(folder, square(), bytes)); },
               {"/accessors/3", "vertex 4 in element 5", "less than 4"});
}

TEST(Gltf, Extremes49TextTruncatedAtEveryByte) {
  const Folder folder;
  folder.write("square.bin", buffer());
  const std::string whole = square().dump();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    SCOPED_TRACE(size);
    const fs::path path = folder.write("cut.gltf", whole.substr(0, size));
    expect_error([&] { read_scene(path); }, {"cut.gltf"});
  }
}

TEST(Gltf, Extremes49BinaryTruncatedAtEveryByte) {
  const Folder folder;
  const std::string whole = binary(embedded(), buffer());
  for (std::size_t size = 0; size < whole.size(); ++size) {
    SCOPED_TRACE(size);
    const fs::path path = folder.write("cut.glb", whole.substr(0, size));
    expect_error([&] { read_scene(path); }, {"cut.glb"});
  }
  EXPECT_EQ(read_scene(folder.write("cut.glb", whole)).objects.size(), 1U);
}

TEST(Gltf, Extremes49BufferTruncatedAtEveryByte) {
  const Folder folder;
  for (std::size_t size = 0; size < buffer().size(); ++size) {
    SCOPED_TRACE(size);
    expect_error([&] { read_scene(write(folder, square(), buffer().substr(0, size))); }, {"square."});
  }
}

TEST(Gltf, Extremes49ContainerLies) {
  const Folder folder;
  const std::string whole = binary(embedded(), buffer());
  const auto with = [&](std::size_t at, std::uint32_t word) {
    std::string bytes = whole;
    std::memcpy(bytes.data() + at, &word, 4);
    return folder.write("lie.glb", bytes);
  };
  expect_error([&] { read_scene(with(0, 0x46546c68)); }, {"lie.glb: ", "wrong magic"});
  expect_error([&] { read_scene(with(4, 3)); }, {"version 3"});
  expect_error([&] { read_scene(with(8, 0xffffffff)); }, {"4294967295"});
  expect_error([&] { read_scene(with(12, 0xffffffff)); }, {"chunk 0", "4294967295"});
  expect_error([&] { read_scene(with(16, 0)); }, {"JSON"});
}

// Whichever three bytes are wrong, the reader returns a scene or one clear message.
TEST(Gltf, Extremes49RandomBytesSeed1) {
  const Folder folder;
  const std::string whole = binary(embedded(), buffer());
  std::mt19937 random(1);
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string bytes = whole;
    for (int k = 0; k < 3; ++k) bytes[random() % bytes.size()] = static_cast<char>(random());
    try {
      read_scene(folder.write("wrong.glb", bytes));
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr("wrong.glb"));
      ++refused;
    }
  }
  EXPECT_GT(refused, 1000);
  EXPECT_LT(refused, 3000);
}

// Node matrices: hierarchy, and a mirroring scale, which turns windings round without turning faces away.
TEST(Gltf, NodesMultiplyAndMirrorsStayVisible) {
  const Folder folder;
  json model = square();
  model["nodes"] = json::parse(R"([{"children": [1], "scale": [-2, 2, 2]}, {"mesh": 0, "translation": [1, 0, 0]}])");
  const Scene scene = read_scene(write(folder, model));
  const Mat4& m = scene.objects.at(0).to_world;
  EXPECT_EQ(m(0, 0), -2);
  EXPECT_EQ(m(0, 3), -2);
  EXPECT_EQ(build_frame(load_config("perspective"), scene).draws.at(0).triangles.size(), 2U);
  model["nodes"][0]["scale"] = {2, 2, -2};  // turned to face away
  EXPECT_EQ(build_frame(load_config("perspective"), read_scene(write(folder, model))).draws.at(0).triangles.size(), 0U);
}

TEST(Gltf, CameraAndStrongestLight) {
  const Folder folder;
  json model = square();
  model["nodes"] = json::parse(R"([
    {"mesh": 0}, {"camera": 0, "translation": [0, 0, 5]},
    {"extensions": {"KHR_lights_punctual": {"light": 0}}, "translation": [1, 2, 3]},
    {"extensions": {"KHR_lights_punctual": {"light": 1}}, "rotation": [0, 0.7071068, 0, 0.7071068]}])");
  model["scenes"][0]["nodes"] = {0, 1, 2, 3};
  model["cameras"] = json::parse(R"([{"type": "orthographic",
    "orthographic": {"xmag": 2, "ymag": 1, "znear": 0.5, "zfar": 10}}])");
  model["extensionsUsed"] = {"KHR_lights_punctual"};
  model["extensions"] = json::parse(R"({"KHR_lights_punctual": {"lights": [
    {"type": "point", "intensity": 2}, {"type": "directional", "intensity": 3}]}})");
  Notes notes;
  const Scene scene = read_scene(write(folder, model), &notes);
  EXPECT_FALSE(scene.camera.perspective);
  EXPECT_EQ(scene.camera.half_height, 1);
  EXPECT_EQ(scene.width, 1024);
  EXPECT_EQ(scene.height, 512);
  EXPECT_TRUE(scene.light.at_infinity);
  EXPECT_NEAR(scene.light.position.x, 1, 1e-6);  // -z of the node points to -x
  EXPECT_EQ(notes.size(), 1U);
  model["extensions"]["KHR_lights_punctual"]["lights"][0]["intensity"] = 9;
  EXPECT_EQ(read_scene(write(folder, model)).light.position, (Vec3{1, 2, 3}));
  model["cameras"][0]["orthographic"]["ymag"] = 0;
  expect_error([&] { read_scene(write(folder, model)); }, {"/cameras/0/orthographic", "ymag = 0"});
}

TEST(Gltf, BadTexturesAndImages) {
  const Folder folder;
  json model = square();
  model["meshes"][0]["primitives"][0]["material"] = 0;
  const auto says = [&](const char* parts, const std::vector<std::string>& message) {
    json changed = model;
    changed.update(json::parse(parts));
    expect_error([&] { read_scene(write(folder, changed)); }, message);
  };
  const std::string material = R"("materials": [{"normalTexture": {"index": 0}}])";
  folder.write("text.png", "no image");
  says(("{" + material + "}").c_str(), {"/materials/0/normalTexture/index", "no textures"});
  says(("{" + material + R"(, "textures": [{"source": 0}]})").c_str(), {"/textures/0/source", "no images"});
  says(("{" + material + R"(, "textures": [{"source": 0}], "images": [{"uri": "no%20map.png"}]})").c_str(),
       {"/images/0/uri", "no map.png"});
  says(("{" + material + R"(, "textures": [{"source": 0}], "images": [{"uri": "text.png"}]})").c_str(),
       {"text.png", "no image"});
  says(("{" + material + R"(, "textures": [{"source": 0}], "images": [{"uri": "https://a/b.png"}]})").c_str(),
       {"/images/0/uri"});
  says(("{" + material + R"(, "textures": [{"source": 0}], "images": [{"bufferView": 6}]})").c_str(),
       {"/images/0/bufferView", "index 6", "0 to 5"});
  says(("{" + material + R"(, "textures": [{"source": 0}], "images": [{"bufferView": -1}]})").c_str(),
       {"/images/0/bufferView", "found -1", "the index of a bufferView"});
  says(("{" + material + R"(, "textures": [{"source": 0}], "images": [{"bufferView": 0, "uri": "a.png"}]})").c_str(),
       {"/images/0", "both uri and bufferView"});
  says(R"({"materials": [{"pbrMetallicRoughness": {"roughnessFactor": 1.5}}]})",
       {"/materials/0", "roughnessFactor = 1.5"});
  says(R"({"materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 1, 2, 1]}}]})",
       {"/materials/0", "baseColorFactor"});
}

// tinygltf took these bytes on trust, from wherever they lie.
TEST(Gltf, ImagesOutsideTheBuffer) {
  const Folder folder;
  json model = square();
  model["meshes"][0]["primitives"][0]["material"] = 0;
  model["materials"] = json::parse(R"([{"normalTexture": {"index": 0}}])");
  model["textures"] = json::parse(R"([{"source": 0}])");
  model["images"] = json::parse(R"([{"bufferView": 6, "mimeType": "image/png"}])");
  model["bufferViews"].push_back(json::parse(R"({"buffer": 0, "byteOffset": 2147483647, "byteLength": 16})"));
  expect_error([&] { read_scene(write(folder, model)); }, {"/bufferViews/6", "bytes 2147483647", "156 bytes"});
  model["bufferViews"][6] = json::parse(R"({"buffer": 3, "byteLength": 16})");
  expect_error([&] { read_scene(write(folder, model)); }, {"/bufferViews/6/buffer", "index 3"});
}

// Zeros that no byte of the file stands for.
TEST(Gltf, ElementsOutOfNothing) {
  const Folder folder;
  json model = square();
  model["accessors"][0] = json::parse(R"({"componentType": 5126, "count": 65537, "type": "VEC3"})");
  model["meshes"][0] = json::parse(R"({"primitives": [{"attributes": {"POSITION": 0}}]})");
  const fs::path path = write(folder, model);
  const long before = peak_kilobytes();
  expect_error([&] { read_scene(path); }, {"/accessors/0/count", "65537 elements without bufferView", "65536"});
  model["accessors"][0]["count"] = 65535;
  EXPECT_EQ(read_scene(write(folder, model)).objects.at(0).mesh.triangles.size(), 21845U);
  EXPECT_LT(peak_kilobytes() - before, 64 * 1024);
}

bool holds(const Notes& notes, const std::string& text) {
  return std::ranges::any_of(notes, [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

// A normal map of the square, and the image that it shows.
void add_map(const Folder& folder, json& model, const std::string& name = "n.png") {
  std::vector<float> pixels;
  for (int i = 0; i < 64; ++i) pixels.insert(pixels.end(), {0.4F, static_cast<float>(i) / 64, 0.9F});
  const auto output = OIIO::ImageOutput::create("n.png");
  ASSERT_TRUE(output->open((folder.path() / name).string(), OIIO::ImageSpec(8, 8, 3, OIIO::TypeDesc::UINT8)));
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()));
  ASSERT_TRUE(output->close());
  model["meshes"][0]["primitives"][0]["material"] = 0;
  model["materials"] = json::parse(R"([{"normalTexture": {"index": 0}}])");
  model["textures"] = json::parse(R"([{"source": 0}])");
  model["images"] = json::array({{{"uri", name}}});
}

TEST(Gltf, ByteOrderMarksAndIntegersWithAPoint) {
  const Folder folder;
  folder.write("square.bin", buffer());
  std::string text = square().dump();
  const std::string count = "\"count\":4", with_point = count + ".0";
  for (std::size_t at = 0; (at = text.find(count, at)) != std::string::npos; at += with_point.size()) {
    text.replace(at, count.size(), with_point);
  }
  const Scene scene = read_scene(folder.write("a.gltf", "\xef\xbb\xbf" + text));
  EXPECT_EQ(scene.objects.at(0).mesh.vertices.size(), 4U);
  EXPECT_EQ(read_scene(folder.write("b.glb", binary(embedded(), buffer()))).objects.size(), 1U);
}

TEST(Gltf, BuffersWithinTheFile) {
  const Folder folder;
  json model = square();
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::string bytes = buffer();
  std::string base64;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t j = 0; j < 3; ++j) word = word << 8 | static_cast<unsigned char>(bytes[i + j]);
    for (int shift = 18; shift >= 0; shift -= 6) base64 += digits[word >> shift & 63];
  }
  for (const char* type : {"application/octet-stream", "application/gltf-buffer;charset=utf-8", ""}) {
    model["buffers"][0]["uri"] = std::string("data:") + type + ";base64," + base64;
    EXPECT_EQ(read_scene(folder.write("a.gltf", model.dump())).objects.at(0).mesh.vertices[2].P, (Vec3{1, 1, 0}))
        << type;
  }
  // Megabytes that are no buffer make a short message.
  model["buffers"][0]["uri"] = "data:model/mine;base64," + std::string(3000000, 'A');
  expect_error([&] { read_scene(folder.write("a.gltf", model.dump())); },
               {"/buffers/0/uri", "model/mine", "octet-stream"});
  model["buffers"][0]["uri"] = std::string(3000000, 'A');
  expect_error([&] { read_scene(folder.write("a.gltf", model.dump())); }, {"/buffers/0/uri"});
  expect_error([&] { read_scene(folder.write("a.gltf", "{\"a\": \"" + std::string(3000000, 'A'))); },
               {"no sound glTF"});
}

// Zeros, which a sparse accessor starts from and any other may be.
TEST(Gltf, AccessorsWithoutAView) {
  const Folder folder;
  json model = square();
  model["accessors"][2].erase("bufferView");
  const Scene scene = read_scene(write(folder, model));
  for (const Vertex& v : scene.objects.at(0).mesh.vertices) EXPECT_EQ(v.uv, (Vec2{0, 0}));
}

TEST(Gltf, MatricesThatAreAlmostAffine) {
  const Folder folder;
  json model = square();
  model["nodes"][0]["matrix"] = {2, 0, 0, 1e-9, 0, 2, 0, 0, 0, 0, 2, -1e-9, 4, 6, 8, 2};
  const Mat4 m = read_scene(write(folder, model)).objects.at(0).to_world;
  EXPECT_EQ(m(0, 0), 1);
  EXPECT_EQ(m(1, 3), 3);
  EXPECT_EQ(m(3, 0), 0);
  EXPECT_EQ(m(3, 3), 1);
}

TEST(Gltf, WithoutScenesAllNodesAreDrawn) {
  const Folder folder;
  json model = square();
  model.erase("scenes");
  model.erase("scene");
  model["nodes"] = json::parse(R"([{"children": [1]}, {"mesh": 0}, {"mesh": 0}])");
  Notes notes;
  EXPECT_EQ(read_scene(write(folder, model), &notes).objects.size(), 2U);
  EXPECT_TRUE(holds(notes, "/scenes"));
}

struct Noted {
  const char* name;
  const char* pointer;
  const char* value;
  const char* note;
};
class NotedParts : public ::testing::TestWithParam<Noted> {};

// One note with the name and the place, and the picture without it.
TEST_P(NotedParts, AreNotApplied) {
  const Folder folder;
  json model = square();
  add_map(folder, model);
  model[json::json_pointer(GetParam().pointer)] = json::parse(GetParam().value);
  Notes notes;
  EXPECT_EQ(read_scene(write(folder, model), &notes).objects.size(), 1U);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_TRUE(holds(notes, GetParam().note)) << notes[0];
  EXPECT_TRUE(holds(notes, "square.gltf: /")) << notes[0];
}

INSTANTIATE_TEST_SUITE_P(
    All, NotedParts,
    ::testing::Values(Noted{"Extension", "/materials/0/extensions", R"({"KHR_materials_clearcoat": {}})",
                            "KHR_materials_clearcoat"},
                      Noted{"ExtensionOfANode", "/nodes/0/extensions", R"({"EXT_mesh_gpu_instancing": {}})",
                            "EXT_mesh_gpu_instancing"},
                      Noted{"Blend", "/materials/0/alphaMode", "\"BLEND\"", "BLEND"},
                      Noted{"Mask", "/materials/0/alphaMode", "\"MASK\"", "MASK"},
                      Noted{"Emission", "/materials/0/emissiveFactor", "[0, 0, 1]", "emission"},
                      Noted{"Occlusion", "/materials/0/occlusionTexture", R"({"index": 0})", "occlusion"},
                      Noted{"Metallic", "/materials/0/pbrMetallicRoughness", R"({"metallicFactor": 1})", "metallic"},
                      Noted{"Skin", "/meshes/0/primitives/0/attributes/JOINTS_0", "1", "skins"},
                      Noted{"SecondColour", "/meshes/0/primitives/0/attributes/COLOR_1", "1", "COLOR_1"},
                      Noted{"Morph", "/meshes/0/primitives/0/targets", R"([{"POSITION": 0}])", "morph targets"},
                      Noted{"Animation", "/animations", R"([{"channels": [], "samplers": []}])", "animations"},
                      Noted{"SecondScene", "/scenes/1", R"({"nodes": []})", "scenes"},
                      Noted{"OtherCoordinates", "/materials/0/pbrMetallicRoughness",
                            R"({"baseColorTexture": {"index": 0, "texCoord": 1}})", "other texture coordinates"}),
    CaseName());

TEST(Gltf, RequiredExtensionsAreNamedBeforeWhatTheyHide) {
  const Folder folder;
  for (const char* name :
       {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_texture_basisu", "MINE_wings"}) {
    json model = square();
    model["extensionsRequired"] = {name};
    model["accessors"][0]["bufferView"] = 99;
    model["buffers"][0]["uri"] = "gone.bin";
    expect_error([&] { read_scene(write(folder, model)); }, {"/extensionsRequired/0", name});
  }
  json model = square();
  model["extensionsRequired"] = {"KHR_texture_transform", "EXT_texture_webp", "KHR_mesh_quantization"};
  EXPECT_EQ(read_scene(write(folder, model)).objects.size(), 1U);
}

// The lower left quarter of the image, a quarter turned clockwise: the example of the extension's own text.
TEST(Gltf, TexturesAreTransformed) {
  const Folder folder;
  json model = square();
  add_map(folder, model);
  model["materials"][0]["normalTexture"]["extensions"]["KHR_texture_transform"] = {
      {"offset", {0, 1}}, {"rotation", 1.57079632679}, {"scale", {0.5, 0.5}}};
  Notes notes;
  const Scene scene = read_scene(write(folder, model), &notes);
  EXPECT_TRUE(notes.empty());
  for (const Vertex& v : scene.objects.at(0).mesh.vertices) {
    const Vec2 written{v.P.x, 1 - v.P.y};
    EXPECT_NEAR(v.uv.x, 0.5 * written.y, 1e-9);
    EXPECT_NEAR(v.uv.y, 1 - 0.5 * written.x, 1e-9);
  }
}

TEST(Gltf, SpecularGlossinessIsRead) {
  const Folder folder;
  json model = square();
  add_map(folder, model);
  model["materials"] = json::parse(R"([{"extensions": {"KHR_materials_pbrSpecularGlossiness":
      {"diffuseFactor": [0.2, 0.4, 0.6, 1], "diffuseTexture": {"index": 0}, "glossinessFactor": 0.5}}}])");
  Notes notes;
  const Scene scene = read_scene(write(folder, model), &notes);
  EXPECT_TRUE(notes.empty());
  EXPECT_EQ(scene.config, "fine");
  EXPECT_NEAR(scene.objects.at(0).material.diffuse.y, 0.85 * 0.4, 1e-12);
  ASSERT_TRUE(scene.objects[0].texture);
  EXPECT_NEAR(scene.objects[0].texture->levels[0][0].colour[0], 102.0 / 255, 1e-6);
}

TEST(Gltf, ColoursOfVerticesMultiplyTheMaterial) {
  const Folder folder;
  json model = square();
  std::string bytes = buffer();
  const std::size_t at = bytes.size();
  for (int i = 0; i < 4; ++i) append<std::uint8_t>(bytes, {255, 0, 51, 255});
  model["buffers"][0]["byteLength"] = bytes.size();
  model["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", at}, {"byteLength", 16}});
  model["accessors"].push_back(
      {{"bufferView", 6}, {"componentType", 5121}, {"normalized", true}, {"count", 4}, {"type", "VEC4"}});
  model["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = 4;
  Notes notes;
  const Scene scene = read_scene(write(folder, model, bytes), &notes);
  EXPECT_TRUE(notes.empty());
  ASSERT_EQ(scene.objects.size(), 1U);
  EXPECT_NEAR(scene.objects[0].material.diffuse.x, 0.7, 1e-12);
  EXPECT_EQ(scene.objects[0].material.diffuse.y, 0);
  EXPECT_NEAR(scene.objects[0].material.diffuse.z, 0.14, 1e-12);
  bytes[at + 4] = 0;  // of the first triangle alone
  EXPECT_EQ(read_scene(write(folder, model, bytes), &notes).objects.size(), 2U);
  EXPECT_TRUE(holds(notes, "vertex colours are not interpolated"));
}

TEST(Gltf, NormalsOfNoLengthAreReplacedAndNoted) {
  const Folder folder;
  std::string bytes = buffer();
  std::memset(bytes.data() + 48 + 12, 0, 24);
  Notes notes;
  const Scene scene = read_scene(write(folder, square(), bytes), &notes);
  for (const Vertex& v : scene.objects.at(0).mesh.vertices) EXPECT_EQ(v.N, (Vec3{0, 0, 1}));
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_TRUE(holds(notes, "/attributes/NORMAL: 2 normals of no length"));
}

// No length, along the normal, no side: those of the texture coordinates, the others as they are.
TEST(Gltf, UnusableTangentsAreReplacedAndNoted) {
  const Folder folder;
  json model = square();
  add_map(folder, model);
  std::string bytes = buffer();
  const std::size_t at = bytes.size();
  const float s = std::sqrt(0.5F);
  append<float>(bytes, {0, 0, 0, 1, 0, 0, 1, 1, 0, 1, 0, 0, s, s, 0, 1});
  model["buffers"][0]["byteLength"] = bytes.size();
  model["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", at}, {"byteLength", 64}});
  model["accessors"].push_back({{"bufferView", 6}, {"componentType", 5126}, {"count", 4}, {"type", "VEC4"}});
  model["meshes"][0]["primitives"][0]["attributes"]["TANGENT"] = 4;
  Notes notes;
  const Scene scene = read_scene(write(folder, model, bytes), &notes);
  for (const Vertex& v : scene.objects.at(0).mesh.vertices) {
    const bool kept = v.P == Vec3{0, 1, 0};
    EXPECT_NEAR(length(v.T - (kept ? Vec3{std::sqrt(.5), std::sqrt(.5), 0} : Vec3{1, 0, 0})), 0, 1e-6);
    EXPECT_EQ(v.sign, 1);
  }
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_TRUE(holds(notes, "/attributes/TANGENT: 3 tangents"));
}

TEST(Gltf, TheViewIsOfWhatIsDrawn) {
  const Folder folder;
  const Scene plain = read_scene(write(folder, square()));
  json model = square();
  std::string bytes = buffer();
  append<float>(bytes, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 500, 500, 500});
  model["buffers"][0]["byteLength"] = bytes.size();
  model["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 156}, {"byteLength", 60}});
  model["accessors"][0] = {{"bufferView", 6}, {"componentType", 5126}, {"count", 5}, {"type", "VEC3"}};
  model["meshes"][0]["primitives"][0]["attributes"] = {{"POSITION", 0}};
  const Scene stray = read_scene(write(folder, model, bytes));
  EXPECT_EQ(stray.camera.world_to_eye.m, plain.camera.world_to_eye.m);
  EXPECT_EQ(stray.light.position, plain.light.position);
}

TEST(Gltf, JsonNestedDeeply) {
  const Folder folder;
  expect_error([&] { read_scene(folder.write("a.gltf", "{\"a\":" + std::string(200000, '['))); }, {"nested deeper"});
}

TEST(Extremes64, ThousandsOfDrawsOfOneMesh) {
  const Folder folder;
  json model = square();
  model["nodes"] = json::array();
  model["scenes"][0]["nodes"] = json::array();
  for (int i = 0; i < 5000; ++i) {
    model["nodes"].push_back({{"mesh", 0}, {"translation", {i % 100, i / 100, 0}}});
    model["scenes"][0]["nodes"].push_back(i);
  }
  EXPECT_EQ(read_scene(write(folder, model)).objects.size(), 5000U);
}

TEST(Extremes64, DeepNesting) {
  const Folder folder;
  json model = square();
  model["nodes"] = json::array();
  for (int i = 0; i < 1000; ++i) model["nodes"].push_back({{"children", {i + 1}}});
  model["nodes"].push_back({{"mesh", 0}});
  expect_error([&] { read_scene(write(folder, model)); }, {"nested deeper than 256"});
}

}  // namespace
}  // namespace wrinkle::test

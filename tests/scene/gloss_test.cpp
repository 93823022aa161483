// Gloss maps of all kinds of files.
#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "golden/vertex/scene.h"
#include "sim/config_file.h"
#include "sim/scene/scene_reader.h"
#include "support.h"

namespace wrinkle::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string kObject = "[[objects]]\nmesh = \"patch\"\n";
const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n";
const std::string kFace = "f 1/1/1 2/2/1 3/3/1 4/4/1\n";

// A PNG of 4 x 1 pixels, all channels of each given.
void write_png(const fs::path& path, int channels, const std::vector<float>& pixels) {
  const auto output = OIIO::ImageOutput::create("a.png");
  OIIO::ImageSpec spec(4, 1, channels, OIIO::TypeDesc::UINT8);
  spec["oiio:UnassociatedAlpha"] = 1;
  ASSERT_TRUE(output->open(path.string(), spec));
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()));
  ASSERT_TRUE(output->close());
}

void write_grey(const fs::path& path) { write_png(path, 1, {0, 0.2F, 0.4F, 1}); }
void write_coloured(const fs::path& path) { write_png(path, 3, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0.4F, 0.4F, 0.4F}); }

// The codes of level 0, in 255ths.
std::vector<int> gloss_of(const Object& object, std::size_t level = 0) {
  std::vector<int> codes;
  if (!object.texture) return codes;
  for (const ExactTexel& texel : object.texture->levels[level])
    codes.push_back(static_cast<int>(std::lround(255 * texel.gloss)));
  return codes;
}

TEST(GlossMaps, OfASceneFile) {
  const Folder folder;
  write_grey(folder.path() / "g.png");
  Notes notes;
  const fs::path path = folder.write("a.toml", kObject + "gloss_map = \"g.png\"\n");
  const Scene scene = read_scene(path, &notes);
  EXPECT_THAT(notes, IsEmpty());
  EXPECT_EQ(scene.config, "gloss");
  ASSERT_TRUE(scene.objects[0].texture);
  EXPECT_THAT(gloss_of(scene.objects[0]), ElementsAre(0, 51, 102, 255));
  EXPECT_THAT(gloss_of(scene.objects[0], 1), ElementsAre(26, 179)) << "levels are means, as those of base colours";
  EXPECT_EQ(scene.objects[0].texture->levels[0][0].colour, (std::array<float, 3>{1, 1, 1}));
  EXPECT_EQ(scene.objects[0].space, ShadingSpace::kWorld);
  EXPECT_EQ(load_config("gloss").gloss_map, 1);
}

TEST(GlossMaps, BesideHeightsAndBaseColours) {
  const Folder folder;
  write_grey(folder.path() / "g.png");
  write_coloured(folder.path() / "c.png");
  const std::string maps = "gloss_map = \"g.png\"\ndecal = \"c.png\"\nwrap = \"clamp\"\n";
  const Scene scene = read_scene(
      folder.write("a.toml", kObject + maps + "tessellation = 1\nheight = \"g.png\"\nmethod = \"eq8-11\"\n"));
  const ExactTexel& texel = scene.objects[0].texture->levels[0][1];
  EXPECT_NEAR(texel.gloss, 0.2, 1e-6);
  EXPECT_EQ(texel.colour, (std::array<float, 3>{0, 1, 0}));
  EXPECT_NE(texel.bump[0], 0);
  const Scene by_surface = read_scene(folder.write("b.toml", kObject + maps + "height = \"pinwheel\"\n"));
  for (const Object& object : by_surface.objects) EXPECT_NE(object.texture->levels[0][0].gloss, 1);
}

TEST(GlossMaps, InColourAreTakenAsLuminanceAndNoted) {
  const Folder folder;
  write_coloured(folder.path() / "c.png");
  Notes notes;
  const Scene scene = read_scene(folder.write("a.toml", kObject + "gloss_map = \"c.png\"\n"), &notes);
  EXPECT_THAT(gloss_of(scene.objects[0]), ElementsAre(54, 182, 18, 102));
  EXPECT_THAT(notes, ElementsAre(HasSubstr("a.toml:3:13: in colour; its luminance")));
  write_png(folder.path() / "c.png", 3, {0, 0, 0, 0.2F, 0.2F, 0.2F, 0.4F, 0.4F, 0.4F, 1, 1, 1});
  notes.clear();
  EXPECT_THAT(gloss_of(read_scene(folder.path() / "a.toml", &notes).objects[0]), ElementsAre(0, 51, 102, 255));
  EXPECT_THAT(notes, IsEmpty()) << "grey in three channels";
}

TEST(GlossMaps, BadOnesAreErrors) {
  const Folder folder;
  const auto read = [&](const std::string& value) {
    read_scene(folder.write("bad.toml", kObject + "gloss_map = " + value + "\n"));
  };
  expect_error([&] { read("\"no.png\""); }, {"bad.toml:3:13", "no.png"});
  expect_error([&] { read("3"); }, {"bad.toml:3:13", "gloss_map", "string"});
  folder.write("text.png", "no image at all");
  expect_error([&] { read("\"text.png\""); }, {"text.png", "no image"});
  write_grey(folder.path() / "g.png");
  folder.write("cut.png", read_bytes(folder.path() / "g.png").substr(0, 60));
  expect_error([&] { read("\"cut.png\""); }, {"cut.png", "cut short"});
  expect_error([&] { read_scene(folder.write("bad.toml", kObject + "gloss = \"g.png\"\n")); },
               {"bad.toml:3:1", "\"gloss\"", "gloss_map"});
}

// A texture of the scene file stands in the place of the model's.
TEST(GlossMaps, OfAModelThatTheSceneFileReplacesAreNoted) {
  const Folder folder;
  write_grey(folder.path() / "g.png");
  folder.write("a.mtl", "newmtl m\nmap_Ks g.png\nmap_Kd g.png\n");
  folder.write("a.obj", "mtllib a.mtl\nusemtl m\n" + kSquare + kFace);
  const auto read = [&](const std::string& lines) {
    Notes notes;
    const Scene scene = read_scene(folder.write("a.toml", "[[objects]]\nmesh = \"a.obj\"\n" + lines), &notes);
    return std::pair{scene, notes};
  };
  EXPECT_EQ(read("").first.config, "gloss");
  EXPECT_THAT(read("").second, IsEmpty());
  const auto [decal, decal_notes] = read("decal = \"g.png\"\n");
  EXPECT_EQ(decal.config, "fine");
  EXPECT_THAT(decal_notes, ElementsAre(HasSubstr("the gloss maps of the model are not drawn with a decal")));
  const auto [gloss, gloss_notes] = read("gloss_map = \"g.png\"\n");
  EXPECT_EQ(gloss.config, "gloss");
  EXPECT_THAT(gloss_notes, ElementsAre(HasSubstr("the base colours of the model are not drawn with a gloss map")));
}

TEST(GlossMaps, OfAnMtlFile) {
  const Folder folder;
  write_grey(folder.path() / "g.png");
  write_coloured(folder.path() / "c.png");
  const fs::path path = folder.write("a.obj", "mtllib a.mtl\nusemtl m\n" + kSquare + kFace);
  const auto read = [&](const std::string& lines, Notes& notes) {
    notes.clear();
    folder.write("a.mtl", "newmtl m\n" + lines);
    return read_scene(path, &notes);
  };
  Notes notes;
  const Scene plain = read("Ks .5 .5 .5\nNs 64\nmap_Ks g.png\n", notes);
  EXPECT_THAT(notes, IsEmpty());
  EXPECT_EQ(plain.config, "gloss");
  EXPECT_EQ(plain.objects[0].material.specular, (Vec3{.5, .5, .5}));
  EXPECT_THAT(gloss_of(plain.objects[0]), ElementsAre(0, 51, 102, 255));
  EXPECT_EQ(read("map_Ks g.png\n", notes).objects[0].material.specular, (Vec3{1, 1, 1}))
      << "a map without a Ks that it could be a factor of";
  EXPECT_THAT(gloss_of(read("map_ks -mm 0.2 0.5 g.png\n", notes).objects[0]), ElementsAre(51, 77, 102, 179));
  EXPECT_THAT(gloss_of(read("map_Ks -imfchan g c.png\n", notes).objects[0]), ElementsAre(0, 255, 0, 102));
  EXPECT_THAT(notes, IsEmpty()) << "the channel was asked for";
  EXPECT_THAT(gloss_of(read("map_Ks c.png\n", notes).objects[0]), ElementsAre(54, 182, 18, 102));
  EXPECT_THAT(notes, ElementsAre(HasSubstr("a.mtl:2:8: \"c.png\": in colour")));
  const Scene all = read("map_Kd -s 2 2 1 c.png\nbump g.png\nmap_Ks -clamp on g.png\n", notes);
  EXPECT_THAT(notes, ElementsAre(HasSubstr("a.mtl:2"), HasSubstr("a.mtl:4")));
  EXPECT_EQ(gloss_of(all.objects[0])[1], 51);
  EXPECT_EQ(all.objects[0].wrap_u, Wrap::kRepeat);
  expect_error([&] { read("map_Ks no.png\n", notes); }, {"a.mtl:2:8", "no.png"});
}

// A square with a texture of the image and one material.
nlohmann::json square(const Folder& folder, const nlohmann::json& material) {
  const float values[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 1, 1, 1, 1, 0, 0, 0};
  folder.write("square.bin", {reinterpret_cast<const char*>(values), sizeof values});
  auto model = nlohmann::json::parse(R"({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "mode": 6, "material": 0}]}],
    "buffers": [{"byteLength": 80, "uri": "square.bin"}],
    "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 32}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
                  {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"}],
    "images": [{"uri": "g.png"}, {"uri": "c.png"}], "samplers": [{"wrapS": 33071}],
    "textures": [{"source": 0, "sampler": 0}, {"source": 1}]
  })");
  model["materials"] = nlohmann::json::array({material});
  return model;
}

TEST(GlossMaps, OfAGltfFile) {
  const Folder folder;
  write_png(folder.path() / "g.png", 4, {1, 0, 0, 0, 0, 1, 0, 0.2F, 0, 0, 1, 0.4F, 1, 1, 1, 1});
  write_coloured(folder.path() / "c.png");
  Notes notes;
  const auto read = [&](const char* material) {
    notes.clear();
    return read_scene(folder.write("a.gltf", square(folder, nlohmann::json::parse(material)).dump()), &notes);
  };
  const Scene plain = read(R"({"pbrMetallicRoughness": {"roughnessFactor": 0.5}})");
  const Scene half = read(R"({"pbrMetallicRoughness": {"roughnessFactor": 0.5}, "extensions": {"KHR_materials_specular":
      {"specularFactor": 0.5, "specularTexture": {"index": 0}, "specularColorFactor": [1, 0.5, 0]}}})");
  EXPECT_THAT(notes, IsEmpty());
  EXPECT_EQ(plain.config, "perspective");
  EXPECT_EQ(half.config, "gloss");
  EXPECT_NEAR(half.objects[0].material.specular.x, 0.5 * plain.objects[0].material.specular.x, 1e-12);
  EXPECT_NEAR(half.objects[0].material.specular.y, 0.25 * plain.objects[0].material.specular.y, 1e-12);
  EXPECT_EQ(half.objects[0].material.specular.z, 0);
  EXPECT_EQ(half.objects[0].wrap_u, Wrap::kClamp);
  EXPECT_THAT(gloss_of(half.objects[0]), ElementsAre(0, 51, 102, 255)) << "alpha alone";
  const Scene both = read(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 1}}, "extensions":
      {"KHR_materials_specular": {"specularTexture": {"index": 0}}}})");
  EXPECT_THAT(notes, ElementsAre(HasSubstr("drawn with the wrap modes of the base colour")));
  EXPECT_EQ(both.objects[0].wrap_u, Wrap::kRepeat);
  EXPECT_THAT(gloss_of(both.objects[0]), ElementsAre(0, 51, 102, 255));
  EXPECT_EQ(both.objects[0].texture->levels[0][0].colour, (std::array<float, 3>{1, 0, 0}));
  const Scene other = read(R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 1}}, "extensions":
      {"KHR_materials_specular": {"specularTexture": {"index": 0, "texCoord": 1}}}})");
  EXPECT_THAT(notes, ElementsAre(HasSubstr("other texture coordinates than the base colour; left out")));
  EXPECT_EQ(other.config, "fine");
  const Scene none = read(R"({"extensions": {"KHR_materials_specular": {"specularTexture": {"index": 1},
      "specularColorTexture": {"index": 1}}}})");
  EXPECT_THAT(notes, ElementsAre(HasSubstr("has no alpha"), HasSubstr("the texture of specular colour")));
  EXPECT_FALSE(none.objects[0].texture);
  EXPECT_EQ(none.config, "perspective");
  expect_error([&] { read(R"({"extensions": {"KHR_materials_specular": {"specularFactor": 2}}})"); },
               {"specularFactor", "between"});
  expect_error([&] { read(R"({"extensions": {"KHR_materials_specular": {"specularTexture": {"index": 7}}}})"); },
               {"specularTexture/index", "index 7"});
}

TEST(GlossMaps, OfSpecularGlossiness) {
  const Folder folder;
  write_png(folder.path() / "g.png", 4, {0, 0, 0, 1, 0.2F, 0.2F, 0.2F, 1, 0.4F, 0.4F, 0.4F, 0.5F, 1, 1, 1, 1});
  write_coloured(folder.path() / "c.png");
  Notes notes;
  const auto material = nlohmann::json::parse(R"({"extensions": {"KHR_materials_pbrSpecularGlossiness":
      {"specularGlossinessTexture": {"index": 0}}}})");
  const Scene scene = read_scene(folder.write("a.gltf", square(folder, material).dump()), &notes);
  EXPECT_THAT(gloss_of(scene.objects[0]), ElementsAre(0, 51, 102, 255));
  EXPECT_THAT(notes, ElementsAre(HasSubstr("only the colour is used")));
}

}  // namespace
}  // namespace wrinkle::test

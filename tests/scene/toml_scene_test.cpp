// Scene files in TOML.
#include <gmock/gmock.h>

#include "golden/vertex/scene.h"
#include "sim/config_file.h"
#include "sim/scene/scene_reader.h"
#include "support.h"

namespace wrinkle::test {
namespace {

const std::string kObject = "[[objects]]\nmesh = \"patch\"\n";

struct BadScene {
  const char* name;
  std::string text;
  std::vector<std::string> message;
};

class BadScenes : public ::testing::TestWithParam<BadScene> {};

TEST_P(BadScenes, SayWhereAndWhy) {
  const Folder folder;
  const fs::path path = folder.write("bad.toml", GetParam().text);
  std::vector<std::string> parts = GetParam().message;
  parts.push_back("bad.toml:");
  expect_error([&] { read_scene(path); }, parts);
}

std::string camera(const std::string& lines) { return kObject + "[camera]\n" + lines; }

INSTANTIATE_TEST_SUITE_P(
    Extremes48Numbers, BadScenes,
    ::testing::Values(
        BadScene{"NaN", kObject + "translate = [0, nan, 0]\n", {":3:17", "NaN", "finite"}},
        BadScene{"MinusInfinity", kObject + "scale = -inf\n", {":3:9", "infinity", "finite"}},
        BadScene{"Infinity", "background = [0.0, 0.0, +inf]\n" + kObject, {":1:25", "infinity"}},
        BadScene{"Denormal", kObject + "translate = [1e-40, 0.0, 0.0]\n", {":3:14", "denormal"}},
        BadScene{"DenormalInDouble", kObject + "translate = [5e-324, 0.0, 0.0]\n", {":3:14", "denormal"}},
        BadScene{"1e38", kObject + "translate = [1e38, 0.0, 0.0]\n", {":3:14", "1e+38", "between"}},
        BadScene{"OutOfRange", "background = [0.0, 1.5, 0.0]\n" + kObject, {":1:20", "1.5", "between 0 and 1"}}),
    CaseName());

INSTANTIATE_TEST_SUITE_P(
    Keys, BadScenes,
    ::testing::Values(
        BadScene{"UnknownKey", "nmae = \"x\"\n" + kObject, {":1:1", "unknown key \"nmae\"", "did you mean \"name\"?"}},
        BadScene{"UnknownObjectKey", kObject + "tesselation = 8\n", {":3:1", "did you mean \"tessellation\"?"}},
        BadScene{
            "UnknownMaterialKey", kObject + "material = { difuse = 0.5 }\n", {":3:14", "did you mean \"diffuse\"?"}},
        BadScene{"UnknownCameraKey", camera("tpye = \"perspective\"\n"), {":4:1", "did you mean \"type\"?"}},
        BadScene{"UnknownLightKey", kObject + "[light]\nplace = [1, 2, 3]\n", {":4:1", "unknown key \"place\""}},
        BadScene{"NoObjects", "name = \"x\"\n", {"objects"}},
        BadScene{"ObjectsEmpty", "objects = []\n", {":1:", "0 elements"}},
        BadScene{"ObjectsNoTables", "objects = [1]\n", {":1:", "a table"}},
        BadScene{"NoMesh", "[[objects]]\nname = \"x\"\n", {":1:1", "without \"mesh\""}},
        BadScene{"MeshUnknown", "[[objects]]\nmesh = \"teapto\"\n", {":2:8", "did you mean \"teapot\"?"}},
        BadScene{"WrongType", "size = \"512x512\"\n" + kObject, {":1:8", "512x512", "array of 2 integers"}},
        BadScene{"SizeZero", "size = [0, 512]\n" + kObject, {":1:9", "integer 0", "1 to 4096"}},
        BadScene{"SizeHuge", "size = [4294967295, 512]\n" + kObject, {":1:9", "4294967295", "1 to 4096"}},
        BadScene{"SizeFloat", "size = [512.0, 512]\n" + kObject, {":1:9", "integer"}},
        BadScene{"SizeOfThree", "size = [1, 2, 3]\n" + kObject, {":1:8", "3 elements"}},
        BadScene{"VectorOfTwo", kObject + "translate = [1, 2]\n", {":3:13", "2 elements", "array of 3 numbers"}},
        BadScene{"VectorOfStrings", kObject + "translate = [1, \"2\", 3]\n", {":3:17", "string \"2\"", "a number"}},
        BadScene{"TessellationZero", kObject + "tessellation = 0\n", {":3:16", "1 to 1024"}},
        BadScene{"TessellationHuge", kObject + "tessellation = 4294967295\n", {":3:16", "1 to 1024"}},
        BadScene{"ExponentNoPower", kObject + "material = { exponent = 17 }\n", {":3:25", "0 or a power of two"}},
        BadScene{"ShadowAsNumber", kObject + "shadow = 1\n", {":3:10", "true or false"}},
        BadScene{"ScaleZero", kObject + "scale = [1.0, 0.0, 1.0]\n", {":3:9", "a scale of almost 0"}},
        BadScene{"WrapUnknown", kObject + "wrap = [\"repeat\", \"claml\"]\n", {":3:19", "claml"}},
        BadScene{"SizeOfPatch", kObject + "size = [1, 1]\n", {":3:8", "it only for floor and wall"}},
        BadScene{"TubeAsWideAsRing", "[[objects]]\nmesh = \"torus\"\nradii = [1, 1]\n", {":3:9", "tube < ring"}},
        BadScene{"ConfigUnknown", "config = \"standart\"\n" + kObject, {":1:10", "did you mean \"standard\"?"}},
        BadScene{"NotToml", "name = \n" + kObject, {":1:"}},
        BadScene{"KeyTwice", "name = \"a\"\nname = \"b\"\n", {":2:"}},
        BadScene{"TooManyTriangles",
                 "[[objects]]\nmesh = \"teapot\"\ntessellation = 1024\n",
                 {":3:16", "58720256 triangles"}}),
    CaseName());

INSTANTIATE_TEST_SUITE_P(
    CameraAndLight, BadScenes,
    ::testing::Values(
        BadScene{"NoType", camera("eye = [0, 0, 1]\n"), {":3:1", "without \"type\""}},
        BadScene{"NoEye", camera("type = \"perspective\"\n"), {":3:1", "without \"eye\""}},
        BadScene{"EyeIsTarget", camera("type = \"perspective\"\neye = [0, 0, 0]\n"), {":5:7", "eye = target"}},
        BadScene{
            "UpAlongSight", camera("type = \"perspective\"\neye = [0, 2, 0]\n"), {":3:1", "along the line of sight"}},
        BadScene{
            "FovTooWide", camera("type = \"perspective\"\neye = [0, 0, 1]\nfov = 180\n"), {":6:7", "0.01 and 179"}},
        BadScene{"FovOfOrthographic",
                 camera("type = \"orthographic\"\neye = [0, 0, 1]\nfov = 30\n"),
                 {":6:7", "\"height\""}},
        BadScene{"FarBeforeNear",
                 camera("type = \"perspective\"\neye = [0, 0, 1]\nnear = 2\nfar = 1\n"),
                 {":7:7", "far > near"}},
        BadScene{"NearBehind", camera("type = \"perspective\"\neye = [0, 0, 1]\nnear = -1\n"), {":6:8", "between"}},
        BadScene{"LightBoth", kObject + "[light]\nposition = [0, 0, 1]\ndirection = [0, 0, 1]\n", {":3:1", "one of"}},
        BadScene{"LightNeither", kObject + "[light]\n", {":3:1", "a light without place"}},
        BadScene{"LightNowhere", kObject + "[light]\ndirection = [0, 0, 0]\n", {":4:13", "direction = 0"}},
        BadScene{"ViewerUnknown", "viewer = \"infinit\"\n" + kObject, {":1:10", "did you mean \"infinite\"?"}}),
    CaseName());

INSTANTIATE_TEST_SUITE_P(
    Maps, BadScenes,
    ::testing::Values(
        BadScene{"NormalMapMissing", kObject + "normal_map = \"no.png\"\n", {":3:14", "no.png", "exists"}},
        BadScene{"NormalMapIsFolder", kObject + "normal_map = \".\"\n", {":3:14", "the folder"}},
        BadScene{"NormalMapIsNoImage", kObject + "normal_map = \"bad.toml\"\n", {"bad.toml", "no image"}},
        BadScene{"NormalMapEmptyName", kObject + "normal_map = \"\"\n", {":3:14", "an empty file name"}},
        BadScene{"MapAndHeight", kObject + "height = \"pinwheel\"\nnormal_map = \"a.png\"\n", {":3:10", "one of them"}},
        BadScene{"MethodUnknown",
                 kObject + "height = \"pinwheel\"\nmethod = \"eq3\"\n",
                 {":4:10", "did you mean \"eq3-6\"?"}},
        BadScene{"MethodWithoutHeight", kObject + "method = \"eq3-6\"\n", {":3:10", "goes with height"}},
        BadScene{"KWithSurface", kObject + "height = \"pinwheel\"\nk = 1.0\n", {":4:5", "eq8-11"}},
        BadScene{"KZero", kObject + "height = \"pinwheel\"\nmethod = \"eq8-11\"\nk = 0.0\n", {":5:5", "between"}},
        BadScene{"RepeatWithSurface", kObject + "height = \"pinwheel\"\nrepeat = [2, 2]\n", {":4:10", "[1, 1]"}},
        BadScene{"TangentWithoutNormals", kObject + "space = \"tangent\"\n", {":3:9", "normal_map or height"}},
        BadScene{"ObjectWithoutNormals", kObject + "space = \"object\"\n", {":3:9", "eq3-6"}},
        BadScene{"ObjectWithSquareMap",
                 kObject + "height = \"pinwheel\"\nmethod = \"eq8-11\"\nspace = \"object\"\n",
                 {":5:9", "eq3-6"}},
        BadScene{"ObjectScaledUnevenly",
                 kObject + "height = \"pinwheel\"\nspace = \"object\"\nscale = [1, 2, 1]\n",
                 {":4:9", "one scale for all directions"}},
        BadScene{"FileMissing", "[[objects]]\nmesh = \"no.gltf\"\n", {":2:8", "no.gltf", "exists"}}),
    CaseName());

TEST(TomlScene, EveryNamedSceneIsReadAndDrawn) {
  for (const std::string& name : named_scenes()) {
    const Scene scene = read_scene(name);
    EXPECT_EQ(scene.name, name);
    const Frame frame = build_frame(load_config(scene.config), scene);
    std::size_t triangles = 0;
    for (const Draw& draw : frame.draws) triangles += draw.triangles.size();
    EXPECT_GE(triangles, 128U) << name;
  }
  expect_error([] { read_scene("teapto"); }, {"teapto", "did you mean \"teapot\"?"});
}

TEST(TomlScene, Fig1HasNoTextureFig6AndFig7HaveDifferentOnes) {
  const Scene fig1 = read_scene("patch_fig1"), fig6 = read_scene("patch_fig6"), fig7 = read_scene("patch_fig7");
  EXPECT_EQ(fig1.objects[0].space, ShadingSpace::kWorld);
  EXPECT_EQ(fig1.objects[0].texture, nullptr);
  EXPECT_EQ(fig6.objects[0].space, ShadingSpace::kTangent);
  ASSERT_NE(fig6.objects[0].texture, nullptr);
  ASSERT_NE(fig7.objects[0].texture, nullptr);
  EXPECT_EQ(fig6.objects[0].texture->log2_width, 9);
  EXPECT_NE(fig6.objects[0].texture->levels[0], fig7.objects[0].texture->levels[0]);
  EXPECT_NE(fig6.objects[0].height, nullptr);
  EXPECT_EQ(fig1.objects[0].mesh.triangles.size(), 128U);
}

TEST(TomlScene, ValuesArriveWhereTheyBelong) {
  const Folder folder;
  const fs::path path =
      folder.write("scene.toml",
                   "name = \"x\"\nsize = [320, 200]\nviewer = \"local\"\nbackground = [0.1, 0.2, 0.3]\n"
                   "[camera]\ntype = \"orthographic\"\neye = [0, 0, 5]\nheight = 4\nnear = 1\nfar = 9\n"
                   "[light]\nposition = [1, -0.0, 3]\n"
                   "[[objects]]\nmesh = \"sphere\"\nradius = 2\ntessellation = [6, 4]\n"
                   "translate = [1, 0, 0]\nrotate = [0, 0, 90]\nscale = [2, 1, 1]\nwrap = [\"clamp\", \"mirror\"]\n"
                   "double_sided = true\nshadow = false\n"
                   "material = { ambient = 0.1, diffuse = [0.2, 0.3, 0.4], exponent = 0 }\n");
  const Scene scene = read_scene(path);
  EXPECT_EQ(scene.name, "x");
  EXPECT_EQ(scene.width, 320);
  EXPECT_EQ(scene.height, 200);
  EXPECT_FALSE(scene.viewer_at_infinity);
  EXPECT_FALSE(scene.camera.perspective);
  EXPECT_EQ(scene.camera.half_height, 2);
  EXPECT_EQ(scene.light.position, (Vec3{1, 0, 3}));
  EXPECT_FALSE(std::signbit(scene.light.position.y));
  const Object& object = scene.objects.at(0);
  EXPECT_EQ(object.mesh.triangles.size(), 2U * 6 * 4 - 2 * 6);  // none at the poles
  // Scaled by 2 along x, turned to y, moved by 1 along x.
  EXPECT_NEAR(object.to_world(1, 0), 2, 1e-12);
  EXPECT_NEAR(object.to_world(0, 1), -1, 1e-12);
  EXPECT_EQ(object.to_world(0, 3), 1);
  EXPECT_EQ(object.wrap_u, Wrap::kClamp);
  EXPECT_EQ(object.wrap_v, Wrap::kMirror);
  EXPECT_TRUE(object.double_sided);
  EXPECT_FALSE(object.shadow);
  EXPECT_EQ(object.material.ambient, (Vec3{0.1, 0.1, 0.1}));
  EXPECT_EQ(object.material.diffuse, (Vec3{0.2, 0.3, 0.4}));
  EXPECT_EQ(object.material.exponent, 0);
}

TEST(TomlScene, SurfaceNormalsOfManySurfacesAreOneObjectEach) {
  const Folder folder;
  const fs::path path =
      folder.write("scene.toml", "[[objects]]\nmesh = \"cube\"\nheight = \"pinwheel\"\nmethod = \"eq3-6\"\n");
  const Scene scene = read_scene(path);
  EXPECT_EQ(scene.objects.size(), 6U);
  for (const Object& object : scene.objects) EXPECT_NE(object.texture, nullptr);
}

TEST(Extremes49, SceneTruncatedAtEveryByteIsReadOrRefused) {
  const Folder folder;
  const std::string whole = read_bytes(fs::path(WRINKLE_SOURCE_DIR) / "sim/scenes/patch_fig1.toml");
  int refused = 0;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    try {
      read_scene(folder.write("cut.toml", whole.substr(0, size)));
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr("cut.toml"));
      ++refused;
    }
  }
  EXPECT_GT(refused, static_cast<int>(whole.size() * 8 / 10));
}

TEST(Extremes64, TwoMillionTriangles) {
  const Folder folder;
  const Scene scene = read_scene(folder.write("many.toml", kObject + "tessellation = 1024\n"));
  EXPECT_EQ(scene.objects[0].mesh.triangles.size(), 2U * 1024 * 1024);
}

TEST(Extremes64, NamesWithSpacesUnicodeBackslashesAndSymlinksOutOfTheFolder) {
  const Folder folder, elsewhere;
  const std::string map = read_bytes(fs::path(WRINKLE_SOURCE_DIR) / "sim/scenes/maps/tiles.webp");
  folder.write("the maps/höhe Ω.webp", map);
  fs::create_symlink(elsewhere.write("map.webp", map), folder.path() / "link.webp");
  for (const char* name : {"the maps/höhe Ω.webp", "the maps\\\\höhe Ω.webp", "link.webp"}) {
    const fs::path path = folder.write("a scene Ж.toml", kObject + "normal_map = \"" + name + "\"\n");
    EXPECT_NE(read_scene(path).objects[0].texture, nullptr) << name;
  }
}

TEST(BadFiles, MissingFolderWrongExtensionAndDevices) {
  const Folder folder;
  expect_error([&] { read_scene(folder.path() / "no.toml"); }, {"no.toml", "a file that exists"});
  expect_error([&] { read_scene(folder.path()); }, {"the folder"});
  expect_error([&] { read_scene(folder.write("scene.xml", "x")); },
               {"scene.xml", "\".xml\"", ".toml, .gltf, .glb or .obj"});
  expect_error([&] { read_scene(folder.write("empty.toml", "")); }, {"empty.toml", "empty"});
  fs::create_symlink("/dev/zero", folder.path() / "zero.toml");
  expect_error([&] { read_scene(folder.path() / "zero.toml"); }, {"zero.toml", "a regular file"});
}

}  // namespace
}  // namespace wrinkle::test

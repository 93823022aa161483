// Wavefront OBJ and MTL.
#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>

#include "golden/vertex/scene.h"
#include "sim/scene/model.h"
#include "sim/scene/scene_reader.h"
#include "support.h"

namespace wrinkle::test {
namespace {

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n";
const std::string kFace = "f 1/1/1 2/2/1 3/3/1 4/4/1\n";

struct BadObj {
  const char* name;
  std::string text;
  std::vector<std::string> message;
};

class BadObjs : public ::testing::TestWithParam<BadObj> {};

TEST_P(BadObjs, SayWhereAndWhy) {
  const Folder folder;
  const fs::path path = folder.write("bad.obj", GetParam().text);
  std::vector<std::string> parts = GetParam().message;
  parts.push_back("bad.obj");
  expect_error([&] { read_scene(path); }, parts);
}

INSTANTIATE_TEST_SUITE_P(Extremes48, BadObjs,
                         ::testing::Values(BadObj{"NaN", "v 0 nan 0\n" + kFace, {":1:5", "NaN"}},
                                           BadObj{"Infinity", "v 0 0 -inf\n" + kFace, {":1:7", "infinity"}},
                                           BadObj{
                                               "Indefinite", "v 1.#IND 0 0\n" + kFace, {":1:3", "1.#IND", "a number"}},
                                           BadObj{"Denormal", "v 1e-40 0 0\n" + kFace, {":1:3", "denormal"}},
                                           BadObj{"1e38", "v 0 0 1e38\n" + kFace, {":1:7", "1e+38"}},
                                           BadObj{"1e999", "v 0 0 1e999\n" + kFace, {":1:7", "1e999"}},
                                           BadObj{"Word", "v 0 zero 0\n" + kFace, {":1:5", "\"zero\"", "a number"}},
                                           BadObj{"TwoNumbers", "v 0 0\n" + kFace, {":1:1", "2 numbers", "3 to 7"}},
                                           BadObj{"NormalOfTwo", kSquare + "vn 0 1\n", {":10:1", "2 numbers"}}),
                         CaseName());

INSTANTIATE_TEST_SUITE_P(
    Extremes50, BadObjs,
    ::testing::Values(BadObj{"PositionTooLarge", kSquare + "f 1 2 5\n", {":10:7", "index 5", "at most 4"}},
                      BadObj{"UvTooLarge", kSquare + "f 1/1 2/9 3/3\n", {":10:7", "index 9", "texture coordinates"}},
                      BadObj{"NormalTooLarge", kSquare + "f 1//1 2//1 3//2\n", {":10:13", "index 2", "normals"}},
                      BadObj{"Zero", kSquare + "f 0 1 2\n", {":10:3", "counted from 1"}},
                      BadObj{"NegativeTooFar", kSquare + "f -5 1 2\n", {":10:3", "index -5", "at least -4"}},
                      BadObj{"Huge", kSquare + "f 1 2 4294967295\n", {":10:7", "4294967295"}},
                      BadObj{"Overflow", kSquare + "f 1 2 99999999999999999999\n", {":10:7", "counted from 1"}},
                      BadObj{"NoNumber", kSquare + "f a b c\n", {":10:3", "\"a\""}},
                      BadObj{"Slashes", kSquare + "f 1/1/1/1 2 3\n", {":10:3", "v/vt/vn"}},
                      BadObj{"TwoCorners", kSquare + "f 1 2\n", {":10:1", "2 corners", "at least 3"}},
                      BadObj{"NoFaces", kSquare, {"no faces"}}, BadObj{"Empty", "", {"empty"}},
                      BadObj{"Binary", std::string("v 0 0 0\n\0\0", 10), {":2", "zero byte"}}),
    CaseName());

TEST(ObjScene, BadMaterials) {
  const Folder folder;
  const fs::path path = folder.write("a.obj", "mtllib a.mtl\nusemtl m\n" + kSquare + kFace);
  const auto says = [&](const std::string& mtl, std::vector<std::string> parts) {
    folder.write("a.mtl", "newmtl m\n" + mtl);
    expect_error([&] { read_scene(path); }, parts);
  };
  says("Kd 1 nan 0\n", {"a.mtl:2:6", "NaN"});
  says("Kd 1 -1 0\n", {"a.mtl:2:6", "Kd = -1", "between"});
  says("Kd 1 1\n", {"a.mtl:2:1", "2 words", "3 numbers"});
  says("Ns -5\n", {"a.mtl:2:4", "Ns = -5"});
  says("map_bump -bm x a.png\n", {"a.mtl:2:14", "\"x\"", "a number"});
  says("map_Kd nothing.png\n", {"a.obj", "material \"m\"", "nothing.png", "exists"});
  folder.write("text.png", "no image");
  says("norm text.png\n", {"text.png", "no image"});
}

TEST(ObjScene, Extremes49TruncatedAtEveryByteIsReadOrRefused) {
  const Folder folder;
  const std::string whole = kSquare + kFace;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    try {
      const Scene scene = read_scene(folder.write("cut.obj", whole.substr(0, size)));
      EXPECT_GE(scene.objects.size(), 1U);
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr("cut.obj"));
    }
  }
}

TEST(ObjScene, SquareHasItsFrameWithVFlipped) {
  const Folder folder;
  const Scene scene = read_scene(folder.write("a.obj", kSquare + kFace));
  const Object& object = scene.objects.at(0);
  EXPECT_EQ(object.mesh.triangles.size(), 2U);
  ASSERT_EQ(object.mesh.vertices.size(), 4U);
  for (const Vertex& v : object.mesh.vertices) {
    EXPECT_EQ(v.N, (Vec3{0, 0, 1}));
    EXPECT_EQ(v.uv.x, v.P.x);
    EXPECT_EQ(v.uv.y, 1 - v.P.y);
  }
}

// An image of `blue`-ish normals, or of grey heights.
void write_map(const fs::path& path, bool normals) {
  std::vector<float> pixels;
  for (int i = 0; i < 64; ++i) {
    const float grey = static_cast<float>(i % 8) / 8;
    pixels.insert(pixels.end(), {normals ? 0.4F : grey, normals ? 0.5F : grey, normals ? 0.99F : grey});
  }
  const auto output = OIIO::ImageOutput::create("a.png");  // the plug-in, whatever the name
  ASSERT_TRUE(output->open(path.string(), OIIO::ImageSpec(8, 8, 3, OIIO::TypeDesc::UINT8)));
  ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()));
  ASSERT_TRUE(output->close());
}

TEST(ObjScene, BumpIsHeightUnlessItHoldsNormals) {
  const Folder folder;
  write_map(folder.path() / "height map.png", false);
  write_map(folder.path() / "normal map.png", true);
  const fs::path path = folder.write("a.obj", "mtllib a b.mtl\nusemtl m\n" + kSquare + kFace);
  const auto normal = [&](const std::string& line) {
    folder.write("a b.mtl", "newmtl m\n" + line + "\n");
    const auto texture = read_scene(path).objects.at(0).texture;
    return texture ? texture->levels[0][3 * 8 + 3].bump : std::array<float, kMaxBumpComponents>{};
  };
  const auto as_normal = normal("norm normal map.png");
  EXPECT_NEAR(as_normal[0], 2 * 102.0 / 255 - 1, 1e-6);
  EXPECT_EQ(normal("bump normal map.png"), as_normal);
  const auto once = normal("map_bump -bm 1 height map.png"), twice = normal("bump -bm 2 height map.png");
  EXPECT_LT(once[0], 0);  // heights rise to the right, normals lean left
  EXPECT_NEAR(once[1], 0, 1e-6);
  EXPECT_NEAR(twice[0] / twice[2], 2 * once[0] / once[2], 1e-5);
}

TEST(ObjScene, MissingLibraryIsNoted) {
  const Folder folder;
  Notes notes;
  read_scene(folder.write("a.obj", "mtllib no.mtl\n" + kSquare + kFace), &notes);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_THAT(notes[0], ::testing::HasSubstr("no.mtl"));
}

// Copies the parser's own cases, and makes the images that they name and do not bring.
TEST(ObjScene, EveryCaseOfTinyobjloaderIsReadOrRefusedForItsNumbers) {
  const fs::path cases = shared("obj/tinyobjloader_cases");
  if (!fs::exists(cases)) GTEST_SKIP() << "no ../shared/assets/obj/tinyobjloader_cases";
  const Folder folder;
  fs::copy(cases, folder.path(), fs::copy_options::recursive);
  for (const char* name : {"bumpmap.jpg", "bumpmap2.jpg", "diffuse.jpg", "input.jpg", "tmp.png", "bump.jpg",
                           "normalmap.jpg", "normalmap.tex", "texture 01.png", "bump 01.png"}) {
    write_map(folder.path() / name, false);
  }
  int read = 0;
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    if (entry.path().extension() != ".obj") continue;
    SCOPED_TRACE(entry.path().filename());
    if (entry.path().filename() == "test-nan.obj") {
      expect_error([&] { read_scene(entry.path()); }, {"test-nan.obj:12:3", "NaN"});
      continue;
    }
    EXPECT_NO_THROW(read_scene(entry.path()));
    ++read;
  }
  EXPECT_EQ(read, 14);
}

TEST(ObjScene, FileNamesOfTinyobjloaderCasesMayHoldWhiteSpace) {
  const fs::path cases = shared("obj/tinyobjloader_cases");
  if (!fs::exists(cases)) GTEST_SKIP() << "no ../shared/assets/obj/tinyobjloader_cases";
  const Folder folder;
  fs::copy(cases, folder.path(), fs::copy_options::recursive);
  const fs::path path = folder.path() / "texture-filename-with-whitespace.obj";
  expect_error([&] { read_scene(path); }, {"/texture 01.png\""});
  write_map(folder.path() / "texture 01.png", false);
  expect_error([&] { read_scene(path); }, {"/bump 01.png\""});
}

}  // namespace
}  // namespace wrinkle::test

// Wavefront OBJ and MTL.
#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "golden/vertex/scene.h"
#include "sim/config_file.h"
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
  says("bump a.png -bm\n", {"a.mtl:2:12", "-bm at the end"});
  says("Ns -5\n", {"a.mtl:2:4", "Ns = -5"});
  says("map_bump -bm x a.png\n", {"a.mtl:2:14", "\"x\"", "a number"});
  says("map_Kd nothing.png\n", {"a.mtl:2:8", "nothing.png", "exists"});
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

bool holds(const Notes& notes, const std::string& text) {
  return std::ranges::any_of(notes, [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

TEST(ObjScene, WhatIsMissingIsNoted) {
  const Folder folder;
  folder.write("a.mtl", "newmtl red\nKd 1 0 0\n");
  Notes notes;
  read_scene(
      folder.write("a.obj", "mtllib no.mtl\nmtllib a.mtl\nusemtl rad\n" + kSquare + kFace + "usemtl rad\n" + kFace),
      &notes);
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_TRUE(holds(notes, "a.obj:1:1: no material library \"no.mtl\"")) << notes[0];
  EXPECT_TRUE(holds(notes, "a.obj:3:8: no material \"rad\"")) << notes[1];
}

// The same square with a bump map and a colour, written in the ways that programs write it.
TEST(ObjScene, TextIsReadAsPeopleHaveIt) {
  const Folder folder;
  write_map(folder.path() / "h m.png", false);
  const std::string plain_mtl = "newmtl my red\nKd 1 0 0\nKs .5 .5 .5\nNs 64\nbump -bm 2 h m.png\n";
  const std::string plain = "mtllib a b.mtl\nusemtl my red\ns 1\n" + kSquare + kFace;
  const auto read = [&](const std::string& obj, const std::string& mtl, Notes* notes = nullptr) {
    folder.write("a b.mtl", mtl);
    return read_scene(folder.write("a.obj", obj), notes);
  };
  const Scene expected = read(plain, plain_mtl);
  ASSERT_EQ(expected.objects.at(0).material.diffuse, (Vec3{1, 0, 0}));
  ASSERT_TRUE(expected.objects.at(0).texture);
  const auto replaced = [](std::string text, const std::string& what, const std::string& with) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size()) {
      text.replace(at, what.size(), with);
    }
    return text;
  };
  const auto same = [&](const char* how, const std::string& obj, const std::string& mtl) {
    SCOPED_TRACE(how);
    Notes notes;
    const Scene scene = read(obj, mtl, &notes);
    EXPECT_TRUE(notes.empty()) << notes.at(0);
    ASSERT_EQ(scene.objects.size(), 1U);
    const Object &a = expected.objects[0], &b = scene.objects[0];
    EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
    ASSERT_EQ(a.mesh.vertices.size(), b.mesh.vertices.size());
    for (std::size_t i = 0; i < a.mesh.vertices.size(); ++i) {
      EXPECT_EQ(a.mesh.vertices[i].P, b.mesh.vertices[i].P);
      EXPECT_EQ(a.mesh.vertices[i].N, b.mesh.vertices[i].N);
      EXPECT_EQ(a.mesh.vertices[i].uv, b.mesh.vertices[i].uv);
    }
    EXPECT_EQ(a.material.diffuse, b.material.diffuse);
    EXPECT_EQ(a.material.specular, b.material.specular);
    EXPECT_EQ(a.material.exponent, b.material.exponent);
    ASSERT_TRUE(b.texture);
    EXPECT_EQ(a.texture->levels, b.texture->levels);
  };
  const std::string mark = "\xef\xbb\xbf";
  same("byte order marks", mark + plain, mark + plain_mtl);
  same("CR LF", replaced(plain, "\n", "\r\n"), replaced(plain_mtl, "\n", "\r\n"));
  same("CR", replaced(plain, "\n", "\r"), replaced(plain_mtl, "\n", "\r"));
  same("tabs", replaced(replaced(plain, "v ", "v\t"), "f ", "\tf \t"), replaced(plain_mtl, "Kd ", "\tKd\t"));
  same("blanks at ends", replaced(plain, "\n", " \t\n"), replaced(plain_mtl, "\n", "  \n"));
  same("comments at ends", replaced(plain, "\n", " # said\n"), replaced(plain_mtl, "\n", "\t#said \\\n"));
  same("continued lines", replaced(plain, " 2/2/1 ", " \\\n 2/2/1 \\\r\n"),
       replaced(plain_mtl, "Kd 1 ", "Kd \\\n1 \\ \n"));
  same("upper case", replaced(replaced(replaced(plain, "vt", "VT"), "usemtl", "UseMtl"), "f ", "F "),
       replaced(replaced(replaced(plain_mtl, "Kd", "KD"), "bump", "map_Bump"), "newmtl", "NEWMTL"));
  same("options behind the name", plain, replaced(plain_mtl, "-bm 2 h m.png", "h m.png -bm 2"));
  same("options on both sides", plain, replaced(plain_mtl, "-bm 2", "-blendu on -imfchan l -mm 0 2 -bm 1"));
  same("quotes", replaced(plain, "a b.mtl", "\"a b.mtl\""), replaced(plain_mtl, "h m.png", "\"h m.png\""));
  same("no effect", plain, plain_mtl + "illum 2\nd 1.0\nTr 0\nKe 0 0 0\nNi 1.45\nTf 1 1 1\n");
  same("one number", plain, replaced(plain_mtl, "Ks .5 .5 .5", "Ks .5"));
  same("last line without an end", plain.substr(0, plain.size() - 1), plain_mtl.substr(0, plain_mtl.size() - 1));
  expect_error([&] { read("\xff\xfe" + plain, plain_mtl); }, {"a.obj:1", "UTF-16", "UTF-8"});
}

TEST(ObjScene, LibrariesMayStandOnOneLine) {
  const Folder folder;
  folder.write("a.mtl", "newmtl red\nKd 1 0 0\n");
  folder.write("b.mtl", "newmtl green\nKd 0 1 0\n");
  Notes notes;
  const Scene scene = read_scene(
      folder.write("x.obj", "mtllib a.mtl b.mtl\n" + kSquare + "usemtl red\n" + kFace + "usemtl green\n" + kFace),
      &notes);
  ASSERT_EQ(scene.objects.size(), 2U);
  EXPECT_EQ(scene.objects[0].material.diffuse, (Vec3{1, 0, 0}));
  EXPECT_EQ(scene.objects[1].material.diffuse, (Vec3{0, 1, 0}));
  EXPECT_TRUE(notes.empty());
}

// Each is noted once, with its name and place; the picture is the one without it.
TEST(ObjScene, WhatIsNotAppliedIsNoted) {
  struct Line {
    const char* mtl;
    const char* note;
  };
  const Folder folder;
  for (const Line& line :
       {Line{"d 0.5", "a.mtl:3:1: the keyword \"d\""}, Line{"Tr 0.2", "\"Tr\""}, Line{"illum 1", "illum 1"},
        Line{"illum 7", "illum 7"}, Line{"disp h.png", "\"disp\""}, Line{"map_Ns s.png", "\"map_Ns\""},
        Line{"map_d a.png", "\"map_d\""}, Line{"refl -type sphere r.png", "\"refl\""}, Line{"Ke 1 1 1", "\"Ke\""},
        Line{"Pr 0.3", "\"Pr\""}, Line{"Kd spectral a.rfl 1", "spectral"}, Line{"Ks 2 2 2", "Ks over 1"},
        Line{"Shine 3", "\"Shine\""}}) {
    SCOPED_TRACE(line.mtl);
    folder.write("a.mtl", std::string("newmtl m\nKd .5 .5 .5\n") + line.mtl + "\n" + line.mtl + "\n");
    Notes notes;
    read_scene(folder.write("a.obj", "mtllib a.mtl\nusemtl m\n" + kSquare + kFace), &notes);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_TRUE(holds(notes, line.note)) << notes[0];
  }
  Notes notes;
  read_scene(folder.write("b.obj", kSquare + kFace + "l 1 2\np 1\ncurv 0 1 1 2\nvp 1 2\n"), &notes);
  EXPECT_TRUE(holds(notes, "b.obj:11:1: points and lines are not drawn (2 times)"));
  EXPECT_TRUE(holds(notes, "b.obj:13:1: the keyword \"curv\""));
  EXPECT_TRUE(holds(notes, "b.obj:14:1: the keyword \"vp\""));
}

TEST(ObjScene, KeywordsWithoutValuesAreOneNote) {
  const Folder folder;
  folder.write("a.mtl", "newmtl m\nKa\nKd .5 .25 .5\nKs\nNs\nmap_Kd\nbump  # none\n");
  Notes notes;
  const Scene scene = read_scene(folder.write("a.obj", "mtllib a.mtl\nusemtl m\n" + kSquare + kFace), &notes);
  EXPECT_EQ(scene.objects.at(0).material.diffuse, (Vec3{.5, .25, .5}));
  EXPECT_FALSE(scene.objects[0].texture);
  ASSERT_EQ(notes.size(), 1U);
  for (const char* part :
       {"a.mtl", "line 2 \"Ka\"", "line 4 \"Ks\"", "line 5 \"Ns\"", "line 6 \"map_Kd\"", "line 7 \"bump\""}) {
    EXPECT_TRUE(holds(notes, part)) << notes[0];
  }
}

TEST(ObjScene, MapsAreScaledMovedClampedOrNoted) {
  const Folder folder;
  write_map(folder.path() / "h.png", false);
  const auto read = [&](const std::string& line, Notes* notes = nullptr) {
    folder.write("a.mtl", "newmtl m\n" + line + "\n");
    return read_scene(folder.write("a.obj", "mtllib a.mtl\nusemtl m\n" + kSquare + kFace), notes);
  };
  Notes notes;
  const Scene moved = read("bump h.png -s 2 3 1 -o .5 .25", &notes);
  for (const Vertex& v : moved.objects.at(0).mesh.vertices) {
    EXPECT_EQ(v.uv.x, 2 * v.P.x + .5);
    EXPECT_EQ(1 - v.uv.y, 3 * v.P.y + .25);
  }
  EXPECT_EQ(read("map_Kd -clamp on h.png").objects[0].wrap_u, Wrap::kClamp);
  EXPECT_TRUE(notes.empty());
  for (const char* option : {"-t 1 1 1", "-boost 2", "-blendu off", "-texres 64", "-cc on"}) {
    SCOPED_TRACE(option);
    notes.clear();
    read(std::string("map_Kd ") + option + " h.png", &notes);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_TRUE(holds(notes, std::string(option).substr(0, 3)));
  }
  const auto flat = read("bump -bm 0 h.png").objects[0].texture->levels[0];
  for (const auto& texel : flat) EXPECT_EQ(texel.bump[2], 1);
}

// -clamp reaches the slopes of the heights: a ramp has no cliff at its border.
TEST(ObjScene, ClampedHeightsHaveNoCliffAtTheBorder) {
  const Folder folder;
  write_map(folder.path() / "h.png", false);
  folder.write("a.mtl", "newmtl m\nbump -clamp on h.png\n");
  const Scene clamped = read_scene(folder.write("a.obj", "mtllib a.mtl\nusemtl m\n" + kSquare + kFace));
  folder.write("a.mtl", "newmtl m\nbump h.png\n");
  const Scene repeated = read_scene(folder.path() / "a.obj");
  EXPECT_LE(clamped.objects[0].texture->levels[0][0].bump[0], 0);
  EXPECT_GT(repeated.objects[0].texture->levels[0][0].bump[0], 0);
}

TEST(ObjScene, ColoursOfVerticesMultiplyTheMaterial) {
  const Folder folder;
  const auto square = [](const char* a, const char* b) {
    return std::string("v 0 0 0 ") + a + "\nv 1 0 0 " + a + "\nv 1 1 0 " + a + "\nv 0 1 0 " + b + "\nf 1 2 3 4\n";
  };
  Notes notes;
  const Scene one = read_scene(folder.write("a.obj", square("1 0 .5", "1 0 .5")), &notes);
  EXPECT_TRUE(notes.empty());
  ASSERT_EQ(one.objects.size(), 1U);
  EXPECT_EQ(one.objects[0].material.diffuse, (Vec3{.7, 0, .35}));
  const Scene codes = read_scene(folder.write("a.obj", square("255 0 0", "255 0 0")));
  EXPECT_EQ(codes.objects.at(0).material.diffuse, (Vec3{.7, 0, 0}));
  const Scene two = read_scene(folder.write("a.obj", square("1 0 0", "0 1 0")), &notes);
  ASSERT_EQ(two.objects.size(), 1U);  // both triangles have the corner that differs
  EXPECT_NEAR(two.objects[0].material.diffuse.y, .7 / 3, 1e-12);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_TRUE(holds(notes, "vertex colours are not interpolated"));
}

// A cube: each face a group of its own is flat, one group is smooth over materials and g, but not over o.
TEST(ObjScene, SmoothingGoesByGroupAndPosition) {
  const Folder folder;
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 -1\nv 0 1 -1\n";
  const std::string front = "f 1 2 3 4\n", left = "f 5 1 4 6\n";
  const auto normal_at_edge = [&](const std::string& between) {
    const Scene scene = read_scene(folder.write("a.obj", corners + "s 1\n" + front + between + left));
    for (const Vertex& v : scene.objects.at(0).mesh.vertices) {
      if (v.P == Vec3{}) return v.N;
    }
    return Vec3{};
  };
  const Vec3 smooth = normal_at_edge(""), hard{0, 0, 1};
  EXPECT_NEAR(smooth.x, -std::sqrt(.5), 1e-12);
  EXPECT_EQ(normal_at_edge("g other\n"), smooth);
  EXPECT_EQ(normal_at_edge("usemtl other\n"), smooth);
  EXPECT_EQ(normal_at_edge("s 1\n"), smooth);
  for (const char* between : {"s 2\n", "s off\n", "s 0\n", "s\n", "o other\n"}) {
    EXPECT_EQ(normal_at_edge(between), hard) << between;
  }
}

TEST(ObjScene, NormalsOfNoLengthAreReplacedAndNoted) {
  const Folder folder;
  Notes notes;
  const Scene scene =
      read_scene(folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nvn 0 0 2\nf 1//1 2//2 3//1\n"), &notes);
  for (const Vertex& v : scene.objects.at(0).mesh.vertices) EXPECT_EQ(v.N, (Vec3{0, 0, 1}));
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_TRUE(holds(notes, "2 corners with normals of no length"));
}

// A corner that two materials share has one tangent.
TEST(ObjScene, TangentsHaveNoSeamWhereTheMaterialChanges) {
  const Folder folder;
  write_map(folder.path() / "h.png", false);
  folder.write("a.mtl", "newmtl a\nbump h.png\nnewmtl b\nbump h.png\n");
  const std::string roof =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 2 -1\nv 1 2 -1\nvt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\nvt 0.5 2\nvt 1.5 2\n"
      "vn 0 0 1\n";
  const Scene scene = read_scene(folder.write(
      "a.obj",
      "mtllib a.mtl\n" + roof + "usemtl a\nf 1/1/1 2/2/1 4/4/1 3/3/1\ng x\nusemtl b\nf 3/3/1 4/4/1 6/6/1 5/5/1\n"));
  ASSERT_EQ(scene.objects.size(), 2U);
  const auto tangent = [&](std::size_t object) {
    for (const Vertex& v : scene.objects[object].mesh.vertices) {
      if (v.P == Vec3{0, 1, 0}) return v.T;
    }
    return Vec3{};
  };
  EXPECT_EQ(tangent(0), tangent(1));
}

// The view is of what is drawn, and the same at any scale.
TEST(ObjScene, TheViewIsOfWhatIsDrawn) {
  const Folder folder;
  const Scene plain = read_scene(folder.write("a.obj", kSquare + kFace));
  const Scene stray = read_scene(folder.write("b.obj", kSquare + kFace + "v 500 500 500\nv 900 0 0\nf 5 5 6\n"));
  EXPECT_EQ(stray.camera.world_to_eye.m, plain.camera.world_to_eye.m);
  EXPECT_EQ(stray.camera.far, plain.camera.far);
  const auto drawn = [&](double scale) {
    char text[200];
    std::snprintf(text, sizeof text, "v 0 0 0\nv %g 0 0\nv %g %g 0\nv 0 %g 0\nf 1 2 3 4\n", scale, scale, scale, scale);
    const Frame frame = build_frame(load_config("perspective"), read_scene(folder.write("c.obj", text)));
    std::vector<std::pair<int, int>> corners;
    for (const ScreenTriangle& t : frame.draws.at(0).triangles) {
      for (const ScreenVertex& v : t.v) corners.emplace_back(v.x, v.y);
    }
    return corners;
  };
  ASSERT_EQ(drawn(1).size(), 6U);
  for (const double scale : {1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9}) EXPECT_EQ(drawn(scale), drawn(1)) << scale;
}

// Copies the parser's own cases, and makes the images that they name and do not bring.
TEST(ObjScene, EveryCaseOfTinyobjloaderIsReadOrRefusedForItsNumbers) {
  const fs::path cases = shared("obj/tinyobjloader_cases");
  if (!fs::exists(cases)) GTEST_SKIP() << "no ../shared/assets/obj/tinyobjloader_cases";
  const Folder folder;
  fs::copy(cases, folder.path(), fs::copy_options::recursive);
  for (const char* name : {"bumpmap.jpg", "bumpmap2.jpg", "diffuse.jpg", "input.jpg", "tmp.png", "bump.jpg",
                           "normalmap.jpg", "normalmap.tex", "texture 01.png", "bump 01.png", "specular.jpg"}) {
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

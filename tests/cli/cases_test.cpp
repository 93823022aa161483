// The folders of ../shared/cases, small inputs after the kinds of faults that like programs had: each is copied, drawn
// by the lines of its cmd.txt, and held against what its expect.txt says. Skipped where the folders are absent; tests
// of each kind with data of our own are in tests/scene.
#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

struct Result {
  int exit_code = -1;
  std::string output;  // both streams
};

struct Floats {
  int width = 0, height = 0, channels = 0;
  std::vector<float> values;
  std::vector<std::string> names;
};

Floats read_floats(const fs::path& path) {
  Floats image;
  const auto input = OIIO::ImageInput::open(path.string());
  if (!input) return image;
  image.width = input->spec().width;
  image.height = input->spec().height;
  image.channels = input->spec().nchannels;
  image.names = input->spec().channelnames;
  image.values.resize(std::size_t(image.width) * std::size_t(image.height) * std::size_t(image.channels));
  input->read_image(0, 0, 0, image.channels, OIIO::TypeDesc::FLOAT, image.values.data());
  return image;
}

class Cases : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(shared())) GTEST_SKIP() << "no ../shared/cases";
    root_ = fs::path(testing::TempDir()) / ("wrinkle_cases_" + std::to_string(getpid()));
    fs::create_directories(root_);
    fs::create_symlink(WRINKLE_PROGRAM, root_ / "wrinkle");
  }
  void TearDown() override {
    if (!root_.empty()) fs::remove_all(root_);
  }
  static fs::path shared() { return fs::path(WRINKLE_SHARED_DIR) / "cases"; }

  // Copies a case, where it may be written, and draws it. Returns what each line said, by the last word's stem.
  std::map<std::string, Result> draw(const std::string& folder, bool within = false) {
    fs::copy(shared() / folder, root_ / folder, fs::copy_options::recursive);
    for (const auto& entry : fs::recursive_directory_iterator(root_ / folder))
      fs::permissions(entry.path(), fs::perms::owner_all, fs::perm_options::add);
    fs::permissions(root_ / folder, fs::perms::owner_all, fs::perm_options::add);
    std::map<std::string, Result> results;
    std::ifstream lines(root_ / folder / "cmd.txt");
    for (std::string line; std::getline(lines, line);) {
      if (line.empty()) continue;
      const std::string name = fs::path(line.substr(line.rfind(' ') + 1)).stem();
      if (within) line.replace(0, 2, "../");
      const Result result = run(within ? root_ / folder : root_, line);
      EXPECT_TRUE(result.exit_code == 0 || result.exit_code == 2) << line << '\n' << result.output;
      EXPECT_LT(result.output.size(), 4000U);
      results[name] = result;
    }
    return results;
  }
  static Result run(const fs::path& folder, const std::string& line) {
    Result result;
    FILE* pipe = popen(("cd '" + folder.string() + "' && " + line + " 2>&1").c_str(), "r");
    std::array<char, 4096> buffer;
    while (std::size_t n = fread(buffer.data(), 1, buffer.size(), pipe)) result.output.append(buffer.data(), n);
    const int status = pclose(pipe);
    if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
    return result;
  }

  Floats picture(const std::string& folder, const std::string& name, const std::string& ending = ".png") const {
    return read_floats(root_ / folder / "out" / (name + ending));
  }
  // The greatest difference of codes; infinite where one is missing.
  double difference(const std::string& folder, const std::string& a, const std::string& b) const {
    const Floats p = picture(folder, a), q = picture(folder, b);
    if (p.values.empty() || p.values.size() != q.values.size()) return INFINITY;
    double worst = 0;
    for (std::size_t i = 0; i < p.values.size(); ++i)
      worst = std::max(worst, 255 * std::abs(double(p.values[i]) - double(q.values[i])));
    return worst;
  }
  void expect_same(const std::string& folder, const std::string& a, const std::vector<std::string>& others) const {
    for (const std::string& b : others) EXPECT_EQ(difference(folder, a, b), 0) << folder << ": " << a << ", " << b;
  }

  fs::path root_;
};

TEST_F(Cases, AccessorWithoutView) {
  draw("02-accessor-without-view");
  expect_same("02-accessor-without-view", "zeros", {"noview"});
}

TEST_F(Cases, UriCharacters) {
  draw("07-uri-characters");
  expect_same("07-uri-characters", "plain",
              {"space", "rawspace", "plus", "utf8", "percent", "rawpercent", "i_space", "i_plus", "i_hash", "i_percent",
               "i_back"});
}

TEST_F(Cases, ZeroTangents) {
  auto said = draw("13-zero-tangents");
  for (const char* name : {"zero", "w0"}) {
    EXPECT_LE(difference("13-zero-tangents", "generated", name), 3) << name;
    EXPECT_THAT(said[name].output, HasSubstr("tangents")) << name;
  }
}

TEST_F(Cases, TextureTransform) {
  draw("14-texture-transform");
  expect_same("14-texture-transform", "baked", {"transform"});
}

TEST_F(Cases, ZeroNormals) {
  auto said = draw("18-zero-normals");
  EXPECT_THAT(said["zero"].output, HasSubstr("normals of no length"));
  EXPECT_THAT(said["z"].output, HasSubstr("normals of no length"));
  EXPECT_LT(difference("18-zero-normals", "good", "zero"), 60);  // black triangles differ by more
}

TEST_F(Cases, ByteOrderMarks) {
  draw("19-bom");
  expect_same("19-bom", "plain", {"bomlib", "bommtl", "bomv"});
  expect_same("19-bom", "p", {"q"});
  expect_same("19-bom", "t", {"tb"});
}

TEST_F(Cases, LineContinuation) {
  draw("20-line-continuation");
  expect_same("20-line-continuation", "plain", {"wrapped"});
}

TEST_F(Cases, TrailingComments) {
  draw("21-trailing-comments");
  expect_same("21-trailing-comments", "plain", {"c_v", "c_f", "c_usemtl", "c_mtllib", "c_mtl"});
}

TEST_F(Cases, SmoothingGroups) {
  draw("23-smoothing-groups");
  expect_same("23-smoothing-groups", "flat", {"groups"});
  EXPECT_LE(difference("23-smoothing-groups", "mixed_vn", "mixed"), 1);
}

TEST_F(Cases, UnknownMaterial) {
  auto said = draw("25-unknown-material");
  EXPECT_THAT(said["typo"].output, HasSubstr("typo.obj"));
  EXPECT_THAT(said["typo"].output, HasSubstr("no material"));
  EXPECT_THAT(said["nolib"].output, HasSubstr("gone.mtl"));
}

TEST_F(Cases, BumpOptions) {
  draw("27-bump-options");
  expect_same("27-bump-options", "before", {"after", "upper", "more"});
  // A flat bump map lights by N' and L of tangent space, which round by themselves: at most one code apart.
  EXPECT_LT(difference("27-bump-options", "none", "zero"), 1.5);
  EXPECT_GT(difference("27-bump-options", "before", "scaled"), 0);
  EXPECT_GT(difference("27-bump-options", "before", "half"), 0);
}

TEST_F(Cases, ConcavePolygons) {
  const std::string folder = "29-concave-polygon";
  draw(folder);
  for (const std::string name : {"star", "u", "m", "hole"}) {
    std::vector<std::array<double, 2>> points;
    std::vector<std::size_t> outline;
    std::ifstream file(root_ / folder / (name + ".obj"));
    for (std::string line; std::getline(file, line);) {
      std::istringstream words(line);
      std::string word;
      words >> word;
      if (word == "v") words >> points.emplace_back()[0] >> points.back()[1];
      if (word != "f") continue;
      while (words >> word) outline.push_back(std::stoul(word) - 1);
    }
    double area = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const auto a = points[outline[i]], b = points[outline[(i + 1) % outline.size()]];
      area += (a[0] * b[1] - a[1] * b[0]) / 2;
    }
    const auto json = nlohmann::json::parse(std::ifstream(root_ / folder / "out" / (name + ".json")));
    EXPECT_NEAR(json["fragments"].get<double>(), 1e4 * std::abs(area), 200 * std::abs(area)) << name;
  }
}

TEST_F(Cases, HeightBorderClamp) {
  draw("34-height-border-clamp");
  const Floats image = picture("34-height-border-clamp", "ramp", ".exr");
  const auto channel = std::find(image.names.begin(), image.names.end(), "N.x") - image.names.begin();
  ASSERT_LT(channel, image.channels) << testing::PrintToString(image.names);
  const auto at = [&](int x) {
    return image.values[std::size_t((80 * image.width + x) * image.channels + int(channel))];
  };
  for (const int x : {1, 5, 154, 158}) EXPECT_NEAR(at(x), at(80), 0.01) << x;
}

TEST_F(Cases, TwoChannelNormals) {
  auto said = draw("36-two-channel-normals");
  EXPECT_LE(difference("36-two-channel-normals", "rgb", "two"), 3);
  EXPECT_EQ(said["grey"].exit_code, 2);
  EXPECT_THAT(said["grey"].output, HasSubstr("one channel"));
}

TEST_F(Cases, SpecularGlossiness) {
  draw("39-spec-gloss");
  const Floats image = picture("39-spec-gloss", "specgloss");
  bool coloured = false;
  for (std::size_t i = 0; i + 2 < image.values.size(); i += 3)
    coloured = coloured || std::abs(image.values[i] - image.values[i + 2]) > 0.1F;
  EXPECT_TRUE(coloured);
}

TEST_F(Cases, VertexColours) {
  auto said = draw("40-vertex-colours");
  expect_same("40-vertex-colours", "factor", {"colour"});
  const Floats image = picture("40-vertex-colours", "c");
  const std::size_t middle = std::size_t(3 * (80 * 160 + 80));
  ASSERT_GT(image.values.size(), middle);
  EXPECT_GT(image.values[middle], image.values[middle + 1] + 0.1F);
}

TEST_F(Cases, StrayVertices) {
  draw("43-stray-vertices");
  expect_same("43-stray-vertices", "lone", {"shared"});
}

TEST_F(Cases, RepeatsPerTriangle) {
  auto said = draw("48-repeats-per-triangle");
  EXPECT_EQ(said["cut"].exit_code, 0);
  EXPECT_EQ(said["tiled"].exit_code, 2);
  EXPECT_THAT(said["tiled"].output, AllOf(HasSubstr("object number 1"), HasSubstr("--set uv_integer_bits")));
}

TEST_F(Cases, FanOf20000) {
  auto said = draw("56-fan-of-20000");
  EXPECT_EQ(said["f4000"].exit_code, 0);
  EXPECT_EQ(said["f16000"].exit_code, 0);
}

TEST_F(Cases, LongMessages) {
  fs::create_directories(root_ / "57");
  std::ofstream(root_ / "57/a.gltf") << R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 3, "uri": ")"
                                     << "data:model/vnd.mine;base64," << std::string(3000000, 'A') << "\"}]}";
  const Result result = run(root_, "./wrinkle render 57/a.gltf -o 57/a.png");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_LT(result.output.size(), 600U);
  EXPECT_THAT(result.output, HasSubstr("model/vnd.mine"));
}

TEST_F(Cases, OutputOverTexture) {
  const std::string before = [] {
    std::ifstream file(shared() / "62-output-over-texture/brick.png", std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  }();
  draw("62-output-over-texture", true);
  std::ifstream file(root_ / "62-output-over-texture/brick.png", std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), before);
  const Result named = run(root_ / "62-output-over-texture", "../wrinkle render brick.obj --size 64 -o ./brick.png");
  EXPECT_EQ(named.exit_code, 2);
  EXPECT_THAT(named.output, HasSubstr("brick.png"));
}

TEST_F(Cases, CompressedRequired) {
  auto said = draw("63-compressed-required");
  EXPECT_EQ(said["c"].exit_code, 2);
  EXPECT_THAT(said["c"].output, HasSubstr("KHR_draco_mesh_compression"));
  EXPECT_THAT(said["c"].output, Not(HasSubstr("accessor")));
}

TEST_F(Cases, EmptyColour) {
  auto said = draw("64-empty-colour");
  expect_same("64-empty-colour", "a", {"b"});
  for (const char* line : {"m.mtl", "line 2", "line 4", "line 5", "line 6"})
    EXPECT_THAT(said["a"].output, HasSubstr(line));
}

}  // namespace

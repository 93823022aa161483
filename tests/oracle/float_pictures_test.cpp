// A float32 renderer drew these pictures from stored vertices. The exact and the golden engine are compared with them.
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>

#include "golden/texel/normal_map.h"
#include "golden/texel/quantise.h"
#include "sim/scene/image.h"
#include "tests/oracle/procedures.h"
#include "tests/oracle/stored_vertices.h"

namespace wrinkle {
namespace {

constexpr int kSize = 512;

struct Case {
  const char* model;
  const char* map;
  const char* picture;
};

// R = N.L, G = N.H, B = 1 + triangle.
std::vector<float> read_oracle(const Case& c) {
  const auto path = asset(std::string("oracle/") + c.model + "/" + c.picture + ".exr");
  const auto input = OIIO::ImageInput::open(path.string());
  std::vector<float> pixels(static_cast<std::size_t>(kSize) * kSize * 3);
  if (!input || !input->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, pixels.data()))
    throw std::runtime_error("cannot read " + path.string());
  return pixels;
}

// The stored triangles with the model's normal map, level 0 only; a flat one for the picture without a map.
Frame oracle_frame(const Config& config, const Case& c) {
  const std::string model = c.model;
  Frame frame;
  frame.name = model;
  frame.width = frame.height = kSize;
  Draw draw;
  draw.state.bump = draw.state.textured = true;
  draw.triangles =
      read_stored_vertices(asset("oracle/" + model + "/" + model + ".wrts.xz").string(), config.subpixel_bits);
  NormalMap map(1, 1, Vec3{0, 0, 1});
  if (std::string(c.picture) != "phong_nomap") {
    const Image image = read_image(asset("gltf/" + model + "/glTF/" + c.map));
    Grid<Vec3> codes(image.width, image.height);
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) codes.at(x, y) = {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
    map = normal_map_from_image(codes);
  }
  frame.draws.push_back(std::move(draw));
  frame.exact_textures.push_back(assemble({map}, {}));
  frame.textures.push_back(quantise(frame.exact_textures[0], config));
  frame.exact_textures[0].levels.resize(1);
  frame.textures[0].levels.resize(1);
  return frame;
}

// The 99.9th percentile of the error of N.L; coverage and visible triangle must be the same everywhere.
double compare(const DotPicture& picture, const std::vector<float>& oracle) {
  std::vector<double> errors;
  std::size_t different = 0;
  for (std::size_t i = 0; i < picture.size(); ++i) {
    different += picture.triangle[i] != static_cast<std::uint32_t>(oracle[3 * i + 2]);
    if (picture.triangle[i] == 0) continue;
    errors.push_back(std::abs(picture.nl[i] - static_cast<double>(oracle[3 * i])));
    errors.push_back(std::abs(picture.nh[i] - static_cast<double>(oracle[3 * i + 1])));
  }
  EXPECT_EQ(different, 0u) << "pixels covered by another triangle, or none";
  std::sort(errors.begin(), errors.end());
  return errors[errors.size() * 999 / 1000];
}

class FloatPicture : public testing::TestWithParam<Case> {};

TEST_P(FloatPicture, ExactAndGoldenAgree) {
  WRINKLE_NEEDS_ASSET("oracle");
  Config config = load_config("extreme");
  config.filter = static_cast<int>(Filter::kBilinear);
  config.decal = 0;
  config.texel_bits = 8;
  config.subpixel_bits = 8;
  // The flat map is exactly (0, 0, 1) in one code, the 8-bit maps of the models are exact in the other.
  if (std::string(GetParam().picture) == "phong_nomap") config.decode = static_cast<int>(Decode::kOffset);
  const Frame frame = oracle_frame(config, GetParam());
  const std::vector<float> oracle = read_oracle(GetParam());
  const double exact = compare(draw_exact_dots(config, frame), oracle);
  const double golden = compare(draw_golden_dots(config, frame), oracle);
  std::printf("%s %s: 99.9 %% of errors at most: exact %.2g, golden %.2g\n", GetParam().model, GetParam().picture,
              exact, golden);
  EXPECT_LE(exact, 1.6e-4);
  EXPECT_LE(golden, 2e-3);
}

INSTANTIATE_TEST_SUITE_P(Models, FloatPicture,
                         testing::Values(Case{"Avocado", "Avocado_normal.png", "bump_bilinear0"},
                                         Case{"Avocado", "", "phong_nomap"},
                                         Case{"NormalTangentTest", "NormalTangentTest_Normal.png", "bump_bilinear0"},
                                         Case{"NormalTangentTest", "", "phong_nomap"},
                                         Case{"TwoSidedPlane", "TwoSidedPlane_Normal.png", "bump_bilinear0"},
                                         Case{"TwoSidedPlane", "", "phong_nomap"}),
                         [](const auto& param) { return std::string(param.param.model) + "_" + param.param.picture; });

}  // namespace
}  // namespace wrinkle

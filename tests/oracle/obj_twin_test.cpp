// OBJ + MTL copies of two glTF models: the same coverage, and nearly the same shading.
#include <algorithm>
#include <cmath>

#include "sim/scene/scene_reader.h"
#include "tests/oracle/procedures.h"

namespace wrinkle {
namespace {

class ObjTwin : public testing::TestWithParam<const char*> {};

TEST_P(ObjTwin, SamePictureAsGltf) {
  const std::string name = GetParam();
  const std::string gltf = "gltf/" + name + "/glTF/" + name + ".gltf", obj = "obj/" + name + "_assimp/" + name + ".obj";
  WRINKLE_NEEDS_ASSET(gltf);
  const Scene original = read_scene(asset(gltf));
  Scene twin = read_scene(asset(obj));
  twin.camera = original.camera;
  twin.light = original.light;
  twin.viewer_at_infinity = original.viewer_at_infinity;
  twin.width = original.width;
  twin.height = original.height;
  for (Object& object : twin.objects) object.double_sided = original.objects.front().double_sided;
  const Config config = load_config("perspective");
  const DotPicture a = draw_exact_dots(config, build_frame(config, original));
  const DotPicture b = draw_exact_dots(config, build_frame(config, twin));
  std::vector<double> errors;
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    different += (a.triangle[i] != 0) != (b.triangle[i] != 0);
    if (a.triangle[i] != 0 && b.triangle[i] != 0) errors.push_back(std::abs(a.nl[i] - b.nl[i]));
  }
  ASSERT_GT(errors.size(), 10000u);
  std::sort(errors.begin(), errors.end());
  std::printf("%s: %zu pixels, coverage differs in %zu, |difference of N.L| median %.2g, 99 %% %.2g\n", name.c_str(),
              errors.size(), different, errors[errors.size() / 2], errors[errors.size() * 99 / 100]);
  EXPECT_EQ(different, 0u);
  EXPECT_LE(errors[errors.size() / 2], .01);
}

INSTANTIATE_TEST_SUITE_P(Models, ObjTwin, testing::Values("Avocado", "NormalTangentTest"),
                         [](const auto& param) { return std::string(param.param); });

}  // namespace
}  // namespace wrinkle

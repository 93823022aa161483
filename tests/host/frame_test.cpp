// The vertex rate as a whole.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <numbers>
#include <random>

#include "golden/exact/exact.h"
#include "golden/texel/height.h"
#include "golden/texel/normal_map.h"
#include "golden/texel/quantise.h"
#include "golden/vertex/bezier.h"
#include "golden/vertex/camera.h"
#include "golden/vertex/scene.h"
#include "golden/vertex/shading.h"
#include "golden/vertex/surfaces.h"
#include "golden/vertex/teapot.h"
#include "golden/vertex/tessellate.h"
#include "golden/vertex/transform.h"

namespace wrinkle {
namespace {

constexpr int kSize = 128;

Object object_of(Mesh mesh) {
  Object object;
  object.mesh = std::move(mesh);
  return object;
}

Scene scene_of(Object object) {
  Scene scene;
  scene.width = scene.height = kSize;
  scene.camera.world_to_eye = look_at({0, 0, 5}, {}, {0, 1, 0});
  scene.light.position = {0.3, 0.4, 1};
  scene.objects.push_back(std::move(object));
  return scene;
}

std::shared_ptr<const ExactTexture> texture_of(const NormalMap& map) {
  return std::make_shared<ExactTexture>(assemble(normal_mips(map), {}));
}

Object bumped(Mesh mesh, NormalMap map) {
  Object object = object_of(std::move(mesh));
  object.space = ShadingSpace::kTangent;
  object.texture = texture_of(map);
  return object;
}

// N.L by pixel from the exact engine; -1 where nothing is drawn, -2 where a pixel is drawn twice.
std::vector<double> draw(const Config& config, const Scene& scene) {
  std::vector<double> image(static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height), -1);
  draw_exact(config, build_frame(config, scene), [&](const ExactFragment& f) {
    double& pixel = image[static_cast<std::size_t>(f.y * scene.width + f.x)];
    pixel = pixel == -1 ? f.nl : -2;
  });
  return image;
}

TEST(Frame, ProjectsAndSnapsToTheGrid) {
  const Config config;
  Scene scene = scene_of(object_of(tessellate(make_rectangle(), 1, 1)));
  scene.camera.near = 1, scene.camera.far = 9;
  const Frame frame = build_frame(config, scene);
  ASSERT_EQ(frame.draws.size(), 1u);
  ASSERT_EQ(frame.draws[0].triangles.size(), 2u);
  for (const ScreenTriangle& t : frame.draws[0].triangles) {
    for (const ScreenVertex& v : t.v) {
      EXPECT_EQ(v.x, (kSize / 2 + (v.P.x > 0 ? 1 : -1) * kSize / 4) << config.subpixel_bits);
      EXPECT_EQ(v.y, (kSize / 2 - (v.P.y > 0 ? 1 : -1) * kSize / 4) << config.subpixel_bits);  // y down
      EXPECT_EQ(v.z, 0.5);
      EXPECT_EQ(v.q, 1);
    }
  }
  scene.camera.world_to_eye = translation({0.49 / 256 * 2 / kSize, 0.51 / 256 * 2 / kSize, -5});
  const Frame moved = build_frame(config, scene);
  ASSERT_EQ(moved.draws[0].triangles.size(), 2u);
  EXPECT_EQ(moved.draws[0].triangles[0].v[0].x, frame.draws[0].triangles[0].v[0].x);
  EXPECT_EQ(moved.draws[0].triangles[0].v[0].y, frame.draws[0].triangles[0].v[0].y - 1);
}

TEST(Frame, CullsBacksUnlessDoubleSided) {
  Scene scene = scene_of(object_of(tessellate(make_cube(), 1, 1)));
  EXPECT_EQ(build_frame({}, scene).draws[0].triangles.size(), 2u);
  scene.objects[0].double_sided = true;
  const Frame both = build_frame({}, scene);
  EXPECT_EQ(both.draws[0].triangles.size(), 4u);  // the four sides are seen edge-on
  for (const ScreenTriangle& t : both.draws[0].triangles) {
    EXPECT_GT(t.v[0].N.z, 0.99);  // the back's normals are turned to the viewer
    EXPECT_GT(t.surface->at(0.5, 0.5).N.z, 0.99);
  }
}

// Those that are culled count too: an id names a triangle of the mesh.
TEST(Frame, CountsTrianglesOverTheFrame) {
  Scene scene = scene_of(object_of(tessellate(make_cube(), 1, 1)));
  scene.objects[0].to_world = rotation({1, 0, 0}, std::numbers::pi / 2);  // the lid, face 4, to the front
  scene.objects.push_back(scene.objects[0]);
  const Frame frame = build_frame({}, scene);
  ASSERT_EQ(frame.draws[0].triangles.size(), 2u);
  ASSERT_EQ(frame.draws[1].triangles.size(), 2u);
  EXPECT_EQ(frame.draws[0].triangles[0].id, 8u);
  EXPECT_EQ(frame.draws[0].triangles[1].id, 9u);
  EXPECT_EQ(frame.draws[1].triangles[0].id, 12u + 8u);
}

// Triangles of the size of the grid: snapping flattens some and turns some over; those left all turn as before.
TEST(Frame, SnappingTurnsNothingOver) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> position(-2.0 / kSize / 256, 2.0 / kSize / 256);
  Mesh mesh;
  for (std::uint32_t i = 0; i < 3000; ++i) {
    Vertex v;
    v.P = {position(random), position(random), 0};
    v.N = {0, 0, 1}, v.T = {1, 0, 0};
    mesh.vertices.push_back(v);
    if (i % 3 == 2) mesh.triangles.push_back({i - 2, i - 1, i});
  }
  const Frame frame = build_frame({}, scene_of(object_of(mesh)));
  EXPECT_GT(frame.draws[0].triangles.size(), 100u);
  EXPECT_LT(frame.draws[0].triangles.size(), 500u);  // half face away
  for (const ScreenTriangle& t : frame.draws[0].triangles) {
    const auto &a = t.v[0], &b = t.v[1], &c = t.v[2];
    ASSERT_LT((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y), 0);
  }
}

// A vertex without a usable tangent still has a frame [extremes 30].
TEST(Frame, Extreme30NoTangent) {
  for (const Vec3 T : {Vec3{}, Vec3{0, 0, 1}, Vec3{0, 0, -1}}) {
    const TangentFrame f = tangent_frame({{}, {0, 0, 1}, T, 1, {}, {}}, {});
    EXPECT_NEAR(length(f.T), 1, 1e-12);
    EXPECT_NEAR(dot(f.T, f.N), 0, 1e-12);
    EXPECT_NEAR(dot(cross(f.N, f.T), f.B), 1, 1e-12);
  }
}

TEST(Frame, AMirroringMatrixDrawsTheSameSide) {
  Object object = object_of(tessellate({std::make_shared<Sphere>(0.8)}, 16, 16));
  const Frame plain = build_frame({}, scene_of(object));
  object.to_world = scaling({-1, 1, 1});
  const Frame mirrored = build_frame({}, scene_of(object));
  EXPECT_EQ(plain.draws[0].triangles.size(), mirrored.draws[0].triangles.size());
  for (const ScreenTriangle& t : mirrored.draws[0].triangles) {
    for (const ScreenVertex& v : t.v) {
      EXPECT_NEAR(length(v.N - normalize(v.P)), 0, 1e-9);
      EXPECT_LT(length(t.surface->at(v.parameter.x, v.parameter.y).P - v.P), 1e-12);
    }
  }
}

// Eq. 7: the rotation keeps lengths and angles; N of the surface becomes (0, 0, 1).
TEST(Frame, TangentSpaceIsARotation) {
  Scene scene = scene_of(bumped(tessellate(teapot(), 4, 4), NormalMap(1, 1, {0, 0, 1})));
  scene.light = {{1, 2, 3}, false};
  scene.viewer_at_infinity = false;
  const Frame tangent = build_frame({}, scene);
  scene.objects[0].space = ShadingSpace::kWorld;
  const Frame world = build_frame({}, scene);
  ASSERT_TRUE(tangent.draws[0].state.bump);
  ASSERT_FALSE(world.draws[0].state.bump);
  const auto& a = tangent.draws[0].triangles;
  const auto& b = world.draws[0].triangles;
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const ScreenVertex &t = a[i].v[k], &w = b[i].v[k];
      ASSERT_EQ(t.N, (Vec3{0, 0, 1}));
      ASSERT_NEAR(t.L.z, dot(w.L, w.N), 1e-12);
      ASSERT_NEAR(t.H.z, dot(w.H, w.N), 1e-12);
      ASSERT_NEAR(dot(t.L, t.H), dot(w.L, w.H), 1e-12);
      ASSERT_NEAR(length(t.L), 1, 1e-12);
    }
  }
}

TEST(Frame, FramesAreOrthonormalUnderAnyMatrix) {
  for (const double flip : {1.0, -1.0}) {
    const Mat4 m = rotation({1, 2, 3}, 1) * scaling({flip * 3, 0.2, 1});
    for (const Vertex& v : tessellate(teapot(), 3, 3).vertices) {
      const TangentFrame f = tangent_frame(v, m);
      ASSERT_NEAR(length(f.T), 1, 1e-9);
      ASSERT_NEAR(length(f.B), 1, 1e-9);
      ASSERT_NEAR(dot(f.T, f.B), 0, 1e-9);
      ASSERT_NEAR(dot(f.T, f.N), 0, 1e-9);
      ASSERT_NEAR(dot(f.B, f.N), 0, 1e-9);
      ASSERT_NEAR(dot(cross(f.N, f.T), f.B), flip, 1e-9);
      // B goes up the image: along the image of the surface's B.
      ASSERT_GT(dot(f.B, transform_direction(m, cross(v.N, v.T))), 0);
    }
  }
}

TEST(Frame, LightAndViewerNearAndFar) {
  Scene scene = scene_of(object_of(tessellate(make_rectangle(), 1, 1)));
  scene.camera.perspective = true;
  for (const bool light_far : {true, false}) {
    for (const bool viewer_far : {true, false}) {
      scene.light = {{0, 3, 4}, light_far};
      scene.viewer_at_infinity = viewer_far;
      const Frame frame = build_frame({}, scene);
      EXPECT_EQ(frame.ideal.eye_at_infinity, viewer_far);
      EXPECT_EQ(frame.ideal.light_at_infinity, light_far);
      ASSERT_FALSE(frame.draws[0].triangles.empty());
      const ScreenVertex& v = frame.draws[0].triangles[0].v[0];
      const Vec3 L = normalize(light_far ? Vec3{0, 3, 4} : Vec3{0, 3, 4} - v.P);
      const Vec3 V = viewer_far ? Vec3{0, 0, 1} : normalize(Vec3{0, 0, 5} - v.P);
      EXPECT_NEAR(length(v.L - L), 0, 1e-12);
      EXPECT_NEAR(length(v.H - normalize(L + V)), 0, 1e-12);
    }
  }
}

TEST(Frame, LightInAVertexGivesZeroNotNaN) {
  Scene scene = scene_of(object_of(tessellate(make_rectangle(), 2, 2)));
  scene.light = {{0, 0, 0}, false};
  const Frame frame = build_frame({}, scene);
  int zero = 0;
  for (const ScreenTriangle& t : frame.draws[0].triangles) {
    for (const ScreenVertex& v : t.v) {
      EXPECT_TRUE(std::isfinite(v.L.x + v.L.y + v.L.z + v.H.x + v.H.y + v.H.z));
      zero += v.L == Vec3{} ? 1 : 0;
    }
  }
  EXPECT_EQ(zero, 6);  // triangles around the centre
}

TEST(Frame, TexturesAreSharedAndFollowTheConfiguration) {
  Scene scene = scene_of(bumped(tessellate(make_rectangle(), 1, 1), NormalMap(4, 4, {0, 0, 1})));
  scene.objects.push_back(scene.objects[0]);                               // the same texture
  scene.objects.push_back(object_of(tessellate(make_rectangle(), 1, 1)));  // none
  scene.objects.push_back(bumped(tessellate(make_rectangle(), 1, 1), NormalMap(2, 2, {0, 0, 1})));
  scene.objects[3].space = ShadingSpace::kWorld;  // one that only a decal would need
  Config config;
  const Frame bump = build_frame(config, scene);
  EXPECT_EQ(bump.textures.size(), 1u);
  EXPECT_EQ(bump.exact_textures.size(), 1u);
  EXPECT_TRUE(bump.draws[0].state.bump && bump.draws[0].state.textured && bump.draws[1].state.bump);
  EXPECT_FALSE(bump.draws[2].state.bump || bump.draws[2].state.textured);
  EXPECT_FALSE(bump.draws[3].state.bump || bump.draws[3].state.textured);

  config.decal = 1;
  const Frame decal = build_frame(config, scene);
  EXPECT_EQ(decal.textures.size(), 2u);
  EXPECT_FALSE(decal.draws[2].state.textured);
  EXPECT_TRUE(decal.draws[3].state.textured);
  EXPECT_EQ(decal.draws[3].state.texture, 1);
  EXPECT_FALSE(decal.draws[3].state.bump);

  config = {};
  config.datapath = static_cast<int>(Datapath::kPhong);
  const Frame phong = build_frame(config, scene);  // falls back to world space
  EXPECT_TRUE(phong.textures.empty());
  EXPECT_FALSE(phong.draws[0].state.bump || phong.draws[0].state.textured);
  EXPECT_NEAR(length(phong.draws[0].triangles[0].v[0].L - normalize(Vec3{0.3, 0.4, 1})), 0, 1e-12);
}

// A closed mesh in front of the camera: no pixel is drawn twice, and there is no hole.
TEST(Frame, WatertightWholeAndClipped) {
  for (const double half_height : {1.0, 0.004}) {  // the second: most corners are far outside the guard band
    Scene scene = scene_of(object_of(tessellate({std::make_shared<Sphere>(0.9)}, 24, 24)));
    scene.camera.half_height = half_height;
    Config config;
    config.screen_bits = 7;
    const std::vector<double> image = draw(config, scene);
    EXPECT_EQ(std::count(image.begin(), image.end(), -2), 0);
    for (int y = 0; y < kSize; ++y) {
      int runs = 0;
      for (int x = 0; x < kSize; ++x) {
        const auto at = [&](int column) {
          return column >= 0 && image[static_cast<std::size_t>(y * kSize + column)] > -1;
        };
        runs += at(x) && !at(x - 1) ? 1 : 0;
      }
      ASSERT_LE(runs, 1) << "row " << y;
    }
    EXPECT_GT(std::count_if(image.begin(), image.end(), [](double v) { return v >= 0; }), kSize * kSize / 2);
  }
}

TEST(Frame, GuardBandHoldsWhateverIsThere) {
  Scene scene = scene_of(object_of(tessellate(make_floor(1e6, 1e6), 4, 4)));
  scene.camera.perspective = true;
  scene.camera.world_to_eye = look_at({0, 0.3, 0}, {0, 0, -10}, {0, 1, 0});
  scene.camera.near = 0.01, scene.camera.far = 1e7;
  const Config config;
  const Frame frame = build_frame(config, scene);
  ASSERT_FALSE(frame.draws[0].triangles.empty());
  const int unit = config.screen_size() << config.subpixel_bits;
  for (const ScreenTriangle& t : frame.draws[0].triangles) {
    for (const ScreenVertex& v : t.v) {
      EXPECT_TRUE(v.x >= -unit && v.x < 2 * unit && v.y >= -unit && v.y < 2 * unit);
      EXPECT_TRUE(v.q > 0 && v.q <= 1 / 0.01 * (1 + 1e-6) && v.z >= 0 && v.z <= 1);
      EXPECT_LE(length(v.L), 1 + 1e-12);
    }
  }
  const std::vector<double> image = draw(config, scene);
  EXPECT_EQ(std::count(image.begin(), image.end(), -2), 0);
  for (int x = 0; x < kSize; ++x) EXPECT_GT(image[static_cast<std::size_t>((kSize - 1) * kSize + x)], 0);
}

// Bumps pushed out of a rectangle are lit on the side that faces the light, whichever way the image is turned.
TEST(Frame, BumpIsLitOnTheSideOfTheLight) {
  Grid<double> height(64, 64);
  for (int y = 24; y < 40; ++y) {
    for (int x = 24; x < 40; ++x) height.at(x, y) = 0.05;
  }
  struct Case {
    Vec3 light;
    int x, y;  // pixel on the side of the bump that faces it, from the centre
  };
  for (const Case& c : {Case{{1, 0, 1}, 15, 0}, {{-1, 0, 1}, -16, 0}, {{0, 1, 1}, 0, -16}, {{0, -1, 1}, 0, 15}}) {
    for (const bool mirror : {false, true}) {
      Object object = bumped(tessellate(make_rectangle(), 1, 1), normal_map(height, 1.0));
      object.to_world = scaling({mirror ? -1.8 : 1.8, 1.8, 1.8});
      Scene scene = scene_of(object);
      scene.light.position = c.light;
      const std::vector<double> image = draw({}, scene);
      const auto at = [&](int x, int y) {
        return image[static_cast<std::size_t>((kSize / 2 + y) * kSize + kSize / 2 + x)];
      };
      const double flat = std::numbers::sqrt2 / 2;
      // The sides of the bump are 8/64 of 1.8 from the centre: 14.4 pixels.
      EXPECT_GT(at(c.x, c.y), flat + 0.1);
      EXPECT_LT(at(-c.x - (c.x != 0 ? 1 : 0), -c.y - (c.y != 0 ? 1 : 0)), flat - 0.1);
      EXPECT_NEAR(at(0, 0), flat, 0.02);
      EXPECT_NEAR(at(40, 40), flat, 0.02);
    }
  }
}

// RMS difference of N.L from Blinn's, with the paper's patch in divisions^2 x 2 triangles.
double method_error(double amplitude, int divisions) {
  const Grid<double> height = pinwheel(256, amplitude);
  const auto patch = stretched_patch();
  Object object = bumped(tessellate({patch}, divisions, divisions), normal_map(height, *patch));
  object.height = std::make_shared<SampledHeightField>(height);
  Scene scene = scene_of(std::move(object));
  scene.width = scene.height = 256;
  const Frame frame = build_frame({}, scene);
  std::map<std::pair<int, int>, double> exact;
  draw_exact({}, frame, [&](const ExactFragment& f) { exact[{f.x, f.y}] = f.nl; });
  double sum = 0;
  draw_ideal({}, frame, [&](const ExactFragment& f) {
    const double difference = f.nl - exact.at({f.x, f.y});
    sum += difference * difference;
  });
  return std::sqrt(sum / static_cast<double>(exact.size()));
}

// The vectors interpolated over triangles approach those of the surface as the square of the triangles' size. Under a
// bump map the filtering of the texture, which the ideal picture does not have, remains.
TEST(Frame, TangentSpaceApproachesTheIdeal) {
  const double smooth = method_error(0, 8), finer = method_error(0, 16);
  const double coarse_bumps = method_error(0.02, 2), bumps = method_error(0.02, 8),
               finer_bumps = method_error(0.02, 32);
  std::printf(
      "RMS of N.L against the ideal: smooth %.5f (8 x 8 x 2), %.5f (16 x 16 x 2); bumps %.4f (2 x 2 x 2), "
      "%.4f (8 x 8 x 2), %.4f (32 x 32 x 2)\n",
      smooth, finer, coarse_bumps, bumps, finer_bumps);
  EXPECT_LT(finer, 0.3 * smooth);
  EXPECT_LT(bumps, 0.02);
  EXPECT_LT(bumps, coarse_bumps);
  EXPECT_LT(finer_bumps, bumps);
}

// Scaling x by -1 and reversing the winding, light mirrored too: the mirror image, pixel by pixel [extremes 29].
TEST(Frame, Extreme29MirrorImage) {
  const Grid<double> height = pinwheel(64, 0.03);
  const auto patch = stretched_patch();
  const Mesh mesh = tessellate({patch});
  Mesh mirrored = mesh;
  mirrored.surfaces.clear();
  mirrored.triangle_surface.clear();
  for (Vertex& v : mirrored.vertices) {
    v.P.x = -v.P.x, v.N.x = -v.N.x, v.T.x = -v.T.x;
    v.sign = -v.sign;
  }
  for (auto& t : mirrored.triangles) std::swap(t[1], t[2]);
  Object by_matrix = bumped(mesh, normal_map(height, *patch));
  by_matrix.to_world = scaling({-1, 1, 1});

  Scene scene = scene_of(bumped(mesh, normal_map(height, *patch)));
  // Off the grid, so that no pixel centre lies on an edge: the fill rule is not symmetric.
  const double off = 0.3 / 256 * 2 / kSize;
  scene.camera.world_to_eye = translation({off, 0, -5});
  const std::vector<double> original = draw({}, scene);
  for (const Object& object : {bumped(mirrored, normal_map(height, *patch)), by_matrix}) {
    Scene other = scene_of(object);
    other.light.position.x = -other.light.position.x;
    other.camera.world_to_eye = translation({-off, 0, -5});
    const std::vector<double> image = draw({}, other);
    int covered_differently = 0;
    double worst = 0;
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        const double a = original[static_cast<std::size_t>(y * kSize + x)];
        const double b = image[static_cast<std::size_t>(y * kSize + kSize - 1 - x)];
        covered_differently += (a < 0) != (b < 0) ? 1 : 0;
        if (a >= 0 && b >= 0) worst = std::max(worst, std::abs(a - b));
      }
    }
    EXPECT_EQ(covered_differently, 0);
    EXPECT_LT(worst, 1e-4);
  }
}

// From behind, the perturbed normal is the opposite of that of the front: the frame is turned round as a whole.
TEST(Frame, BackOfABumpIsADent) {
  Grid<double> height(64, 64);
  for (int y = 24; y < 40; ++y) {
    for (int x = 24; x < 40; ++x) height.at(x, y) = 0.05;
  }
  Object object = bumped(tessellate(make_rectangle(), 1, 1), normal_map(height, 1.0));
  object.double_sided = true;
  object.to_world = rotation({0, 1, 0}, std::numbers::pi) * scaling({1.8, 1.8, 1.8});
  Scene scene = scene_of(object);
  scene.light.position = {1, 0, 1};
  const std::vector<double> image = draw({}, scene);
  const auto at = [&](int x) { return image[static_cast<std::size_t>(kSize / 2 * kSize + kSize / 2 + x)]; };
  EXPECT_NEAR(at(0), std::numbers::sqrt2 / 2, 0.02);
  EXPECT_LT(at(15), at(0) - 0.1);
  EXPECT_GT(at(-16), at(0) + 0.1);
}

// The ideal picture is of the same side and the same bumps: plain, in a mirror, from behind, and both.
TEST(Frame, IdealSeesMirroredAndBackSidesAsTheDatapathDoes) {
  const Grid<double> height = pinwheel(256, 0.02);
  const auto patch = stretched_patch();
  for (const bool mirror : {false, true}) {
    for (const bool back : {false, true}) {
      Object object = bumped(tessellate({patch}, 16, 16), normal_map(height, *patch));
      object.height = std::make_shared<SampledHeightField>(height);
      object.double_sided = true;
      object.to_world = rotation({0, 1, 0}, back ? std::numbers::pi : 0) * scaling({mirror ? -1.0 : 1.0, 1, 1});
      Scene scene = scene_of(std::move(object));
      scene.width = scene.height = 256;
      const Frame frame = build_frame({}, scene);
      std::map<std::pair<int, int>, double> exact;
      draw_exact({}, frame, [&](const ExactFragment& f) { exact[{f.x, f.y}] = f.nl; });
      double sum = 0;
      draw_ideal({}, frame, [&](const ExactFragment& f) { sum += std::pow(f.nl - exact.at({f.x, f.y}), 2); });
      ASSERT_GT(exact.size(), 10000u);
      EXPECT_LT(std::sqrt(sum / static_cast<double>(exact.size())), 0.02) << mirror << back;
    }
  }
}

TEST(Frame, AHundredThousandTrianglesTakeLessThanASecond) {
  const Scene scene = scene_of(object_of(tessellate({std::make_shared<Torus>(0.6, 0.3)}, 256, 200)));
  const auto start = std::chrono::steady_clock::now();
  const Frame frame = build_frame({}, scene);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::printf("102400 triangles, %zu in sight: %.3f s\n", frame.draws[0].triangles.size(), seconds);
  EXPECT_GT(frame.draws[0].triangles.size(), 30000u);
#ifdef NDEBUG
  EXPECT_LT(seconds, 1);
#endif
}

}  // namespace
}  // namespace wrinkle

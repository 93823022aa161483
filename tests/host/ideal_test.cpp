// The truth of meshes: what `ideal` draws where there is no analytic surface, and what a method loses against it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "golden/texel/height.h"
#include "golden/vertex/surfaces.h"
#include "golden/vertex/tessellate.h"
#include "golden/vertex/transform.h"
#include "tests/host/frames.h"

namespace wrinkle {
namespace {

using namespace test;

using FloatEngine = void (*)(const Config&, const Frame&, const ExactSink&);

std::vector<Vec3> picture(FloatEngine engine, const Config& config, const Scene& scene) {
  const Frame frame = build_frame(config, scene);
  std::vector<Vec3> pixels(static_cast<std::size_t>(kSize * kSize));
  engine(config, frame,
         [&](const ExactFragment& f) { pixels[static_cast<std::size_t>(f.y * kSize + f.x)] = f.colour; });
  return pixels;
}

double psnr(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += dot(a[i] - b[i], a[i] - b[i]) / 3;
  return -10 * std::log10(sum / static_cast<double>(a.size()));
}

double method_db(const Config& config, const Scene& scene) {
  return psnr(picture(draw_exact, config, scene), picture(draw_ideal, config, scene));
}

Config configured() {
  Config config;
  config.perspective = config.decal = 1;
  config.specular_squarings = 4;
  return config;
}

// Stripes of two base colours, and waves for bumps, without heights: as a file of a mesh would have them.
std::shared_ptr<const ExactTexture> striped_waves() {
  Grid<double> height(64, 64);
  Grid<Vec3> colour(64, 64);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      height.at(x, y) = 0.006 * std::sin(x * std::numbers::pi / 8) * std::sin(y * std::numbers::pi / 8);
      colour.at(x, y) = (x / 8 + y / 8) % 2 == 0 ? Vec3{0.9, 0.5, 0.2} : Vec3{0.3, 0.5, 0.9};
    }
  }
  return std::make_shared<ExactTexture>(assemble(normal_mips(normal_map(height, 1.0)), colour_mips(colour)));
}

// A mesh seen close by with a light near to it, so that perspective, L and H change across a triangle.
Scene mesh_scene(const Mesh& mesh) {
  Object object = object_of(mesh);
  object.space = ShadingSpace::kTangent;
  object.texture = striped_waves();
  object.material.exponent = 16;
  object.material.specular = {0.4, 0.4, 0.4};
  object.shadow = false;
  Scene scene = scene_of(std::move(object));
  scene.camera.perspective = true;
  scene.camera.world_to_eye = look_at({0.4, 0.9, 2.2}, {}, {0, 1, 0});
  scene.camera.half_height = 0.6;
  scene.camera.near = 0.5, scene.camera.far = 10;
  scene.viewer_at_infinity = false;
  scene.light = {{0.6, 0.8, 1.5}, false};
  return scene;
}

Mesh without_surfaces(Mesh mesh) {
  mesh.surfaces.clear();
  mesh.triangle_surface.clear();
  return mesh;
}

// The finer a mesh, the nearer its truth is to that of the surface it was made of.
TEST(MeshTruth, ApproachesThatOfTheSurface) {
  double last = 0;
  for (int n : {16, 32, 64}) {
    const Mesh mesh = tessellate({std::make_shared<Torus>(1, 0.4)}, n, n);
    const double db = psnr(picture(draw_ideal, configured(), mesh_scene(without_surfaces(mesh))),
                           picture(draw_ideal, configured(), mesh_scene(mesh)));
    std::printf("torus of %d x %d: truth of the mesh %.2f dB from that of the surface\n", n, n, db);
    EXPECT_GT(db, last + 3);
    last = db;
  }
  EXPECT_GT(last, 40);
}

// What the twin interpolates over a triangle is an error of its method, which falls with the triangles' size.
TEST(MeshTruth, InterpolationIsAnErrorOfTheMethod) {
  const auto db = [](int n) {
    return method_db(configured(), mesh_scene(without_surfaces(tessellate(make_rectangle(), n, n))));
  };
  const double one = db(1), eight = db(8);
  std::printf("rectangle under a near light: %.2f dB in 2 triangles, %.2f dB in 128\n", one, eight);
  EXPECT_LT(one, 45);
  EXPECT_GT(eight, one + 10);
}

// A configuration that leaves out what the scene has is further from the truth, never nearer.
TEST(MeshTruth, WhatIsLeftOutIsAnErrorOfTheMethod) {
  const Scene scene = mesh_scene(without_surfaces(tessellate(make_rectangle(), 8, 8)));
  const double whole = method_db(configured(), scene);
  const auto loss = [&](int Config::*parameter, int value) {
    Config config = configured();
    config.*parameter = value;
    return whole - method_db(config, scene);
  };
  EXPECT_GT(loss(&Config::decal, 0), 10) << "base colours";
  EXPECT_GT(loss(&Config::lighting, 0), 10) << "highlights";
  EXPECT_GT(loss(&Config::specular_squarings, 3), 10) << "the exponent 16, drawn as 8";
  EXPECT_GT(loss(&Config::datapath, 0), 5) << "bumps";
  EXPECT_GT(loss(&Config::channels, 0), 10) << "colours";
  Scene worn = scene;
  ExactTexture texture = *scene.objects[0].texture;
  for (auto& level : texture.levels)
    for (ExactTexel& texel : level) texel.gloss = 0.2F;
  worn.objects[0].texture = std::make_shared<ExactTexture>(texture);
  Config glossed = configured();
  glossed.gloss_map = 1;
  EXPECT_GT(method_db(glossed, worn), method_db(configured(), worn) + 10) << "gloss";
  Scene coarse = mesh_scene(without_surfaces(tessellate(make_rectangle(), 1, 1)));
  Config affine = configured();
  affine.perspective = 0;
  EXPECT_GT(method_db(configured(), coarse), method_db(affine, coarse) + 5) << "texture coordinates";
}

// The truth has the same side and the same bumps as the datapath: plain, in a mirror, from behind, in object space.
TEST(MeshTruth, SeesEachSideAndSpaceAsTheDatapathDoes) {
  for (const ShadingSpace space : {ShadingSpace::kTangent, ShadingSpace::kObject}) {
    for (const bool mirror : {false, true}) {
      for (const bool back : {false, true}) {
        Scene scene = mesh_scene(without_surfaces(tessellate(make_rectangle(), 16, 16)));
        Object& object = scene.objects[0];
        object.space = space;
        object.double_sided = true;
        object.to_world =
            rotation({0, 1, 0}, back ? std::numbers::pi + 0.3 : 0.3) * scaling({mirror ? -1.0 : 1.0, 1, 1});
        EXPECT_GT(method_db(configured(), scene), 40) << mirror << back << static_cast<int>(space);
      }
    }
  }
}

// One pixel by hand: the triangle's plane hit by the ray through the pixel, and all attributes there.
TEST(MeshTruth, IsTheRayThroughThePixel) {
  Mesh mesh = without_surfaces(tessellate(make_rectangle(), 1, 1));
  const Scene scene = mesh_scene(mesh);
  const Vec3 eye{0.4, 0.9, 2.2}, light{0.6, 0.8, 1.5};
  const Vec3 ahead = normalize(-eye), right = normalize(cross(ahead, {0, 1, 0})), up = cross(right, ahead);
  int checked = 0;
  const Frame frame = build_frame(configured(), scene);
  draw_ideal(configured(), frame, [&](const ExactFragment& f) {
    if (f.x % 8 != 0 || f.y % 8 != 0) return;
    const double sx = 0.6 * (2 * (f.x + 0.5) / kSize - 1), sy = 0.6 * (1 - 2 * (f.y + 0.5) / kSize);
    const Vec3 ray = ahead + sx * right + sy * up;
    const Vec3 P = eye - (eye.z / ray.z) * ray;  // the rectangle lies in z = 0
    // Corners are on a grid of 1/16 pixels.
    EXPECT_NEAR(length(f.l - normalize(light - P)), 0, 2e-3);
    EXPECT_NEAR(length(f.h - normalize(normalize(light - P) + normalize(eye - P))), 0, 2e-3);
    EXPECT_NEAR(f.nl, std::max(dot(f.n, f.l), 0.0), 1e-12);
    ++checked;
  });
  EXPECT_GT(checked, 10);
}

}  // namespace
}  // namespace wrinkle

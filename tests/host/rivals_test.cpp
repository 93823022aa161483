// The datapaths beside each other on the paper's patch: method against `ideal`, precision against the exact twin.
#include <gtest/gtest.h>

#include <cmath>

#include "golden/datapath/datapaths.h"
#include "golden/exact/exact.h"
#include "golden/pixel/pixel.h"
#include "golden/texel/bump.h"
#include "golden/texel/height.h"
#include "golden/texel/quantise.h"
#include "golden/vertex/bezier.h"
#include "golden/vertex/camera.h"
#include "golden/vertex/scene.h"
#include "golden/vertex/shading.h"
#include "golden/vertex/surfaces.h"
#include "golden/vertex/tessellate.h"
#include "golden/vertex/transform.h"
#include "tests/host/packet_walker.h"

namespace wrinkle {
namespace {

using test::Random;
using Pixels = std::vector<double>;

constexpr int kSize = 256;

// What the pinwheel becomes: an object on the stretched patch, level 0 of its map alone, so that what is compared is
// the arithmetic at the pixel and not the choice of a filter.
enum class Map { kSurface, kSquare, kObject, kNone };

Scene patch_scene(int tessellation, Map map, Mat4 to_world = {}) {
  static const Grid<double> kHeights = pinwheel(256, 0.02);
  const auto surface = stretched_patch();
  Object object;
  object.mesh = tessellate({surface}, tessellation, tessellation);
  object.to_world = to_world;
  object.shadow = false;
  object.material.exponent = 16;
  if (map != Map::kNone) {
    const auto placed = transformed(surface, to_world);
    NormalMap normals =
        map == Map::kSquare ? normal_map(kHeights, mean_scale(*surface)) : normal_map(kHeights, *placed);
    if (map == Map::kObject) normals = out_of_tangent_space(normal_map(kHeights, *surface), *surface);
    object.texture = std::make_shared<ExactTexture>(assemble({normals}, {}));
    auto texture = std::make_shared<ExactTexture>(*object.texture);
    texture->levels.resize(1);
    object.texture = texture;
    object.height = std::make_shared<SampledHeightField>(kHeights);
    object.heights = std::make_shared<Grid<double>>(kHeights);
    // At the borders of the patch a repeated map would mix normals of opposite sides.
    object.wrap_u = object.wrap_v = Wrap::kClamp;
    object.space = map == Map::kObject ? ShadingSpace::kObject : ShadingSpace::kTangent;
  }
  Scene scene;
  scene.width = scene.height = kSize;
  scene.camera.world_to_eye = look_at({0, 0, 4}, {}, {0, 1, 0});
  scene.camera.half_height = 1.05;
  scene.light.position = {-0.45, 0.5, 0.75};
  scene.objects.push_back(std::move(object));
  return scene;
}

Config with(std::initializer_list<std::pair<int Config::*, int>> changes) {
  Config config;
  config.filter = static_cast<int>(Filter::kBilinear);
  for (const auto& [member, value] : changes) config.*member = value;
  return config;
}

using FloatEngine = void (*)(const Config&, const Frame&, const ExactSink&);

Pixels picture(FloatEngine engine, const Config& config, const Frame& frame) {
  Pixels pixels(static_cast<std::size_t>(kSize * kSize), 0);
  engine(config, frame,
         [&](const ExactFragment& f) { pixels[static_cast<std::size_t>(f.y * kSize + f.x)] = f.colour.y; });
  return pixels;
}

Pixels golden(const Config& config, const Frame& frame) {
  Pixels pixels(static_cast<std::size_t>(kSize * kSize), 0);
  const auto sink = [&](const auto& batch) {
    for (int i = 0; i < batch.count; ++i) {
      const Fragment f = fragment(batch, i);
      pixels[static_cast<std::size_t>(f.y * kSize + f.x)] = f.colour[1] / 255.0;
    }
  };
  Golden(config, frame.textures).draw(build_packets(config, frame).words, {sink, sink});
  return pixels;
}

double psnr(const Pixels& a, const Pixels& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return -10 * std::log10(sum / static_cast<double>(a.size()));
}

struct Errors {
  double method, precision;  // PSNR of the exact twin against `ideal`, of the golden model against the exact twin
};
Errors measure(const char* name, const Config& config, const Scene& scene) {
  const Frame frame = build_frame(config, scene);
  const Pixels ideal = picture(draw_ideal, config, frame), exact = picture(draw_exact, config, frame);
  const Errors errors{psnr(exact, ideal), psnr(golden(config, frame), exact)};
  std::printf("%-36s %6.2f dB to ideal, %6.2f dB of precision\n", name, errors.method, errors.precision);
  return errors;
}

// Fig. 2 is Eq. 1-2 at every pixel but for the interpolation of its vectors: with finer triangles it becomes `ideal`.
// What remains of Fig. 3 is that it filters unit normals where Fig. 2 filters slopes.
TEST(Rivals, BlinnConvergesToIdealWithTessellation) {
  const Config blinn = with({{&Config::datapath, 2}}), tangent = with({});
  Config held = blinn;
  held.cross_products = 1;
  double last = 0;
  for (int n : {4, 8, 16, 32}) {
    std::printf("%d x %d\n", n, n);
    const double fig2 = measure("  fig. 2", blinn, patch_scene(n, Map::kSurface)).method;
    const double constant = measure("  fig. 2, Pv x N, N x Pu held", held, patch_scene(n, Map::kSurface)).method;
    measure("  fig. 3, eq. 3-6", tangent, patch_scene(n, Map::kSurface));
    measure("  fig. 3, eq. 8-11", tangent, patch_scene(n, Map::kSquare));
    EXPECT_GT(fig2, last + 6) << "the error of linear interpolation falls with the square of the divisions";
    EXPECT_GT(fig2, constant) << "what is held over a triangle is coarser";
    last = fig2;
  }
  EXPECT_GT(last, 60);
}

TEST(Rivals, PrecisionIsThatOfStandard) {
  EXPECT_GT(measure("standard", with({}), patch_scene(8, Map::kSurface)).precision, 45);
  EXPECT_GT(measure("blinn", with({{&Config::datapath, 2}}), patch_scene(8, Map::kSurface)).precision, 45);
  EXPECT_GT(measure("blinn, exponent of the draw", with({{&Config::datapath, 2}, {&Config::block_exponent, 1}}),
                    patch_scene(8, Map::kSurface))
                .precision,
            45);
  EXPECT_GT(measure("object space", with({}), patch_scene(8, Map::kObject)).precision, 45);
  EXPECT_GT(measure("object space, constant L, H", with({{&Config::light_vectors, 1}}), patch_scene(8, Map::kObject))
                .precision,
            45);
  EXPECT_GT(measure("rotated", with({{&Config::datapath, 3}}), patch_scene(8, Map::kNone)).precision, 45);
  EXPECT_GT(measure("phong", with({{&Config::datapath, 0}}), patch_scene(8, Map::kNone)).precision, 45);
  EXPECT_GT(measure("reflection", with({{&Config::lighting, 2}}), patch_scene(8, Map::kSurface)).precision, 40);
  EXPECT_GT(measure("half-angle of the pixel", with({{&Config::lighting, 3}}), patch_scene(8, Map::kSurface)).precision,
            45);
}

// With constant L and H a map in object space draws what a map in tangent space draws on fine triangles. A turned
// object looks as the object does when everything else is turned the other way.
TEST(Rivals, ObjectSpaceLightsAsTangentSpace) {
  const Config constant = with({{&Config::light_vectors, 1}});
  const auto object = [&](const Mat4& m) {
    return picture(draw_exact, constant, build_frame(constant, patch_scene(32, Map::kObject, m)));
  };
  const auto tangent = [&](const Mat4& m) {
    return picture(draw_exact, with({}), build_frame(with({}), patch_scene(32, Map::kSurface, m)));
  };
  const Mat4 turned = rotation({1, 2, 3}, 0.7);
  EXPECT_GT(psnr(object({}), tangent({})), 50);
  EXPECT_GT(psnr(object(turned), tangent(turned)), 50);
  EXPECT_LT(psnr(object(turned), tangent({})), 30) << "the comparison sees a turn";
}

// The rotated frame keeps angles, so on fine triangles it is Phong shading.
TEST(Rivals, RotatedFrameConvergesToPhong) {
  double last = 0;
  for (int n : {4, 8, 16, 32}) {
    const Config rotated = with({{&Config::datapath, 3}}), phong = with({{&Config::datapath, 0}});
    const Scene scene = patch_scene(n, Map::kNone);
    const double agreement = psnr(picture(draw_exact, rotated, build_frame(rotated, scene)),
                                  picture(draw_exact, phong, build_frame(phong, scene)));
    std::printf("%d x %d: rotated against phong %.2f dB\n", n, n, agreement);
    EXPECT_GT(agreement, last + 3);
    last = agreement;
  }
}

// [Peercy97 section 4]: R.E and N.H are different lights; either converges to its own ideal.
TEST(Rivals, OtherIlluminationsConvergeToTheirIdeal) {
  for (int lighting : {2, 3}) {
    const Config config = with({{&Config::lighting, lighting}, {&Config::datapath, 2}});
    const double coarse = measure("coarse", config, patch_scene(4, Map::kSurface)).method;
    EXPECT_GT(measure("fine", config, patch_scene(32, Map::kSurface)).method, std::max(coarse + 12, 55.0));
  }
}

// The draw packet cannot hold L and H where they are not constant: with a local light, or in tangent space.
TEST(Rivals, ConstantVectorsAreRefusedWhereTheyAreNotConstant) {
  const Config constant = with({{&Config::light_vectors, 1}});
  EXPECT_THROW(build_frame(constant, patch_scene(2, Map::kSurface)), std::invalid_argument);
  Scene local = patch_scene(2, Map::kObject);
  EXPECT_NO_THROW(build_frame(constant, local));
  local.light.at_infinity = false;
  EXPECT_THROW(build_frame(constant, local), std::invalid_argument);
}

// A - fu B - fv C of a vertex is N' of Eq. 1-2 under any matrix. Where the matrix mirrors, it points outwards all the
// same.
TEST(Rivals, CrossVectorsAreBlinns) {
  Random random(5);
  for (int i = 0; i < 10000; ++i) {
    Vertex vertex;
    vertex.Pu = random.unit_vector(), vertex.Pv = random.real(0.3, 3) * random.unit_vector();
    if (length(cross(vertex.Pu, vertex.Pv)) < 0.05) continue;
    vertex.N = normalize(cross(vertex.Pu, vertex.Pv)), vertex.T = normalize(vertex.Pu);
    const bool mirrored = i % 2 == 1;
    const Mat4 m = rotation(random.unit_vector(), random.real(0, 6)) * scaling({mirrored ? -1.5 : 1.5, 0.7, 2});
    const TangentFrame frame = tangent_frame(vertex, m);
    const double fu = random.real(-1, 1), fv = random.real(-1, 1);
    const Vec3 Pu = transform_direction(m, vertex.Pu), Pv = transform_direction(m, vertex.Pv);
    const FrameVectors v = Blinn::vertex({frame.N, frame.T, frame.B, Pu, Pv, true, 1});
    const Vec3 got = normalize(v[0] - fu * v[1] - fv * v[2]);
    const Vec3 want = mirrored ? -perturbed_normal_blinn(Pu, Pv, -fu, -fv) : perturbed_normal_blinn(Pu, Pv, fu, fv);
    ASSERT_LT(length(got - want), 1e-12);
    ASSERT_GT(dot(v[0], frame.N), 0);
  }
}

// 56: |Pu|, |Pv| from 2^-12 to 2^12 in one draw, Pu nearly along Pv: with an exponent a triangle each triangle keeps
// its precision, and nothing wraps.
TEST(Rivals, BlockExponentOfATriangleKeepsEveryScale) {
  Random random(56);
  const Config config = with({{&Config::datapath, 2}});
  DrawState state;
  state.bump = state.textured = true;
  Texture texture;
  texture.components = 2;
  texture.levels = {{192 | 64 << 8}};  // fu = 1/2, fv = -1/2
  double worst = 0;
  for (int i = 0; i < 400; ++i) {
    const double scale = std::exp2(random.real(-24, 24));
    ScreenTriangle triangle = test::triangle({0, 0}, {9000, 0}, {0, 9000});
    for (ScreenVertex& v : triangle.v) {
      v.frame[0] = scale * random.unit_vector();
      const double others = scale * std::exp2(random.real(-6, 0));
      v.frame[1] = others * random.unit_vector(), v.frame[2] = others * random.unit_vector();
    }
    Frame frame;
    frame.width = frame.height = 64;
    frame.textures = {texture};
    frame.draws = {{state, {triangle}}};
    const auto sink = [&](const auto& batch) {
      for (std::size_t p = 0; p < static_cast<std::size_t>(batch.count); ++p) {
        const auto vector = [&](const auto& columns) {
          return Vec3{double(columns[0][p]), double(columns[1][p]), double(columns[2][p])};
        };
        const double y = double(batch.scan_y[0][p]) + 0.5, x = double(batch.scan_x[0][p]) + 0.5;
        const double wx = x * 256 / 9000, wy = y * 256 / 9000;
        const auto mix = [&](std::size_t k) {
          const auto& v = triangle.v;
          return (1 - wx - wy) * v[0].frame[k] + wx * v[1].frame[k] + wy * v[2].frame[k];
        };
        const Vec3 want = mix(0) - 0.5 * mix(1) + 0.5 * mix(2);
        const Vec3 got = vector(batch.perturb_n);
        if (length(want) < 0.1 * scale) continue;  // terms that cancel have no direction to keep
        worst = std::max(worst, length(normalize(got) - normalize(want)));
      }
    };
    Golden(config, frame.textures).draw(build_packets(config, frame).words, {sink, sink});
  }
  // Components of at least 2^VW / 2 of the largest, three roundings of half an LSB, a tenth of the length left.
  std::printf("direction of N', radians: %.3g\n", worst);
  EXPECT_LT(worst, 10 * 4 * std::ldexp(1.0, -config.wide_bits + 1));
  EXPECT_GT(worst, 0);
}

// 57: with D = 0 N' is Pu x Pv, with a D much larger than Pu x Pv it is D, and between them its direction is
// continuous.
TEST(Rivals, BumpsFromNothingToAll) {
  const Config config = with({{&Config::datapath, 2}, {&Config::gradient_bits, 12}});
  DrawState state;
  state.bump = state.textured = true;
  Vec3 last{0, 0, 1};
  for (int code = 128; code < 256; ++code) {
    Texture texture;
    texture.components = 2;
    texture.levels = {{static_cast<std::uint64_t>(code) | 128 << 8}};
    ScreenTriangle triangle = test::triangle({0, 0}, {500, 0}, {0, 500});
    for (ScreenVertex& v : triangle.v) v.frame[0] = {0, 0, 1e-3}, v.frame[1] = {0.9, 0, 0}, v.frame[2] = {0, 0.9, 0};
    Frame frame;
    frame.width = frame.height = 4;
    frame.textures = {texture};
    frame.draws = {{state, {triangle}}};
    Vec3 n;
    const auto sink = [&](const auto& batch) {
      const double one = std::ldexp(1.0, config.unit_bits);
      n = (1 / one) *
          Vec3{double(batch.normalize_n[0][0]), double(batch.normalize_n[1][0]), double(batch.normalize_n[2][0])};
      EXPECT_EQ(batch.normalize_zero[0][0], 0);
    };
    Golden(config, frame.textures).draw(build_packets(config, frame).words, {sink, sink});
    const Vec3 want = normalize(Vec3{-0.9 * (code - 128) / 128, 0, 1e-3});
    EXPECT_LT(length(n - want), 0.02) << code;
    EXPECT_NEAR(length(n), 1, 3 * std::ldexp(1.0, -config.unit_bits));
    last = n;
  }
  EXPECT_LT(last.x, -0.99);
}

}  // namespace
}  // namespace wrinkle

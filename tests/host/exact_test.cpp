#include "golden/exact/exact.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <tuple>

#include "golden/exact/texture.h"
#include "golden/texel/bump.h"
#include "tests/host/packet_walker.h"

namespace wrinkle {
namespace {

using namespace test;

std::vector<ExactFragment> fragments(const Config& config, const Frame& frame, bool ideal = false) {
  std::vector<ExactFragment> all;
  (ideal ? draw_ideal : draw_exact)(config, frame, [&](const ExactFragment& fragment) { all.push_back(fragment); });
  return all;
}

// One texel that holds a normal and a decal.
void add_texture(Frame& frame, Vec3 n, Vec3 decal) {
  frame.textures = one_texture(0, 0);
  ExactTexture texture;
  texture.levels = {
      {{.bump = {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)},
        .colour = {static_cast<float>(decal.x), static_cast<float>(decal.y), static_cast<float>(decal.z)}}}};
  frame.exact_textures = {texture};
}

Frame one_triangle(const DrawState& state) {
  Frame frame;
  frame.width = frame.height = 16;
  frame.draws.resize(1);
  frame.draws[0].state = state;
  frame.draws[0].triangles = {triangle({0, 0}, {4000, 0}, {0, 4000})};
  frame.draws[0].triangles[0].id = 7;
  return frame;
}

TEST(Exact, VisitsThePixelsOfThePackets) {
  Random random(1);
  for (int i = 0; i < 20; ++i) {
    Config config = random.config();
    config.uv_integer_bits = std::max(config.uv_integer_bits, 2), config.uv_bits = std::max(config.uv_bits, 14);
    Frame frame = one_triangle({});
    frame.width = frame.height = config.screen_size() > 64 ? 64 : config.screen_size();
    frame.draws[0].triangles.clear();
    const int size = config.screen_size() << config.subpixel_bits;
    for (std::uint32_t id = 0; id < 40; ++id) {
      const auto coordinate = [&] { return static_cast<int>(random.integer(-size / 4, size)); };
      const int c[6] = {coordinate(), coordinate(), coordinate(), coordinate(), coordinate(), coordinate()};
      ScreenTriangle t = triangle({c[0], c[1]}, {c[2], c[3]}, {c[4], c[5]});
      randomize_attributes(random, t);
      t.id = id;
      frame.draws[0].triangles.push_back(t);
    }
    using Key = std::tuple<std::uint32_t, int, int>;
    std::vector<Key> exact, packets;
    for (const ExactFragment& f : fragments(config, frame)) exact.emplace_back(f.triangle, f.y, f.x);
    const PacketStream stream = build_packets(config, frame);
    for (std::size_t k = 0; k < stream.packet_word.size(); ++k) {
      walk_rows(decode_triangle(config, std::span(stream.words).subspan(stream.packet_word[k])),
                [&](int y, int first, int end) {
                  for (int x = first; x < end; ++x) packets.emplace_back(stream.packet_triangle[k], y, x);
                });
    }
    ASSERT_EQ(exact, packets);
  }
}

TEST(Exact, LightsAsTheFormulaSays) {
  Config config;
  DrawState state;
  state.bump = state.textured = true;
  state.material = {{0.1, 0.1, 0.1}, {0.5, 0.25, 1}, {0.2, 0.2, 0.2}, 4};
  Frame frame = one_triangle(state);
  add_texture(frame, {0, 0, 0.5}, {1, 1, 1});
  for (ScreenVertex& v : frame.draws[0].triangles[0].v)
    v.L = {0.6, 0, 0.8}, v.H = normalize(Vec3{0.3, 0, 0.9}), v.N = {1, 0, 0};
  ExactFragment f = fragments(config, frame).at(3);
  EXPECT_EQ(f.triangle, 7u);
  EXPECT_EQ(f.n, (Vec3{0, 0, 1})) << "the texture's normal, normalized";
  EXPECT_NEAR(f.nl, 0.8, 1e-15);
  EXPECT_NEAR(f.specular, 0.81, 1e-12);  // (0.9^2 / 0.9)^4
  EXPECT_NEAR(f.colour.x, 0.1 + 0.5 * 0.8 + 0.2 * 0.81, 1e-12);
  EXPECT_NEAR(f.colour.z, 1, 1e-15) << "saturated";

  config.normalizer_n = 0;
  EXPECT_NEAR(fragments(config, frame).at(3).nl, 0.4, 1e-15);
  config.normalizer_n = 1;
  config.decal = 1;
  add_texture(frame, {0, 0, 1}, {0.5, 0.5, 0.5});
  EXPECT_NEAR(fragments(config, frame).at(3).colour.x, (0.1 + 0.5 * 0.8) * 0.5 + 0.2 * 0.81, 1e-12);
  config.gloss_map = 1;
  frame.exact_textures[0].levels[0][0].gloss = 0.25F;
  const ExactFragment glossed = fragments(config, frame).at(3);
  EXPECT_NEAR(glossed.specular, 0.81, 1e-12);
  EXPECT_NEAR(glossed.gloss, 0.25, 1e-12);
  EXPECT_NEAR(glossed.colour.x, (0.1 + 0.5 * 0.8) * 0.5 + 0.25 * 0.2 * 0.81, 1e-12);
  config.gloss_map = 0;
  EXPECT_EQ(fragments(config, frame).at(3).gloss, 1);
  frame.draws[0].state.bump = false;
  EXPECT_NEAR(fragments(config, frame).at(3).nl, 0.6, 1e-15) << "the interpolated normal";
  frame.draws[0].state.material.exponent = 0;
  EXPECT_EQ(fragments(config, frame).at(3).specular, 1);
  config.lighting = 0;
  EXPECT_EQ(fragments(config, frame).at(3).specular, 0);
}

TEST(Exact, ShadowsItself) {
  Config config;
  DrawState state;
  state.bump = state.textured = state.shadow = true;
  Frame frame = one_triangle(state);
  add_texture(frame, {0.6, 0, 0.8}, {1, 1, 1});
  const auto diffuse = [&](double lz) {
    for (ScreenVertex& v : frame.draws[0].triangles[0].v) v.L = {std::sqrt(1 - lz * lz), 0, lz};
    return fragments(config, frame).at(0).diffuse;
  };
  const auto nl = [](double lz) { return 0.6 * std::sqrt(1 - lz * lz) + 0.8 * lz; };
  // To the precision of a float texel.
  config.self_shadow = 1;
  EXPECT_EQ(diffuse(-0.05), 0);
  EXPECT_NEAR(diffuse(0.05), nl(0.05), 1e-7);
  config.self_shadow = 2;
  EXPECT_EQ(diffuse(-0.05), 0);
  EXPECT_NEAR(diffuse(0.05), nl(0.05) * 0.4, 1e-7);
  EXPECT_NEAR(diffuse(0.3), nl(0.3), 1e-7);
  config.self_shadow = 0;
  EXPECT_NEAR(diffuse(-0.05), nl(-0.05), 1e-7);
}

// A bump faces away from the light, but its surface does not: there is no highlight.
TEST(Exact, WithoutDiffuseLightThereIsNoHighlight) {
  Config config;
  DrawState state;
  state.bump = state.textured = state.shadow = true;
  Frame frame = one_triangle(state);
  add_texture(frame, {-0.8, 0, 0.6}, {1, 1, 1});
  for (ScreenVertex& v : frame.draws[0].triangles[0].v) v.L = {0.8, 0, 0.6}, v.H = {0, 0, 1};
  const ExactFragment f = fragments(config, frame).at(0);
  EXPECT_EQ(f.nl, 0);
  EXPECT_GT(f.nh, 0.5);
  EXPECT_EQ(f.specular, 0);
  frame.draws[0].state.shadow = false;
  EXPECT_GT(fragments(config, frame).at(0).specular, 0);
}

TEST(Extremes, E19_OpposedVectorsMeetInZero) {
  Frame frame = one_triangle({});
  frame.draws[0].triangles[0] = triangle({128, 128}, {128 + 2 * 256, 128}, {128, 3000});
  auto& v = frame.draws[0].triangles[0].v;
  v[0].N = {1, 0, 0}, v[1].N = {-1, 0, 0}, v[2].N = {0, 1, 0};
  for (const ExactFragment& f : fragments(Config{}, frame)) {
    if (f.x != 1 || f.y != 0) continue;
    EXPECT_EQ(f.frame[0], Vec3{});
    EXPECT_EQ(f.n, Vec3{});
    EXPECT_EQ(f.nl, 0);
  }
}

TEST(Exact, DividesByThePerspective) {
  Config config;
  config.perspective = 1;
  DrawState state;
  state.bump = state.textured = true;
  Frame frame = one_triangle(state);
  add_texture(frame, {0, 0, 1}, {1, 1, 1});
  auto& v = frame.draws[0].triangles[0].v;
  v[0].q = 1, v[1].q = 0.25, v[2].q = 0.5;
  v[0].uv = {0, 0}, v[1].uv = {1, 0}, v[2].uv = {0, 1};
  for (const ExactFragment& f : fragments(config, frame)) {
    const double b1 = (f.x + 0.5) * 256 / 4000, b2 = (f.y + 0.5) * 256 / 4000;
    const double q = (1 - b1 - b2) + 0.25 * b1 + 0.5 * b2;
    EXPECT_NEAR(f.u, 0.25 * b1 / q, 1e-12);
    EXPECT_NEAR(f.v, 0.5 * b2 / q, 1e-12);
  }
}

// The OpenGL rule in double, with one channel of 8 bits: see the file.
TEST(Exact, EqualsTheTrilinearVectors) {
  const std::string path = std::string(WRINKLE_SHARED_DIR) + "/assets/vectors/trilinear_32x32.txt";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  ExactTexture texture;
  texture.log2_width = texture.log2_height = 5;
  double worst = 0;
  int samples = 0;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    if (line.starts_with("#")) continue;
    if (line.starts_with("M")) {
      texture.levels.emplace_back();
    } else if (line.starts_with("S")) {
      std::string tag;
      int mode, u, v, lod;
      double expected;
      words >> tag >> mode >> u >> v >> lod >> expected;
      DrawWords draw;
      draw.wrap_u = draw.wrap_v = mode;
      const double value =
          exact::sample(exact::filtering(Config{}, draw), texture, {u / 4096.0, v / 4096.0}, lod / 256.0).bump[0];
      worst = std::max(worst, std::abs(value - expected));
      ++samples;
    } else {
      for (std::size_t i = 0; i + 1 < line.size(); i += 2) {
        texture.levels.back().push_back({static_cast<float>(std::stoi(line.substr(i, 2), nullptr, 16))});
      }
    }
  }
  EXPECT_EQ(samples, 4500);
  EXPECT_LT(worst, 1e-4);
}

// A skewed parallelogram in space, with a height field of constant slope.
class Plane : public Surface {
 public:
  SurfacePoint at(double u, double v) const override {
    return {origin + u * Pu + v * Pv, Pu, Pv, normalize(cross(Pu, Pv))};
  }
  Vec3 origin{-1, -1, 0}, Pu{2, 0.5, 0.25}, Pv{-0.25, 2, 0.5};
};
class Slope : public HeightField {
 public:
  Vec2 gradient(double u, double v) const override { return {0.3 + u, -0.2 + v}; }
};

TEST(Ideal, FollowsEquationsOneAndTwo) {
  Config config;
  DrawState state;
  state.bump = state.textured = true;
  Frame frame = one_triangle(state);
  add_texture(frame, {0, 0, 1}, {1, 1, 1});
  auto& t = frame.draws[0].triangles[0];
  const auto plane = std::make_shared<Plane>();
  t.surface = plane;
  t.v[0].q = 1, t.v[1].q = 0.25, t.v[2].q = 0.5;
  t.v[1].parameter = {1, 0}, t.v[2].parameter = {0, 1};
  frame.ideal.draws = {{std::make_shared<Slope>(), nullptr, true}};
  frame.ideal.eye = {0, 0, 5}, frame.ideal.eye_at_infinity = false;
  frame.ideal.light = {3, 1, 4}, frame.ideal.light_at_infinity = false;
  const auto all = fragments(config, frame, true);
  ASSERT_GT(all.size(), 50u);
  for (const ExactFragment& f : all) {
    const double b1 = (f.x + 0.5) * 256 / 4000, b2 = (f.y + 0.5) * 256 / 4000;
    const double q = (1 - b1 - b2) + 0.25 * b1 + 0.5 * b2, u = 0.25 * b1 / q, v = 0.5 * b2 / q;
    const Vec3 P = plane->at(u, v).P;
    const Vec3 L = normalize(Vec3{3, 1, 4} - P), H = normalize(L + normalize(Vec3{0, 0, 5} - P));
    const Vec3 N = perturbed_normal_blinn(plane->Pu, plane->Pv, 0.3 + u, -0.2 + v);
    EXPECT_NEAR(f.nl, std::max(dot(N, L), 0.0), 1e-12);
    EXPECT_NEAR(f.nh, std::max(dot(N, H), 0.0), 1e-12);
  }
  // The normal is smooth where there is no height field, and where the draw is not bump mapped.
  frame.ideal.draws = {{}};
  EXPECT_NEAR(length(fragments(config, frame, true).at(0).n - plane->at(0, 0).N), 0, 1e-15);
  frame.ideal.draws = {{std::make_shared<Slope>(), nullptr, false}};
  EXPECT_NEAR(length(fragments(config, frame, true).at(0).n - plane->at(0, 0).N), 0, 1e-15);
}

}  // namespace
}  // namespace wrinkle

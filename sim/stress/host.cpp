// Entries 29 to 31 and 48: what the host must get right before anything is a packet.
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

#include "golden/texel/bump.h"
#include "golden/vertex/scene.h"
#include "golden/vertex/tangents.h"
#include "sim/input_error.h"
#include "sim/scene/scene_reader.h"
#include "sim/stress/catalogue.h"

namespace wrinkle {
namespace {

constexpr int kSide = 64;

std::shared_ptr<const ExactTexture> bumpy_texture() {
  auto texture = std::make_shared<ExactTexture>();
  texture->log2_width = texture->log2_height = 4;
  auto& texels = texture->levels.emplace_back();
  for (int i = 0; i < 256; ++i) {
    const Vec3 n = normalize(Vec3{std::sin(i * 1.7), std::cos(i * 2.3), 1.5});
    texels.push_back({.bump = {float(n.x), float(n.y), float(n.z)}});
  }
  return texture;
}

// A square that fills the picture; `mirrored` has x turned round, with its light, and the same texture coordinates.
Scene square(bool mirrored) {
  const double sign = mirrored ? -1 : 1;
  Scene scene;
  scene.width = scene.height = kSide;
  scene.camera.world_to_eye(2, 3) = -1;
  scene.light.position = {sign * 0.5, 0.25, 1};
  Object object;
  object.space = ShadingSpace::kTangent;
  object.texture = bumpy_texture();
  for (auto [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
    object.mesh.vertices.push_back({.P = {sign * x, double(y), 0},
                                    .N = {0, 0, 1},
                                    .T = {sign, 0, 0},
                                    .sign = sign,
                                    .uv = {(x + 1) / 2.0, (1 - y) / 2.0}});
  object.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  if (mirrored)
    for (auto& t : object.mesh.triangles) std::swap(t[1], t[2]);
  scene.objects.push_back(object);
  return scene;
}

Stimulus stimulus_of(const Config& config, const Scene& scene) {
  const Frame frame = build_frame(config, scene);
  Stimulus stimulus(config);
  for (const Texture& texture : frame.textures) stimulus.add_texture(texture);
  for (const Draw& draw : frame.draws) {
    stimulus.add_draw(draw.state);
    for (const ScreenTriangle& t : draw.triangles) stimulus.add(t, frame.width, frame.height);
  }
  return stimulus;
}

// B = sign (N x T). With the right sign the mirrored square is the mirror image of the other, code for code.
Extreme mirrored_frame(const Config& config) {
  Extreme extreme;
  extreme.unit = "colour codes";
  std::map<std::pair<std::int64_t, std::int64_t>, FragmentValues> left;
  for (bool mirrored : {false, true}) {
    Stimulus stimulus = stimulus_of(config, square(mirrored));
    const std::size_t colour = stimulus.index("output", "colour");
    const auto fragments = stimulus.golden();
    extreme.measure(std::abs(double(fragments.size()) - kSide * kSide), "number of fragments");
    for (const FragmentValues& f : fragments) {
      const std::int64_t x = f[stimulus.index("scan", "x")][0], y = f[stimulus.index("scan", "y")][0];
      if (!mirrored) {
        left[{x, y}] = f;
        continue;
      }
      const auto other = left.find({kSide - 1 - x, y});
      for (std::size_t c = 0; c < std::size_t(Shape(config).count); ++c)
        extreme.measure(other == left.end() ? 1e9 : double(std::abs(f[colour][c] - other->second[colour][c])),
                        fmt::format("pixel {}, {}", x, y));
    }
    extreme.stimuli.push_back(std::move(stimulus));
  }
  return extreme;
}

// Texture coordinates that give no direction: the tangents are finite unit vectors at right angles to the normal, or
// the (1, 0, 0) that stands for none.
Extreme degenerate_uv(const Config&) {
  Extreme extreme;
  extreme.unit = "of 1";
  extreme.bound = 1e-6;
  const Vec3 N{0, 0, 1}, P[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (const auto& uv :
       {std::array<Vec2, 3>{}, std::array<Vec2, 3>{{{0, 0}, {1, 1}, {2, 2}}},
        std::array<Vec2, 3>{{{0.5, 0.5}, {0.5, 0.5}, {1, 0}}}, std::array<Vec2, 3>{{{0, 0}, {1e-30, 0}, {0, 1e-30}}}}) {
    const std::vector<TangentCorner> corners{{P[0], N, uv[0]}, {P[1], N, uv[1]}, {P[2], N, uv[2]}};
    for (const Tangent& tangent : generate_tangents(corners)) {
      const std::string where = fmt::format("uv ({}, {}) ({}, {})", uv[0].x, uv[0].y, uv[1].x, uv[1].y);
      extreme.measure(std::abs(length(tangent.T) - 1), where);
      extreme.measure(std::abs(dot(tangent.T, N)), where);
      extreme.measure(std::abs(std::abs(tangent.sign) - 1), where);
    }
  }
  return extreme;
}

// With |Pu| : |Pv| = 10^6 and 10^-6 the three coefficients still are a unit vector, Blinn's normal in tangent space.
Extreme stretched(const Config&) {
  Extreme extreme;
  extreme.unit = "of 1";
  extreme.bound = 1e-9;
  for (double ratio : {1e-6, 1e-3, 1.0, 1e3, 1e6})
    for (double scale : {1e-6, 1.0, 1e6})
      for (double f : {-2.0, 0.0, 0.7})
        for (double skew : {0.0, 0.5}) {
          const Vec3 Pu{scale * ratio, 0, 0}, Pv{skew * scale, scale, 0};
          const double fu = f * scale * std::min(ratio, 1.0), fv = 0.3 * scale * std::min(ratio, 1.0);
          const Vec3 tangent = tangent_space_normal(Pu, Pv, fu, fv), blinn = perturbed_normal_blinn(Pu, Pv, fu, fv);
          const std::string where = fmt::format("ratio {} scale {}", ratio, scale);
          extreme.measure(std::abs(length(tangent) - 1), where);
          // T, B and N are the axes of this surface.
          extreme.measure(length(tangent - blinn), where);
        }
  return extreme;
}

// Numbers that are not finite, or larger than in any scene, are refused before anything is drawn; the message says
// where.
Extreme hostile_numbers(const Config&) {
  Extreme extreme;
  extreme.unit = "files";
  const auto path = std::filesystem::temp_directory_path() / fmt::format("wrinkle_extreme_{}.toml", getpid());
  for (const char* number : {"nan", "+inf", "-inf", "1e38", "-1e38", "\"1\""}) {
    std::ofstream(path) << "name = \"hostile\"\nsize = [16, 16]\n[light]\ndirection = [0.0, " << number
                        << ", 1.0]\n[[objects]]\nmesh = \"floor\"\n";
    bool refused = false;
    try {
      read_scene(path);
    } catch (const InputError& error) {
      refused = std::string(error.what()).find(path.filename().string() + ":4") != std::string::npos;
    }
    extreme.measure(refused ? 0 : 1, number);
  }
  std::filesystem::remove(path);
  return extreme;
}

}  // namespace

std::vector<ExtremeEntry> host_extremes() {
  return {{29, "mirrored tangent frame", "", mirrored_frame},
          {30, "degenerate texture coordinates", "", degenerate_uv},
          {31, "|Pu| : |Pv| = 10^6", "", stretched},
          {48, "NaN, infinities, 1e38 in a scene file", "", hostile_numbers}};
}

}  // namespace wrinkle

#include "sim/losses.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "golden/triangle/packet.h"
#include "golden/vertex/camera.h"
#include "golden/vertex/transform.h"
#include "sim/input_error.h"

namespace wrinkle {
namespace {

bool is_grey(Vec3 c) { return c.x == c.y && c.y == c.z; }

// Whether the texture has base colours: its mean, the last level, is not white.
bool has_decal(const Object& object) {
  if (!object.texture) return false;
  const auto& mean = object.texture->levels.back()[0];
  return mean.colour != std::array<float, 3>{1, 1, 1};
}

bool has_gloss(const Object& object) { return object.texture && object.texture->levels.back()[0].gloss != 1; }

int largest_exponent(const Scene& scene) {
  int largest = 0;
  for (const Object& object : scene.objects) {
    if (object.material.specular != Vec3{}) largest = std::max(largest, object.material.exponent);
  }
  return largest;
}

// Where one triangle of a scene is.
enum class Fate { kSeen, kAway, kBehind, kTooNear, kTooFar, kOutside };

Fate fate_of(const std::array<ScreenPoint, 3>& p, bool back, bool both_sides, const Scene& scene) {
  const auto all = [&](auto condition) { return std::ranges::all_of(p, condition); };
  if (all([](const ScreenPoint& q) { return q.w <= 0; })) return Fate::kBehind;
  if (all([](const ScreenPoint& q) { return q.z < 0; })) return Fate::kTooNear;
  if (all([](const ScreenPoint& q) { return q.z > q.w; })) return Fate::kTooFar;
  if (all([](const ScreenPoint& q) { return q.x < 0; }) || all([](const ScreenPoint& q) { return q.y < 0; }) ||
      all([&](const ScreenPoint& q) { return q.x > scene.width * q.w; }) ||
      all([&](const ScreenPoint& q) { return q.y > scene.height * q.w; })) {
    return Fate::kOutside;
  }
  return back && !both_sides ? Fate::kAway : Fate::kSeen;
}

}  // namespace

std::vector<std::string> losses(const Config& config, const Scene& scene) {
  std::vector<std::string> list;
  const Shape shape(config);
  const auto any = [&](auto condition) { return std::ranges::any_of(scene.objects, condition); };
  if (shape.bump_components == 0 && any([](const Object& o) { return o.texture && o.space != ShadingSpace::kWorld; })) {
    list.push_back("bumps are not drawn (datapath has none)");
  }
  if (config.decal == 0 && any(has_decal)) list.push_back("base colour textures are not drawn (decal = off)");
  if (config.gloss_map == 0 && any(has_gloss)) list.push_back("gloss maps are not drawn (gloss_map = off)");
  if (config.perspective == 0 && scene.camera.perspective) {
    list.push_back("texture coordinates are not corrected for perspective (perspective = off)");
  }
  const int exponent = largest_exponent(scene);
  if (shape.glossy == 0 && exponent > 0) list.push_back("highlights are not drawn (lighting = diffuse)");
  if (shape.glossy != 0 && exponent > 1 << config.specular_squarings) {
    list.push_back(fmt::format("exponent {} is drawn as {} = 2^specular_squarings ({})", exponent,
                               1 << config.specular_squarings, config.specular_squarings));
  }
  if (config.channels == 0 && any([](const Object& o) {
        return !is_grey(o.material.ambient) || !is_grey(o.material.diffuse) || !is_grey(o.material.specular);
      })) {
    list.push_back("colours are drawn as grey (channels = one)");
  }
  if (config.depth == 0 && scene.objects.size() > 1) {
    list.push_back("what is behind is not hidden (depth = off): later objects cover earlier ones");
  }
  return list;
}

std::string why_empty(const Scene& scene) {
  const Projection projection(scene.camera, scene.width, scene.height);
  std::array<std::size_t, 6> count{};
  std::size_t triangles = 0;
  for (const Object& object : scene.objects) {
    const bool mirrored = determinant3(object.to_world) < 0;
    for (const auto& t : object.mesh.triangles) {
      std::array<ScreenPoint, 3> p;
      for (std::size_t i = 0; i < 3; ++i) {
        p[i] = projection(transform_point(object.to_world, object.mesh.vertices[t[i]].P));
      }
      const double turn =
          dot(Vec3{p[0].x, p[0].y, p[0].w}, cross(Vec3{p[1].x, p[1].y, p[1].w}, Vec3{p[2].x, p[2].y, p[2].w}));
      ++count[static_cast<std::size_t>(fate_of(p, (turn > 0) != mirrored, object.double_sided, scene))];
      ++triangles;
    }
  }
  const char* kWhy[] = {"too small to cover the middle of a pixel",
                        "seen from behind (double_sided would show them)",
                        "behind the eye",
                        "nearer than the near plane",
                        "beyond the far plane",
                        "outside of the picture"};
  std::string text = fmt::format("nothing was drawn: of {} triangles", triangles);
  for (std::size_t i = 0; i < count.size(); ++i) {
    if (count[i] > 0) text += fmt::format("{} {} are {}", text.ends_with("triangles") ? "" : ",", count[i], kWhy[i]);
  }
  return text;
}

void with_objects_named(const Config& config, const Scene& scene, const Frame& frame,
                        const std::function<void()>& draw) {
  std::string cause;
  try {
    draw();
    return;
  } catch (const std::range_error& error) {
    cause = error.what();
  } catch (const std::invalid_argument& error) {
    cause = error.what();
  }
  // The first object whose packets cannot be made is the one.
  for (std::size_t i = 0; i < frame.draws.size() && i < scene.objects.size(); ++i) {
    Frame one = frame;
    one.draws = {frame.draws[i]};
    try {
      build_packets(config, one);
    } catch (const std::exception&) {
      const bool uv = cause.find("uv_integer_bits") != std::string::npos;
      const std::string& name = scene.objects[i].name;
      const std::string which = name.empty() ? "number " + std::to_string(i + 1) : "\"" + name + "\"";
      throw InputError(Place{scene.name, 0, 0, "object " + which},
                       cause + (uv ? "; raise it with --set uv_integer_bits=N, N up to 10, or divide the triangles of "
                                     "the mesh"
                                   : ""));
    }
  }
  throw InputError(Place{scene.name}, cause);
}

}  // namespace wrinkle

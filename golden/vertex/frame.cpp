// The vertex rate: a scene becomes a frame of projected triangles.
#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "golden/datapath/datapaths.h"
#include "golden/texel/quantise.h"
#include "golden/vertex/camera.h"
#include "golden/vertex/clip.h"
#include "golden/vertex/scene.h"
#include "golden/vertex/shading.h"
#include "golden/vertex/surfaces.h"
#include "golden/vertex/transform.h"

namespace wrinkle {
namespace {

// What set-up accepts [packet.h], whole pixels.
GuardBand guard_band(const Shape& config) {
  const double screen = config.screen_size();
  return {-screen, 2 * screen - 1};
}

// Twice the signed area on the homogeneous screen, times the w's; negative for counter-clockwise, y being down. Right
// also where corners lie behind the eye.
double orientation(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c) {
  return dot(Vec3{a.x, a.y, a.w}, cross(Vec3{b.x, b.y, b.w}, Vec3{c.x, c.y, c.w}));
}

std::int64_t orientation(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c) {
  return std::int64_t{b.x - a.x} * (c.y - a.y) - std::int64_t{c.x - a.x} * (b.y - a.y);
}

// The analytic surfaces of one object in the world, and their backs.
class WorldSurfaces {
 public:
  explicit WorldSurfaces(const Object& object) : triangle_surface_(object.mesh.triangle_surface) {
    for (const auto& surface : object.mesh.surfaces) {
      front_.push_back(transformed(surface, object.to_world));
      back_.push_back(object.double_sided ? reversed(front_.back()) : nullptr);
    }
  }
  std::shared_ptr<const Surface> of(std::size_t triangle, bool back) const {
    if (triangle_surface_.empty()) return nullptr;
    return (back ? back_ : front_)[triangle_surface_[triangle]];
  }

 private:
  const std::vector<std::uint32_t>& triangle_surface_;
  std::vector<std::shared_ptr<const Surface>> front_, back_;
};

// A height field seen in a mirror: up is along Pu x Pv no more, but against it.
class MirroredHeight : public HeightField {
 public:
  explicit MirroredHeight(std::shared_ptr<const HeightField> height) : height_(std::move(height)) {}
  Vec2 gradient(double u, double v) const override { return -1.0 * height_->gradient(u, v); }

 private:
  std::shared_ptr<const HeightField> height_;
};

// Whether fu and fv of its map are by the parameters of its surface; else they are by lengths along T and B.
bool has_derivatives(const Object& object) { return object.heights && !object.mesh.surfaces.empty(); }

bool is_bumped(const Object& object) { return object.space != ShadingSpace::kWorld && object.texture; }
bool is_bumped_in_object_space(const Object& object) {
  return is_bumped(object) && object.space == ShadingSpace::kObject;
}

// The axes of object space in the world, where the matrix scales all directions alike.
TangentFrame object_axes(const Mat4& to_world) {
  const auto axis = [&](Vec3 v) { return normalize(transform_direction(to_world, v)); };
  return {axis({1, 0, 0}), axis({0, 1, 0}), axis({0, 0, 1})};
}

IdealDraw ideal_draw(const Object& object, bool mirrored) {
  IdealDraw draw{object.height, object.texture, is_bumped(object), is_bumped_in_object_space(object)};
  if (mirrored && object.height) draw.height = std::make_shared<MirroredHeight>(object.height);
  return draw;
}

// What the vertex rate asks of the datapath, besides its vertices.
struct DatapathRules {
  DrawSpace space;
  bool turns_light, texels_from_heights;
};
DatapathRules rules_of(const Config& config) {
  return with_datapath(config, [](const auto& said) {
    using Datapath = std::decay_t<decltype(said)>;
    return DatapathRules{Datapath::kSpace, Datapath::kTurnsLight, Datapath::kTexelsFromHeights};
  });
}

// The space that a draw lights in. N of the rotated frame is its z.
ShadingSpace space_of(DrawSpace space, const Object& object, bool is_bumped) {
  if (space == DrawSpace::kTangent) return ShadingSpace::kTangent;
  return space == DrawSpace::kOfTexture && is_bumped ? object.space : ShadingSpace::kWorld;
}

// All times a power of two that brings the largest component of the draw into [1/2, 1).
void scale_to_block(std::vector<ClipVertex>& vertices) {
  double largest = 0;
  for (const ClipVertex& v : vertices) {
    for (const Vec3& w : v.frame) largest = std::max({largest, std::abs(w.x), std::abs(w.y), std::abs(w.z)});
  }
  if (largest == 0) return;
  int exponent = 0;
  std::frexp(largest, &exponent);
  const double scale = std::ldexp(1, -exponent);
  for (ClipVertex& v : vertices) {
    for (Vec3& w : v.frame) w = scale * w;
  }
}

// How a triangle is seen.
struct Facing {
  bool clockwise = false;  // on the screen
  bool back = false;       // and so from behind
};

class FrameBuilder {
 public:
  FrameBuilder(const Shape& config, const Scene& scene)
      : config_(config),
        scene_(scene),
        projection_(scene.camera, scene.width, scene.height),
        illumination_(scene),
        band_(guard_band(config)) {}

  Frame build() {
    frame_.name = scene_.name;
    frame_.width = scene_.width;
    frame_.height = scene_.height;
    frame_.background = {scene_.background.x, scene_.background.y, scene_.background.z};
    frame_.ideal.eye = illumination_.eye();
    frame_.ideal.eye_at_infinity = scene_.viewer_at_infinity;
    frame_.ideal.light = illumination_.light();
    frame_.ideal.light_at_infinity = scene_.light.at_infinity;
    for (const Object& object : scene_.objects) add(object);
    return std::move(frame_);
  }

 private:
  void add(const Object& object);
  DrawState state_of(const Object& object);
  void hold_light(const Object& object, DrawState& state) const;
  int map_of(const Object& object);
  std::vector<ClipVertex> shade(const Object& object, const DrawState& state) const;
  void light(const Object& object, const TangentFrame& frame, const DrawState& state, ClipVertex& v) const;
  FrameVectors prepare(const Object& object, const Vertex& vertex, const TangentFrame& frame, double bump_scale) const;
  void add_triangle(const std::array<const ClipVertex*, 3>& corners, Facing facing, const ScreenTriangle& blank,
                    Draw& draw) const;
  ScreenVertex snap(const ClipVertex& vertex, const DrawState& state, bool back) const;

  const Shape config_;
  const DatapathRules rules_ = rules_of(config_);
  const Scene& scene_;
  Projection projection_;
  Illumination illumination_;
  GuardBand band_;
  Frame frame_;
  std::map<std::pair<std::shared_ptr<const ExactTexture>, std::shared_ptr<const Grid<double>>>, int> map_of_;
  std::uint32_t next_id_ = 0;
};

int FrameBuilder::map_of(const Object& object) {
  const auto heights = rules_.texels_from_heights && has_derivatives(object) ? object.heights : nullptr;
  const auto [entry, is_new] = map_of_.try_emplace({object.texture, heights}, static_cast<int>(frame_.textures.size()));
  if (!is_new) return entry->second;
  const TexelInputs inputs{*object.texture, heights.get(), config_.texel_bits, {object.wrap_u, object.wrap_v}};
  frame_.exact_textures.push_back(
      with_datapath(config_, [&](const auto& said) { return std::decay_t<decltype(said)>::texels(inputs); }));
  frame_.textures.push_back(quantise(frame_.exact_textures.back(), config_));
  return entry->second;
}

// Without a texture (or a datapath) there is nothing to perturb the normal with: the object is lit in world space.
DrawState FrameBuilder::state_of(const Object& object) {
  DrawState state;
  state.bump = config_.bump_components != 0 && is_bumped(object);
  state.textured = state.bump || (config_.tints != 0 && object.texture);
  // The hardware takes L.z for the cosine at the unperturbed surface, which it is in tangent space alone.
  const bool in_object_space = config_.surface_is_z != 0 && state.bump && object.space == ShadingSpace::kObject;
  state.shadow = object.shadow && !in_object_space;
  state.wrap_u = object.wrap_u;
  state.wrap_v = object.wrap_v;
  state.texture = state.textured ? map_of(object) : 0;
  state.material = object.material;
  if (!config_.has_light_planes) hold_light(object, state);
  return state;
}

// L and H as constants of the draw.
void FrameBuilder::hold_light(const Object& object, DrawState& state) const {
  if (!scene_.light.at_infinity || !scene_.viewer_at_infinity)
    throw std::invalid_argument("light_vectors = constant needs light and viewer at infinity");
  const LightVectors light = illumination_.at({});
  const Vec3 third = config_.has_view_vector ? light.E : light.H;
  const ShadingSpace space = space_of(rules_.space, object, state.bump);
  if (space == ShadingSpace::kTangent)
    throw std::invalid_argument("light_vectors = constant cannot light \"" + object.name +
                                "\" in tangent space; space = \"object\" can be");
  if (space == ShadingSpace::kObject && object.double_sided)
    throw std::invalid_argument("light_vectors = constant cannot light both sides of \"" + object.name +
                                "\" in object space");
  const bool turned = space == ShadingSpace::kObject;
  state.L = turned ? to_object_space(object.to_world, light.L) : light.L;
  state.H = turned ? to_object_space(object.to_world, third) : third;
}

// The vectors of one vertex, in the space that the draw lights in.
void FrameBuilder::light(const Object& object, const TangentFrame& frame, const DrawState& state, ClipVertex& v) const {
  const LightVectors light = illumination_.at(v.P);
  const Vec3 third = config_.has_view_vector ? light.E : light.H;
  switch (space_of(rules_.space, object, state.bump)) {
    case ShadingSpace::kWorld:
      v.N = frame.N, v.L = light.L, v.H = third;
      break;
    case ShadingSpace::kTangent:
      v.N = {0, 0, 1}, v.L = to_tangent_space(frame, light.L), v.H = to_tangent_space(frame, third);
      break;
    case ShadingSpace::kObject:
      v.N = to_object_space(object.to_world, frame.N);
      v.L = to_object_space(object.to_world, light.L);
      v.H = to_object_space(object.to_world, third);
      break;
  }
}

// The vectors in the place of N, as the datapath has them at a vertex of a bumped draw.
FrameVectors FrameBuilder::prepare(const Object& object, const Vertex& vertex, const TangentFrame& frame,
                                   double bump_scale) const {
  const VertexInputs inputs{frame.N,
                            frame.T,
                            frame.B,
                            transform_direction(object.to_world, 1 / object.repeat.x * vertex.Pu),
                            transform_direction(object.to_world, 1 / object.repeat.y * vertex.Pv),
                            has_derivatives(object),
                            bump_scale};
  return with_datapath(config_, [&](const auto& datapath) { return datapath.vertex(inputs); });
}

std::vector<ClipVertex> FrameBuilder::shade(const Object& object, const DrawState& state) const {
  const bool prepares = config_.frame_prepared != 0 && state.bump;
  const double bump_scale = prepares ? frame_.exact_textures[static_cast<std::size_t>(state.texture)].bump_scale : 1;
  std::vector<ClipVertex> vertices;
  vertices.reserve(object.mesh.vertices.size());
  for (const Vertex& vertex : object.mesh.vertices) {
    ClipVertex v;
    v.P = transform_point(object.to_world, vertex.P);
    v.screen = projection_(v.P);
    v.uv = vertex.uv;
    v.parameter = vertex.parameter;
    const TangentFrame frame = tangent_frame(vertex, object.to_world);
    light(object, frame, state, v);
    if (prepares) v.frame = prepare(object, vertex, frame, bump_scale);
    v.world = is_bumped_in_object_space(object) ? object_axes(object.to_world) : frame;
    vertices.push_back(v);
  }
  if (prepares && config_.frame_unbounded != 0) scale_to_block(vertices);
  return vertices;
}

void FrameBuilder::add(const Object& object) {
  Draw draw;
  draw.state = state_of(object);
  const std::vector<ClipVertex> vertices = shade(object, draw.state);
  const WorldSurfaces surfaces(object);
  // A matrix that mirrors turns all windings round.
  const bool mirrored = determinant3(object.to_world) < 0;
  frame_.ideal.draws.push_back(ideal_draw(object, mirrored));
  for (std::size_t i = 0; i < object.mesh.triangles.size(); ++i) {
    const auto& t = object.mesh.triangles[i];
    const std::array corners{&vertices[t[0]], &vertices[t[1]], &vertices[t[2]]};
    const double turn = orientation(corners[0]->screen, corners[1]->screen, corners[2]->screen);
    const Facing facing{turn > 0, (turn > 0) != mirrored};
    const std::uint32_t id = next_id_++;
    if (turn == 0 || (facing.back && !object.double_sided)) continue;
    ScreenTriangle blank;
    blank.id = id;
    blank.surface = surfaces.of(i, facing.back);
    add_triangle(corners, facing, blank, draw);
  }
  frame_.draws.push_back(std::move(draw));
}

// The parts of the triangle that are left by clipping, as a fan. A part that snapping to the grid has flattened or
// turned over covers nothing that its neighbours do not.
void FrameBuilder::add_triangle(const std::array<const ClipVertex*, 3>& corners, Facing facing,
                                const ScreenTriangle& blank, Draw& draw) const {
  const ClipPolygon polygon = clip(corners, band_);
  if (polygon.count < 3) return;
  const ScreenVertex first = snap(polygon.corner[0], draw.state, facing.back);
  ScreenVertex last = snap(polygon.corner[1], draw.state, facing.back);
  for (int i = 2; i < polygon.count; ++i) {
    const ScreenVertex next = snap(polygon.corner[static_cast<std::size_t>(i)], draw.state, facing.back);
    const std::int64_t turn = orientation(first, last, next);
    if (turn != 0 && (turn > 0) == facing.clockwise) {
      ScreenTriangle& triangle = draw.triangles.emplace_back(blank);
      triangle.v = {first, last, next};
    }
    last = next;
  }
}

// From behind, the whole frame is turned round, as in glTF: the perturbed normal of the back is the opposite of that
// of the front, and what is a bump on one side is a dent on the other. Where the normal comes from a texture, or is
// constant, L and H are turned instead.
ScreenVertex FrameBuilder::snap(const ClipVertex& vertex, const DrawState& state, bool back) const {
  const double grid = std::ldexp(1, config_.subpixel_bits);
  const auto to_grid = [&](double pixels) {
    return static_cast<std::int32_t>(std::floor(std::clamp(pixels, band_.low, band_.high) * grid + 0.5));
  };
  const ScreenPoint& p = vertex.screen;
  const bool turn_light = back && rules_.turns_light && (state.bump || rules_.space == DrawSpace::kTangent);
  const bool turn_normal = back && !turn_light;
  ScreenVertex v;
  v.x = to_grid(p.x / p.w);
  v.y = to_grid(p.y / p.w);
  v.z = std::clamp(p.z / p.w, 0.0, 1.0);
  v.q = 1 / p.w;
  v.uv = vertex.uv;
  v.N = turn_normal ? -vertex.N : vertex.N;
  for (std::size_t i = 0; i < v.frame.size(); ++i) v.frame[i] = turn_normal ? -vertex.frame[i] : vertex.frame[i];
  v.L = turn_light ? -vertex.L : vertex.L;
  v.H = turn_light ? -vertex.H : vertex.H;
  v.parameter = vertex.parameter;
  v.P = vertex.P;
  const double side = back ? -1 : 1;
  v.world = {side * vertex.world.T, side * vertex.world.B, side * vertex.world.N};
  return v;
}

}  // namespace

Frame build_frame(const Shape& config, const Scene& scene) { return FrameBuilder(config, scene).build(); }

}  // namespace wrinkle

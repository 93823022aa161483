// What the host hands to any engine: a frame of draws, in float64 and, quantised, in packet words.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "golden/datapath/datapath.h"
#include "golden/texel/texture.h"
#include "golden/vector.h"
#include "golden/vertex/surface.h"

namespace wrinkle {

// A projected corner. x, y are already on the sub-pixel grid (units of 2^-S pixel, y down); all else is float64.
struct ScreenVertex {
  std::int32_t x = 0, y = 0;
  double z = 0;  // [0, 1]
  double q = 1;  // 1/w up to a factor per triangle
  Vec2 uv;       // repeats; not multiplied by q
  Vec3 N, L, H;  // in the frame the draw lights in, unit length; H is the view vector E where the lighting asks for it
  // The vectors in the place of N, where the datapath prepares them (golden/datapath); where they are unbounded, the
  // largest component of a draw is in [1/2, 1).
  FrameVectors frame{};
  // For the ideal picture: where the corner lies on the analytic surface; its position in the world; and the frame that
  // the normals of the texture are given in, turned round where the triangle is seen from behind.
  Vec2 parameter;
  Vec3 P;
  TangentFrame world;
};

struct ScreenTriangle {
  std::array<ScreenVertex, 3> v;
  std::uint32_t id = 0;                    // of the mesh triangle it came from, counted over the frame
  std::shared_ptr<const Surface> surface;  // analytic surface, or null
};

struct Material {
  Vec3 ambient{0.05, 0.05, 0.05};  // red, green, blue in [0, 1]
  Vec3 diffuse{0.7, 0.7, 0.7};
  Vec3 specular{0.25, 0.25, 0.25};
  int exponent = 16;  // 0 or a power of two
};

// Draw state. Quantised by encode_draw() of packet.h.
struct DrawState {
  bool bump = false;  // N from the texture
  bool textured = false;
  bool shadow = false;
  Wrap wrap_u = Wrap::kRepeat, wrap_v = Wrap::kRepeat;
  int texture = 0;  // index into Frame::textures
  Material material;
  // Constant light vectors, unit length: H is E where the lighting asks for it.
  Vec3 L{0, 0, 1}, H{0, 0, 1};
};

struct Draw {
  DrawState state;
  std::vector<ScreenTriangle> triangles;
};

// A height field on an analytic surface, for the ideal picture: f and its derivatives at any (u, v).
class HeightField {
 public:
  virtual ~HeightField() = default;
  // (f_u, f_v) at (u, v), per unit of the parameter.
  virtual Vec2 gradient(double u, double v) const = 0;
};

// What the scene says of an object, whatever a configuration has of it.
struct IdealDraw {
  std::shared_ptr<const HeightField> height;    // over the analytic surface, or null
  std::shared_ptr<const ExactTexture> texture;  // normals and base colours, or null
  bool bump = false;                            // N from `height` or, without one, from `texture`
  bool in_object_space = false;                 // the normals of `texture`
};

// What `ideal` needs to light a point: everything in world space.
struct IdealScene {
  Vec3 eye;  // position, or direction to the viewer when orthographic
  bool eye_at_infinity = true;
  Vec3 light;  // position, or direction to the light
  bool light_at_infinity = true;
  std::vector<IdealDraw> draws;
};

struct Frame {
  std::string name;
  int width = 0, height = 0;
  std::array<double, 3> background{0, 0, 0};
  std::vector<Draw> draws;
  std::vector<Texture> textures;             // quantised for the configuration
  std::vector<ExactTexture> exact_textures;  // the same chains in float
  IdealScene ideal;
};

}  // namespace wrinkle

// A scene after reading: what the vertex rate works on. Float64 throughout, world space, right-handed, y up.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "golden/config/config.h"
#include "golden/texel/grid.h"
#include "golden/texel/texture.h"
#include "golden/triangle/draw.h"
#include "golden/vector.h"
#include "golden/vertex/mesh.h"

namespace wrinkle {

struct Camera {
  bool perspective = false;
  Mat4 world_to_eye;             // eye looks along -z
  double half_height = 1;        // orthographic: world units; perspective: tangent of half the vertical angle
  double near = 0.1, far = 100;  // distances along -z
};

struct Light {
  Vec3 position{0, 0, 1};  // or the direction towards the light, when at infinity
  bool at_infinity = true;
};

// Which frame N, L and H are interpolated in.
enum class ShadingSpace {
  kWorld,    // N interpolated [Peercy97 fig. 1]
  kTangent,  // L, H in tangent space, N from the texture [Peercy97 fig. 3, eq. 7]
  kObject,   // L, H in object space by one matrix a mesh, N from a texture in object space [Peercy97 section 2.1]
};

struct Object {
  std::string name;
  Mesh mesh;
  Mat4 to_world;
  ShadingSpace space = ShadingSpace::kWorld;
  Material material;
  std::shared_ptr<const ExactTexture> texture;  // normal, decal and gloss, null for none
  std::shared_ptr<const HeightField> height;    // for the ideal picture
  // The field of the bump map over texture coordinates, where there is one, and its repeats over the surface: Blinn's
  // bump mapping takes its slopes.
  std::shared_ptr<const Grid<double>> heights;
  Vec2 repeat{1, 1};
  Wrap wrap_u = Wrap::kRepeat, wrap_v = Wrap::kRepeat;
  bool double_sided = false;
  bool shadow = true;
};

struct Scene {
  std::string name;
  std::string config = "standard";
  int width = 512, height = 512;
  Vec3 background;
  Camera camera;
  Light light;
  bool viewer_at_infinity = true;  // V constant: the direction of the camera's +z
  std::vector<Object> objects;
};

// The vertex rate: transforms, lights, clips to the guard band, culls, projects and snaps. Textures are quantised for
// `config`.
Frame build_frame(const Shape& config, const Scene& scene);

}  // namespace wrinkle

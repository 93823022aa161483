// Clipping of triangles on the homogeneous screen: near, far, and the guard band.
#pragma once

#include <array>

#include "golden/datapath/datapath.h"
#include "golden/vector.h"
#include "golden/vertex/camera.h"
#include "golden/vertex/surface.h"

namespace wrinkle {

// A corner with all that is interpolated along an edge that is cut.
struct ClipVertex {
  ScreenPoint screen;
  Vec2 uv;
  Vec3 N, L, H;
  FrameVectors frame{};
  Vec2 parameter;
  Vec3 P;
  TangentFrame world;
};

// Pixels, both ends included, in x and in y.
struct GuardBand {
  double low = 0, high = 0;
};

// A convex polygon: a triangle and one more corner for each of the six planes.
struct ClipPolygon {
  std::array<ClipVertex, 9> corner;
  int count = 0;
};

// The part of the triangle between the near and far plane and within the guard band, no corner where there is none.
// A triangle wholly inside comes back as it is. A cut edge gives the same new corner whichever of the two triangles
// that share it is clipped.
ClipPolygon clip(const std::array<const ClipVertex*, 3>& triangle, const GuardBand& band);

}  // namespace wrinkle

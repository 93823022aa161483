#include "golden/vertex/clip.h"

namespace wrinkle {
namespace {

constexpr int kPlanes = 6;

// Not negative inside. The near plane comes first: behind it w may be 0 or negative, and nothing else means anything.
double distance(const ScreenPoint& p, int plane, const GuardBand& band) {
  switch (plane) {
    case 0:
      return p.z;
    case 1:
      return p.w - p.z;
    case 2:
      return p.x - band.low * p.w;
    case 3:
      return band.high * p.w - p.x;
    case 4:
      return p.y - band.low * p.w;
    default:
      return band.high * p.w - p.y;
  }
}

// a + t (b - a), with exactly a at t = 0.
double mix(double a, double b, double t) { return a + t * (b - a); }
Vec2 mix(Vec2 a, Vec2 b, double t) { return a + t * (b - a); }
Vec3 mix(Vec3 a, Vec3 b, double t) { return a + t * (b - a); }

ClipVertex mix(const ClipVertex& a, const ClipVertex& b, double t) {
  const ScreenPoint screen{mix(a.screen.x, b.screen.x, t), mix(a.screen.y, b.screen.y, t),
                           mix(a.screen.z, b.screen.z, t), mix(a.screen.w, b.screen.w, t)};
  FrameVectors frame;
  for (std::size_t i = 0; i < frame.size(); ++i) frame[i] = mix(a.frame[i], b.frame[i], t);
  return {screen,
          mix(a.uv, b.uv, t),
          mix(a.N, b.N, t),
          mix(a.L, b.L, t),
          mix(a.H, b.H, t),
          frame,
          mix(a.parameter, b.parameter, t),
          mix(a.P, b.P, t),
          {mix(a.world.T, b.world.T, t), mix(a.world.B, b.world.B, t), mix(a.world.N, b.world.N, t)}};
}

// One plane [Sutherland and Hodgman 1974]; edges are cut from their inner end, whichever way they run.
ClipPolygon clip_by(const ClipPolygon& polygon, int plane, const GuardBand& band) {
  ClipPolygon result;
  const auto add = [&](const ClipVertex& v) { result.corner[static_cast<std::size_t>(result.count++)] = v; };
  for (int i = 0; i < polygon.count; ++i) {
    const ClipVertex& a = polygon.corner[static_cast<std::size_t>(i)];
    const ClipVertex& b = polygon.corner[static_cast<std::size_t>((i + 1) % polygon.count)];
    const double da = distance(a.screen, plane, band), db = distance(b.screen, plane, band);
    if (da >= 0) add(a);
    if (da >= 0 && db < 0) add(mix(a, b, da / (da - db)));
    if (da < 0 && db >= 0) add(mix(b, a, db / (db - da)));
  }
  return result;
}

}  // namespace

ClipPolygon clip(const std::array<const ClipVertex*, 3>& triangle, const GuardBand& band) {
  ClipPolygon polygon;
  for (const ClipVertex* v : triangle) polygon.corner[static_cast<std::size_t>(polygon.count++)] = *v;
  for (int plane = 0; plane < kPlanes; ++plane) {
    int outside = 0;
    for (int i = 0; i < polygon.count; ++i) {
      outside += distance(polygon.corner[static_cast<std::size_t>(i)].screen, plane, band) < 0 ? 1 : 0;
    }
    if (outside == polygon.count) return {};
    if (outside > 0) polygon = clip_by(polygon, plane, band);
  }
  return polygon;
}

}  // namespace wrinkle

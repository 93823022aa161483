// The picture that the method is held against: Eq. 1-2 at every pixel, in world space, with all that the scene says.
#include <algorithm>
#include <cmath>

#include "golden/exact/exact.h"
#include "golden/exact/pipeline.h"
#include "golden/exact/texture.h"
#include "golden/texel/bump.h"
#include "golden/vertex/tessellate.h"

namespace wrinkle {
namespace {

Vec3 towards(Vec3 from, Vec3 place, bool at_infinity) { return normalize(at_infinity ? place : place - from); }

// What a pixel shows of a triangle, as the perspective demands.
struct TruePoint {
  Vec3 P;
  TangentFrame frame;  // orthonormal, and N that of the surface, where the texture is in tangent space
  Vec2 uv;
  double rate = 0;  // of uv: texels of level 0 a pixel, the larger of those along x and along y

  // On the analytic surface, where there is one.
  Vec2 parameter;
  Vec3 Pu, Pv;
  bool is_regular = true;  // Pu and Pv span a plane
};

// Weights of the corners at a pixel, those of the screen times 1/w, which are not divided by their sum.
exact::Weights homogeneous(const Corners& corners, const exact::Weights& screen) {
  exact::Weights weights;
  for (std::size_t i = 0; i < 3; ++i) weights.b[i] = screen.b[i] * corners.v[i]->q;
  return weights;
}

template <class T>
std::array<T, 3> at_corners(const Corners& corners, T ScreenVertex::*member) {
  return {corners.v[0]->*member, corners.v[1]->*member, corners.v[2]->*member};
}

class TriangleTruth {
 public:
  TriangleTruth(const exact::Interpolator& triangle, const IdealDraw& draw)
      : triangle_(&triangle), draw_(&draw), uv_(at_corners(triangle.corners(), &ScreenVertex::uv)) {}

  TruePoint at(int x, int y) const {
    const exact::Weights here = weights(x, y);
    const double per_sum = 1 / sum(here);
    TruePoint point;
    point.uv = per_sum * here.of(uv_);
    point.rate = std::max(rate(here, weights(x + 1, y)), rate(here, weights(x, y + 1)));
    point.P = per_sum * here.of(at_corners(corners(), &ScreenVertex::P));
    point.frame = frame_of_corners(here);
    const Surface* surface = triangle_->triangle().surface.get();
    if (surface != nullptr) {
      point.parameter = per_sum * here.of(at_corners(corners(), &ScreenVertex::parameter));
      put_on(*surface, point);
    }
    return point;
  }

 private:
  const Corners& corners() const { return triangle_->corners(); }
  exact::Weights weights(int x, int y) const { return homogeneous(corners(), triangle_->weights(x, y)); }
  static double sum(const exact::Weights& w) { return w.b[0] + w.b[1] + w.b[2]; }

  // |d(u, v)| from one pixel to the next, of the tangent at the first: uv is U / Q, and both are linear on the screen.
  double rate(const exact::Weights& here, const exact::Weights& next) const {
    if (!draw_->texture) return 0;
    const Vec2 uv = (1 / sum(here)) * here.of(uv_);
    const Vec2 step = (1 / sum(here)) * ((next.of(uv_) - here.of(uv_)) - (sum(next) - sum(here)) * uv);
    return std::hypot(step.x * draw_->texture->width(0), step.y * draw_->texture->height(0));
  }

  // The frame of the corners, interpolated and made orthonormal again. Axes of object space are so already.
  TangentFrame frame_of_corners(const exact::Weights& here) const {
    std::array<TangentFrame, 3> frame = at_corners(corners(), &ScreenVertex::world);
    const auto mean = [&](Vec3 TangentFrame::*axis) {
      return here.of(std::array{frame[0].*axis, frame[1].*axis, frame[2].*axis});
    };
    const Vec3 N = normalize(mean(&TangentFrame::N)), T = perpendicular(N, mean(&TangentFrame::T));
    const Vec3 B = cross(N, T);
    return {T, dot(B, mean(&TangentFrame::B)) < 0 ? -B : B, N};
  }

  // T and B are the columns of [Peercy97 eq. 7].
  void put_on(const Surface& surface, TruePoint& point) const {
    const SurfacePoint on = surface.at(point.parameter.x, point.parameter.y);
    point.P = on.P, point.Pu = on.Pu, point.Pv = on.Pv;
    const Vec3 area = cross(on.Pu, on.Pv);
    point.is_regular = length(area) > 0;
    if (draw_->in_object_space) return;
    const Vec3 T = normalize(on.Pu - dot(on.Pu, on.N) * on.N), B = cross(on.N, T);
    point.frame = {T, dot(on.N, area) < 0 ? -B : B, on.N};
  }

  const exact::Interpolator* triangle_;
  const IdealDraw* draw_;
  std::array<Vec2, 3> uv_;
};

// The unit normal of the point, with the bumps of the height field or, without one, of the normal map.
Vec3 perturbed(const IdealDraw& draw, const TruePoint& point, const exact::Sample& texel) {
  const TangentFrame& frame = point.frame;
  if (!draw.bump || !point.is_regular) return frame.N;
  if (draw.height) {
    const Vec2 slope = draw.height->gradient(point.parameter.x, point.parameter.y);
    const Vec3 n = perturbed_normal_blinn(point.Pu, point.Pv, slope.x, slope.y);
    // The side that is seen may be the one that Pu x Pv points away from.
    return dot(frame.N, cross(point.Pu, point.Pv)) < 0 ? -n : n;
  }
  return normalize(texel.bump[0] * frame.T + texel.bump[1] * frame.B + texel.bump[2] * frame.N);
}

// One draw as the scene has it: what a configuration leaves out of it is part of the method's error.
class IdealShader {
 public:
  IdealShader(const exact::DrawContext& context, const Frame& frame, std::uint32_t index)
      : context_(context), scene_(frame.ideal), draw_(frame.ideal.draws.at(index)), state_(frame.draws[index].state) {
    filter_ = exact::filtering(context.config, context.words);
    filter_.wrap_u = static_cast<int>(state_.wrap_u), filter_.wrap_v = static_cast<int>(state_.wrap_v);
    filter_.bump_components = 3, filter_.colour = filter_.gloss = true;
  }

  void shade(const TruePoint& point, ExactFragment& fragment) const {
    const exact::Sample texel = sample(point, fragment);
    fragment.u = point.uv.x, fragment.v = point.uv.y;
    fragment.n = fragment.perturbed_n = perturbed(draw_, point, texel);
    fragment.frame[0] = point.frame.N;
    fragment.l = fragment.interpolated_l = towards(point.P, scene_.light, scene_.light_at_infinity);
    const Vec3 eye = towards(point.P, scene_.eye, scene_.eye_at_infinity);
    fragment.h = fragment.interpolated_h =
        context_.config.is(Lighting::kReflection) ? eye : normalize(fragment.l + eye);
    light(dot(point.frame.N, fragment.l), fragment);
    const exact::Lit lit{fragment.nl, fragment.nh, fragment.diffuse, fragment.specular};
    const Material& m = state_.material;
    fragment.colour = exact::output({m.ambient, m.diffuse, m.specular}, fragment.decal, fragment.gloss, lit);
  }

 private:
  exact::Sample sample(const TruePoint& point, ExactFragment& fragment) const {
    if (!draw_.texture) return {};
    fragment.lod = point.rate > 0 ? std::log2(point.rate) : 0;
    const exact::Sample texel = exact::sample(filter_, *draw_.texture, point.uv, fragment.lod);
    fragment.decal = {texel.colour[0], texel.colour[1], texel.colour[2]};
    fragment.gloss = texel.gloss;
    return texel;
  }

  void light(double surface_cosine, ExactFragment& fragment) const {
    const auto cosine = [](double x) { return std::clamp(x, 0.0, 1.0); };
    const Vec3 n = fragment.n, l = fragment.l, h = fragment.h;
    fragment.nl = cosine(dot(n, l));
    fragment.nh = cosine(context_.config.is(Lighting::kReflection) ? exact::reflected(n, l, h) : dot(n, h));
    fragment.diffuse = fragment.nl;
    fragment.specular = std::pow(fragment.nh, state_.material.exponent);
    if (!context_.words.shadow) return;
    const bool is_cut = context_.config.surface_is_z != 0 && draw_.bump;
    const double through = exact::self_shadow(context_.config, is_cut ? cosine(surface_cosine) : fragment.nl);
    fragment.diffuse *= through;
    fragment.specular *= fragment.nl > 0 ? through : 0;
  }

  const exact::DrawContext& context_;
  const IdealScene& scene_;
  const IdealDraw& draw_;
  const DrawState& state_;
  exact::Filtering filter_;
};

}  // namespace

void draw_ideal(const Config& config, const Frame& frame, const ExactSink& sink) {
  std::array<TruePoint, exact::kColumnLength> points;
  const auto put = [&](const exact::DrawContext& draw, exact::Interpolator& triangle, int x, int y, std::size_t i,
                       exact::Fragments& batch) {
    triangle.put(draw, x, y, i, batch);
    points[i] = TriangleTruth(triangle, frame.ideal.draws.at(batch.draw)).at(x, y);
  };
  exact::for_each_batch(Shape(config), frame, put, [&](const exact::DrawContext& draw, exact::Fragments& batch) {
    const IdealShader shader(draw, frame, batch.draw);
    exact::run_stages(draw, kAllStages, batch);
    for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i) {
      ExactFragment fragment = batch.fragment(i);
      shader.shade(points[i], fragment);
      sink(fragment);
    }
  });
}

}  // namespace wrinkle

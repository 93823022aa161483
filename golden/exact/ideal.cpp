// Eq. 1-2 at every pixel, in world space, on the true surface.
#include "golden/exact/exact.h"
#include "golden/exact/perturb.h"
#include "golden/exact/pipeline.h"
#include "golden/texel/bump.h"

namespace wrinkle {
namespace {

Vec3 towards(Vec3 from, Vec3 place, bool at_infinity) { return normalize(at_infinity ? place : place - from); }

// The surface parameter at a pixel, interpolated as the perspective demands.
Vec2 parameter_at(const Corners& corners, const exact::Weights& weights) {
  Vec2 parameter;
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double weight = weights.b[i] * corners.v[i]->q;
    parameter = parameter + weight * corners.v[i]->parameter;
    sum += weight;
  }
  return (1 / sum) * parameter;
}

// A texel normal out of the frame that the surface itself has at the point; T and B are the columns of [Peercy97 eq.
// 7].
Vec3 from_tangent_space(const SurfacePoint& point, Vec3 texel) {
  const Vec3 T = normalize(point.Pu - dot(point.Pu, point.N) * point.N);
  const double sign = dot(point.N, cross(point.Pu, point.Pv)) < 0 ? -1 : 1;
  return normalize(texel.x * T + (sign * texel.y) * cross(point.N, T) + texel.z * point.N);
}

// N, L and H of the fragment from the surface point; N' from the height field where the draw is bump mapped.
void shade_surface(const exact::DrawContext& context, const IdealScene& ideal, const HeightField* height,
                   const SurfacePoint& point, Vec2 parameter, ExactFragment& fragment) {
  fragment.n = point.N;
  const bool regular = length(cross(point.Pu, point.Pv)) > 0;
  if (context.words.bump && height == nullptr && regular) {
    fragment.n =
        from_tangent_space(point, exact::texel_normal(context.config, fragment.bump, context.texture->bump_scale));
  } else if (context.words.bump && regular) {
    const Vec2 slope = height->gradient(parameter.x, parameter.y);
    const Vec3 perturbed = perturbed_normal_blinn(point.Pu, point.Pv, slope.x, slope.y);
    // The side that is seen may be the one that Pu x Pv points away from.
    fragment.n = dot(point.N, cross(point.Pu, point.Pv)) < 0 ? -perturbed : perturbed;
  }
  fragment.l = towards(point.P, ideal.light, ideal.light_at_infinity);
  const Vec3 eye = towards(point.P, ideal.eye, ideal.eye_at_infinity);
  fragment.h = context.config.is(Lighting::kReflection) ? eye : normalize(fragment.l + eye);
  fragment.frame[0] = point.N;
  fragment.interpolated_l = fragment.l;
  fragment.interpolated_h = fragment.h;
  fragment.perturbed_n = fragment.n;
  const exact::Lit lit =
      exact::light(context.config, context.words, fragment.n, fragment.l, fragment.h, dot(point.N, fragment.l));
  fragment.nl = lit.nl;
  fragment.nh = lit.nh;
  fragment.diffuse = lit.diffuse;
  fragment.specular = lit.specular;
  fragment.colour = exact::output(context.reflectance, fragment.decal, fragment.gloss, lit);
}

// Where each fragment of a batch lies on the analytic surface; null where it has none.
struct Places {
  std::array<const wrinkle::Surface*, exact::kColumnLength> surface;
  std::array<Vec2, exact::kColumnLength> parameter;
};

}  // namespace

void draw_ideal(const Config& config, const Frame& frame, const ExactSink& sink) {
  Places places;
  const auto put = [&](const exact::DrawContext& draw, exact::Interpolator& triangle, int x, int y, std::size_t i,
                       exact::Fragments& batch) {
    triangle.put(draw, x, y, i, batch);
    places.surface[i] = triangle.triangle().surface.get();
    if (places.surface[i] != nullptr) places.parameter[i] = parameter_at(triangle.corners(), triangle.weights(x, y));
  };
  exact::for_each_batch(Shape(config), frame, put, [&](const exact::DrawContext& draw, exact::Fragments& batch) {
    const std::size_t index = batch.draw;
    const HeightField* height = index < frame.ideal.height.size() ? frame.ideal.height[index].get() : nullptr;
    exact::run_stages(draw, kAllStages, batch);
    for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i) {
      ExactFragment fragment = batch.fragment(i);
      if (places.surface[i] != nullptr) {
        const Vec2 parameter = places.parameter[i];
        const SurfacePoint point = places.surface[i]->at(parameter.x, parameter.y);
        shade_surface(draw, frame.ideal, height, point, parameter, fragment);
      }
      sink(fragment);
    }
  });
}

}  // namespace wrinkle

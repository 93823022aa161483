#include "golden/exact/pipeline.h"

#include <algorithm>

#include "golden/exact/light.h"
#include "golden/exact/normalize.h"
#include "golden/exact/perspective.h"
#include "golden/exact/perturb.h"
#include "golden/exact/texture.h"

namespace wrinkle::exact {
namespace {

template <class Visit>
void for_each(const Fragments& batch, Visit&& visit) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i) visit(i);
}

}  // namespace

DrawContext draw_context(const Shape& config, const Frame& frame, const Draw& draw) {
  DrawContext context{config, quantise(config, draw.state, frame.textures), reflectance(config, draw.state.material),
                      draw.state.L, draw.state.H};
  if (context.words.textured) context.texture = &frame.exact_textures.at(static_cast<std::size_t>(draw.state.texture));
  return context;
}

Interpolator::Interpolator(const Shape& config, const ScreenTriangle& triangle)
    : config_(&config),
      triangle_(&triangle),
      corners_(sort_corners(config, triangle)),
      barycentric_(config, corners_) {}

bool Interpolator::covers(int x, int y) const {
  if (corners_.area == 0) return false;
  const std::array<HalfPlane, 3> planes = half_planes(corners_, config_->subpixel_bits);
  return std::all_of(planes.begin(), planes.end(),
                     [&](const HalfPlane& plane) { return plane.at(x, y) >= plane.threshold(); });
}

void Interpolator::put(const DrawContext& draw, int x, int y, std::size_t i, Fragments& batch) {
  if (!attributes_) attributes_.emplace(*config_, corners_, draw.words);
  batch.clear(i, i + 1);
  batch.x[i] = x;
  batch.y[i] = y;
  batch.triangle[i] = triangle_->id;
  const Interpolated at = attributes_->at(barycentric_.at(x, y));
  batch.frame.set(i, at.frame);
  batch.interpolated_l.set(i, at.l);
  batch.interpolated_h.set(i, at.h);
  batch.q.set(i, at.q);
  batch.lod.set(i, at.lod);
  batch.z.set(i, at.z);
  batch.u.set(i, at.u);
  batch.v.set(i, at.v);
}

void perspective(const DrawContext& draw, Fragments& batch) {
  if (draw.texture == nullptr) return;
  for_each(batch, [&](std::size_t i) {
    const Vec2 uv = divide(draw.config, batch.u[i], batch.v[i], batch.q[i]);
    batch.u.set(i, uv.x);
    batch.v.set(i, uv.y);
  });
}

void texture(const DrawContext& draw, const ExactTexture* texels, Fragments& batch) {
  if (texels == nullptr) return;
  const Filtering filter = filtering(draw.config, draw.words);
  for_each(batch, [&](std::size_t i) {
    const Sample texel = sample(filter, *texels, {batch.u[i], batch.v[i]}, batch.lod[i]);
    batch.bump.set(i, texel.bump);
    if (draw.config.decal != 0) batch.decal.set(i, {texel.colour[0], texel.colour[1], texel.colour[2]});
    if (draw.config.gloss_map != 0) batch.gloss.set(i, texel.gloss);
  });
}

void perturb(const DrawContext& draw, Fragments& batch) { perturb(draw.config, draw.words, batch); }

void normalize(const DrawContext& draw, Fragments& batch) {
  const Shape& config = draw.config;
  const bool has_planes = config.has_light_planes != 0;
  for_each(batch, [&](std::size_t i) {
    const Vec3 l = has_planes ? normalize(config.normalizer_l, batch.interpolated_l[i]) : draw.l;
    const Vec3 h = has_planes ? normalize(config.third_normalizer, batch.interpolated_h[i]) : draw.h;
    batch.n.set(i, config.normal_width != 0 ? normalize(config.normalizer_n, batch.perturbed_n[i]) : Vec3{0, 0, 1});
    batch.l.set(i, l);
    batch.h.set(i, config.is(Lighting::kPixelHalfangle) ? wrinkle::normalize(l + h) : h);
  });
}

void dots(const DrawContext& draw, Fragments& batch) {
  for_each(batch, [&](std::size_t i) {
    Lit lit;
    dots(draw.config, batch.n[i], batch.l[i], batch.h[i], lit);
    batch.nl.set(i, lit.nl);
    batch.nh.set(i, lit.nh);
  });
}

void power(const DrawContext& draw, Fragments& batch) {
  for_each(batch, [&](std::size_t i) {
    Lit lit{batch.nl[i], batch.nh[i]};
    power(draw.config, draw.words, batch.l[i].z, lit);
    batch.diffuse.set(i, lit.diffuse);
    batch.specular.set(i, lit.specular);
  });
}

void output(const DrawContext& draw, Fragments& batch) {
  for_each(batch, [&](std::size_t i) {
    const Lit lit{batch.nl[i], batch.nh[i], batch.diffuse[i], batch.specular[i]};
    batch.colour.set(i, output(draw.reflectance, batch.decal[i], batch.gloss[i], lit));
  });
}

void run_stages(const DrawContext& draw, unsigned stages, Fragments& batch) {
  if (stages & kPerspective) perspective(draw, batch);
  if (stages & kTexture) texture(draw, draw.texture, batch);
  if (stages & kPerturb) perturb(draw, batch);
  if (stages & kNormalize) normalize(draw, batch);
  if (stages & kLight) dots(draw, batch), power(draw, batch);
  if (stages & kOutput) output(draw, batch);
}

}  // namespace wrinkle::exact

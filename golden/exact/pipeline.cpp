#include "golden/exact/pipeline.h"

#include "golden/exact/light.h"
#include "golden/exact/normalize.h"
#include "golden/exact/perspective.h"
#include "golden/exact/perturb.h"
#include "golden/exact/texture.h"

namespace wrinkle::exact {

DrawContext draw_context(const Config& config, const Frame& frame, const Draw& draw) {
  DrawContext context{config, quantise(config, draw.state, frame.textures), reflectance(config, draw.state.material),
                      draw.state.L, draw.state.H};
  if (context.words.textured) context.texture = &frame.exact_textures.at(static_cast<std::size_t>(draw.state.texture));
  return context;
}

void fetch(const DrawContext& draw, const Attributes& attributes, const Weights& weights, ExactFragment& fragment) {
  const Interpolated interpolated = attributes.at(weights);
  fragment.interpolated_n = interpolated.n;
  fragment.interpolated_l = interpolated.l;
  fragment.interpolated_h = interpolated.h;
  fragment.interpolated_a = interpolated.a;
  fragment.interpolated_b = interpolated.b;
  fragment.interpolated_c = interpolated.c;
  fragment.q = interpolated.q;
  fragment.lod = interpolated.lod;
  fragment.z = interpolated.z;
  if (draw.texture == nullptr) return;
  const Vec2 uv = divide(draw.config, interpolated);
  fragment.u = uv.x;
  fragment.v = uv.y;
  const Sample texel = sample(draw.config, draw.words, *draw.texture, uv, interpolated.lod);
  fragment.texture_n = {texel[0], texel[1], texel[2]};
  if (draw.config.has_blinn()) {
    fragment.gradient = {texel[0], texel[1]};
    fragment.texture_n = {-texel[0], -texel[1], texel[2]};  // along the normal, where u and v are lengths
  }
  if (draw.config.decal != 0) fragment.decal = {texel[3], texel[4], texel[5]};
}

void shade(const DrawContext& draw, ExactFragment& fragment) {
  const Config& config = draw.config;
  if (config.has_blinn())
    fragment.perturbed_n = displace(draw.words, fragment.interpolated_a, fragment.interpolated_b,
                                    fragment.interpolated_c, fragment.gradient);
  else
    fragment.perturbed_n = perturb(draw.words, fragment.interpolated_n, fragment.texture_n);
  fragment.n = config.has_normal() ? normalize(config.normalizer_n, fragment.perturbed_n) : Vec3{0, 0, 1};
  fragment.l = config.has_light_planes() ? normalize(config.normalizer_l, fragment.interpolated_l) : draw.l;
  fragment.h = config.has_light_planes() ? normalize(config.third_normalizer(), fragment.interpolated_h) : draw.h;
  if (config.is(Lighting::kPixelHalfangle)) fragment.h = wrinkle::normalize(fragment.l + fragment.h);
  const Lit lit = light(config, draw.words, fragment.n, fragment.l, fragment.h, fragment.l.z);
  fragment.nl = lit.nl;
  fragment.nh = lit.nh;
  fragment.diffuse = lit.diffuse;
  fragment.specular = lit.specular;
  fragment.colour = output(draw.reflectance, fragment.decal, lit);
}

}  // namespace wrinkle::exact

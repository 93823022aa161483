#include "golden/exact/pipeline.h"

#include "golden/exact/light.h"
#include "golden/exact/normalize.h"
#include "golden/exact/perspective.h"
#include "golden/exact/perturb.h"
#include "golden/exact/texture.h"

namespace wrinkle::exact {

DrawContext draw_context(const Config& config, const Frame& frame, const Draw& draw) {
  DrawContext context{config, quantise(config, draw.state, frame.textures), reflectance(config, draw.state.material)};
  if (context.words.textured) context.texture = &frame.exact_textures.at(static_cast<std::size_t>(draw.state.texture));
  return context;
}

void fetch(const DrawContext& draw, const Attributes& attributes, const Weights& weights, ExactFragment& fragment) {
  const Interpolated interpolated = attributes.at(weights);
  fragment.interpolated_n = interpolated.n;
  fragment.interpolated_l = interpolated.l;
  fragment.interpolated_h = interpolated.h;
  fragment.q = interpolated.q;
  fragment.lod = interpolated.lod;
  fragment.z = interpolated.z;
  if (draw.texture == nullptr) return;
  const Vec2 uv = divide(draw.config, interpolated);
  fragment.u = uv.x;
  fragment.v = uv.y;
  const Sample texel = sample(draw.config, draw.words, *draw.texture, uv, interpolated.lod);
  fragment.texture_n = {texel[0], texel[1], texel[2]};
  if (draw.config.decal != 0) fragment.decal = {texel[3], texel[4], texel[5]};
}

void shade(const DrawContext& draw, ExactFragment& fragment) {
  const Config& config = draw.config;
  fragment.perturbed_n = perturb(draw.words, fragment.interpolated_n, fragment.texture_n);
  fragment.n = normalize(config.normalizer_n, fragment.perturbed_n);
  fragment.l = normalize(config.normalizer_l, fragment.interpolated_l);
  fragment.h = normalize(config.normalizer_h, fragment.interpolated_h);
  const Lit lit = light(config, draw.words, fragment.n, fragment.l, fragment.h, fragment.l.z);
  fragment.nl = lit.nl;
  fragment.nh = lit.nh;
  fragment.diffuse = lit.diffuse;
  fragment.specular = lit.specular;
  fragment.colour = output(draw.reflectance, fragment.decal, lit);
}

}  // namespace wrinkle::exact

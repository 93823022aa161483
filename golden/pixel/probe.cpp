#include "golden/pixel/probe.h"

#include <memory>

#include "golden/pixel/stages.h"

namespace wrinkle {
namespace {

std::unique_ptr<Batch<std::int64_t>> run_one(const Context& context, unsigned stages,
                                             std::unique_ptr<Batch<std::int64_t>> batch) {
  batch->count = 1;
  const auto no_spans = std::make_unique<Spans<std::int64_t>>();
  run_checked(context, stages, *no_spans, *batch);
  return batch;
}

}  // namespace

std::array<std::int64_t, 3> normalize_vector(const Shape& config, const std::array<std::int64_t, 3>& v) {
  auto batch = std::make_unique<Batch<std::int64_t>>(config);
  for (std::size_t k = 0; k < 3; ++k) batch->perturb_n[k][0] = v[k];
  batch = run_one(make_context(config), kNormalize, std::move(batch));
  return {batch->normalize_n[0][0], batch->normalize_n[1][0], batch->normalize_n[2][0]};
}

std::int64_t rsqrt_of(int unit_bits, std::int64_t t) {
  const RsqrtGeometry& g = rsqrt_geometry(unit_bits);
  return rsqrt(g, rsqrt_table(g), t);
}

TextureSample sample_texture(const Shape& config, const Texture& texture, Wrap wrap_u, Wrap wrap_v, std::int64_t u,
                             std::int64_t v, std::int64_t lod) {
  Context context = make_context(config);
  DrawWords draw;
  draw.textured = true;
  draw.wrap_u = static_cast<int>(wrap_u);
  draw.wrap_v = static_cast<int>(wrap_v);
  draw.log2_width = texture.log2_width;
  draw.log2_height = texture.log2_height;
  draw.max_level = texture.max_level();
  set_draw(context, draw,
           std::make_shared<BoundTexture>(bind_texture(texture, context.config.bump_components, wrap_u, wrap_v)));
  auto batch = std::make_unique<Batch<std::int64_t>>(config);
  (config.divides != 0 ? batch->perspective_u : batch->interpolate_u)[0][0] = u;
  (config.divides != 0 ? batch->perspective_v : batch->interpolate_v)[0][0] = v;
  batch->interpolate_lod[0][0] = lod;
  batch = run_one(context, kTexture, std::move(batch));
  TextureSample sample;
  for (const auto& column : batch->texture_bump) sample.bump.push_back(column[0]);
  for (std::size_t k = 0; k < batch->texture_decal.size(); ++k) sample.decal[k] = batch->texture_decal[k][0];
  for (const auto& column : batch->texture_gloss) sample.gloss = column[0];
  return sample;
}

}  // namespace wrinkle

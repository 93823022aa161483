// offset: N' = N + (Dx, Dy, 0) against its exact twin, at the ends of its formats, and against the normals of a map.
#include <array>
#include <cmath>

#include "golden/texel/quantise.h"
#include "tests/datapath/support.h"

namespace wrinkle {
namespace {

const Config kConfig = with({{&Config::datapath, int(Datapath::kOffset)}, {&Config::light_vectors, 0}});

// D is below 1, and so is N where set-up makes it: nothing is rounded.
TEST(Offset, IsExactWithinItsFormat) {
  Random random(base_seed());
  for (const int v : {5, 9, 18}) {
    Config config = kConfig;
    config.vector_bits = v;
    ASSERT_EQ(check(config).key, "");
    for (const bool bump : {true, false}) {
      Context context = make_context(config);
      DrawWords draw;
      draw.bump = bump;
      set_draw(context, draw, nullptr);
      auto batch = std::make_unique<Batch<std::int64_t>>(context.config);
      batch->count = kBatch;
      const std::int64_t one = std::int64_t{1} << v;
      for (std::size_t i = 0; i < kBatch; ++i) {
        for (std::size_t k = 0; k < 3; ++k) batch->interpolate_frame[k][i] = pattern(random, {-one, one - 1});
        for (std::size_t k = 0; k < 2; ++k) batch->texture_bump[k][i] = pattern(random, {-one, one - 1});
      }
      batch = run_one(context, kPerturb, std::move(batch));
      for (std::size_t i = 0; i < kBatch; ++i) {
        const std::array frame{Vec3{double(batch->interpolate_frame[0][i]), double(batch->interpolate_frame[1][i]),
                                    double(batch->interpolate_frame[2][i])}};
        const std::array d{double(batch->texture_bump[0][i]), double(batch->texture_bump[1][i])};
        const Vec3 want = Offset::exact(bump, frame, d);
        EXPECT_EQ(double(batch->perturb_n[0][i]), want.x);
        EXPECT_EQ(double(batch->perturb_n[1][i]), want.y);
        EXPECT_EQ(double(batch->perturb_n[2][i]), want.z);
      }
    }
  }
}

// The longest N and D of one sign saturate at the ends of s1.V.
TEST(Offset, Saturates) {
  Context context = make_context(kConfig);
  DrawWords draw;
  draw.bump = true;
  set_draw(context, draw, nullptr);
  auto batch = std::make_unique<Batch<std::int64_t>>(context.config);
  batch->count = 1;
  const std::int64_t one = std::int64_t{1} << kConfig.vector_bits;
  batch->interpolate_frame[0][0] = 2 * one - 1, batch->texture_bump[0][0] = one - 1;
  batch->interpolate_frame[1][0] = -2 * one, batch->texture_bump[1][0] = -one;
  batch->interpolate_frame[2][0] = one / 2;
  batch = run_one(context, kPerturb, std::move(batch));
  EXPECT_EQ(batch->perturb_n[0][0], 2 * one - 1);
  EXPECT_EQ(batch->perturb_n[1][0], -2 * one);
  EXPECT_EQ(batch->perturb_n[2][0], one / 2);
}

// N + D of prepared texels has the direction of the normals that they were made from, flat maps and steep ones.
TEST(Offset, PreparedTexelsPointAsTheirNormals) {
  for (const double slope : {0.01, 0.7, 3.0}) {
    NormalMap normals(2, 2, normalize(Vec3{-slope, slope / 2, 1}));
    normals.at(1, 0) = {0, 0, 1};
    const ExactTexture source = assemble({normals}, {});
    const ExactTexture texels = Offset::texels({source, nullptr, kConfig.texel_bits});
    EXPECT_GE(texels.bump_scale, 1);
    VertexInputs vertex;
    vertex.bump_scale = texels.bump_scale;
    const FrameVectors frame = Offset::vertex(vertex);
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& bump = texels.levels[0][i].bump;
      const std::array d{double(bump[0]), double(bump[1])};
      EXPECT_LT(length(normalize(Offset::exact(true, frame, d)) - normals.samples[i]), 1e-6) << slope;
    }
  }
}

}  // namespace
}  // namespace wrinkle

// A third opinion, to the bit: every rounding as docs/architecture.md states it, in plain integers of 128 bits, against
// the golden model. A change that is made to golden and Verilog alike keeps them equal, and may keep every bound; here
// it is seen, and named by stage and value.
#include "golden/datapath/datapaths.h"
#include "golden/pixel/reciprocal.h"
#include "golden/pixel/rsqrt.h"
#include "tests/stage/support.h"

namespace wrinkle {
namespace {

using Batch64 = Batch<std::int64_t>;
using Wide = __int128;

Wide round_half_up(Wide x, int n) { return n <= 0 ? x << -n : (x + (Wide{1} << (n - 1))) >> n; }
Wide saturate(Wide x, Wide low, Wide high) { return std::min(std::max(x, low), high); }
Wide one(int bits) { return Wide{1} << bits; }

// A stage over patterns, in every configuration of the list; check(context, batch, i) looks at fragment i.
template <class Check>
void for_each_fragment(unsigned stage, const Check& check) {
  std::uint64_t seed = base_seed();
  for (const auto& [name, config] : configurations(40)) {
    for (int round = 0; round < 4; ++round) {
      SCOPED_TRACE(name + ", seed " + std::to_string(++seed));
      Random random(seed);
      const Context context = random_context(config, random);
      auto batch = std::make_unique<Batch64>(context.config);
      fill(config, seed, *batch);
      batch->count = kBatch;
      batch = run_one(context, stage, std::move(batch));
      for (std::size_t i = 0; i < kBatch && !testing::Test::HasFailure(); ++i) check(context, *batch, i);
    }
  }
}

void expect_equal(std::int64_t got, Wide contract, const char* what) {
  EXPECT_EQ(got, static_cast<std::int64_t>(contract)) << what << " is not what docs/architecture.md states";
}

TEST(Contract, Perspective) {
  for_each_fragment(kPerspective, [](const Context& context, const Batch64& batch, std::size_t i) {
    const Shape& c = context.config;
    if (c.divides == 0) return;
    const ReciprocalGeometry geometry{c.q_bits, c.reciprocal_bits};
    const std::int64_t q = std::max<std::int64_t>(batch.interpolate_q[0][i], 1);
    int lz = 0;
    while ((q << lz) >> (c.q_bits - 1) == 0) ++lz;
    const Wide r = reciprocal(geometry, reciprocal_table(geometry), q << lz);
    const auto quotient = [&](std::int64_t uq) {
      const Wide u = round_half_up(uq * r, c.reciprocal_bits - lz), modulus = one(c.uv_width);
      const Wide low = ((u % modulus) + modulus) % modulus;
      return low >= modulus / 2 ? low - modulus : low;
    };
    expect_equal(batch.perspective_u[0][i], quotient(batch.interpolate_u[0][i]), "perspective u");
    expect_equal(batch.perspective_v[0][i], quotient(batch.interpolate_v[0][i]), "perspective v");
  });
}

// The filtered code of one component, with D fraction bits.
struct FilteredCode {
  Wide sum;
  int fraction_bits;
};

std::int64_t wrapped(int wrap, std::int64_t i, int w) {
  const std::int64_t size = std::int64_t{1} << w;
  if (static_cast<Wrap>(wrap) == Wrap::kClamp) return std::min(std::max<std::int64_t>(i, 0), size - 1);
  const std::int64_t low = ((i % size) + size) % size;
  const bool odd = (((i - low) / size) & 1) != 0;
  return static_cast<Wrap>(wrap) == Wrap::kMirror && odd ? size - 1 - low : low;
}

struct Tap {
  std::int64_t first, second;
  Wide fraction;
};
Tap tap(const Shape& c, int wrap, std::int64_t u, int w) {
  const int b = c.weight_fraction_bits;
  const Wide t = b == 0 ? Wide{u} * one(w) >> c.uv_bits : round_half_up(u, c.uv_bits - w - b) - one(b - 1);
  const auto i = static_cast<std::int64_t>(t >> b);
  return {wrapped(wrap, i, w), wrapped(wrap, i + 1, w), t - (Wide{i} << b)};
}

FilteredCode filtered(const Context& context, const Texture& texture, std::int64_t u, std::int64_t v, std::int64_t lod,
                      int component) {
  const Shape& c = context.config;
  const DrawWords& draw = context.draw;
  const int b = c.weight_fraction_bits, lb = c.lod_fraction_bits;
  const auto level_sum = [&](int level) {
    const Tap x = tap(c, draw.wrap_u, u, std::max(draw.log2_width - level, 0));
    const Tap y = tap(c, draw.wrap_v, v, std::max(draw.log2_height - level, 0));
    const auto code = [&](std::int64_t column, std::int64_t row) {
      const auto at = static_cast<std::size_t>(row * texture.width(level) + column);
      return Wide{texture.code(texture.levels[static_cast<std::size_t>(level)], at, component)};
    };
    if (b == 0) return code(x.first, y.first);
    const auto along_x = [&](std::int64_t row) {
      return code(x.first, row) * (one(b) - x.fraction) + code(x.second, row) * x.fraction;
    };
    return along_x(y.first) * (one(b) - y.fraction) + along_x(y.second) * y.fraction;
  };
  const auto clamped = [&](std::int64_t level) {
    return static_cast<int>(std::min<std::int64_t>(std::max<std::int64_t>(level, 0), draw.max_level));
  };
  const std::int64_t a = lod >> lb;
  const Wide fraction = lod < 0 || a >= draw.max_level ? Wide{0} : Wide{lod - (a << lb)};
  if (c.trilinear == 0) return {level_sum(clamped(a)), 2 * b};
  return {level_sum(clamped(a)) * (one(lb) - fraction) + level_sum(clamped(a + 1)) * fraction, 2 * b + lb};
}

TEST(Contract, Texture) {
  std::uint64_t seed = base_seed();
  for (auto [name, config] : configurations(40)) {
    if (Shape(config).textured == 0) continue;
    SCOPED_TRACE(name + ", seed " + std::to_string(++seed));
    Random random(seed);
    DrawWords draw = random_draw(config, random);
    draw.textured = true;
    const Texture texture = random_texture(config, draw, random);
    Context context = make_context(config);
    const Shape& c = context.config;
    set_draw(context, draw,
             std::make_shared<BoundTexture>(bind_texture(texture, c.bump_components, static_cast<Wrap>(draw.wrap_u),
                                                         static_cast<Wrap>(draw.wrap_v))));
    auto batch = std::make_unique<Batch64>(c);
    fill(config, seed, *batch);
    batch->count = kBatch;
    batch = run_one(context, kTexture, std::move(batch));
    const auto &u = c.divides != 0 ? batch->perspective_u : batch->interpolate_u,
               &v = c.divides != 0 ? batch->perspective_v : batch->interpolate_v;
    for (std::size_t i = 0; i < kBatch && !HasFailure(); ++i) {
      for (int k = 0; k < c.texels; ++k) {
        const auto [f, d] = filtered(context, texture, u[0][i], v[0][i], batch->interpolate_lod[0][i], k);
        const auto element = static_cast<std::size_t>(k);
        if (k >= c.bump_components) {
          if (k < c.bump_components + 3 * c.decal)
            expect_equal(batch->texture_decal[element - static_cast<std::size_t>(c.bump_components)][i],
                         round_half_up(f, d), "texture decal");
          else
            expect_equal(batch->texture_gloss[0][i], round_half_up(f, d), "texture gloss");
          continue;
        }
        // n = 2 f - offset 2^D of full scale 2^T where the datapath doubles its code; else f - 2^(T-1+D).
        const int t = c.texel_bits;
        const Wide limit = c.bump_saturates != 0 ? one(c.bump_width - 1) : one(c.bump_fraction + 1);
        const Wide n = 2 * f - (Wide{c.bump_offset} << d);
        expect_equal(batch->texture_bump[element][i],
                     saturate(round_half_up(n, d + t - c.bump_fraction), -limit, limit - 1), "texture bump");
      }
    }
  }
}

TEST(Contract, PerturbOfBlinn) {
  for_each_fragment(kPerturb, [](const Context& context, const Batch64& batch, std::size_t i) {
    const Shape& c = context.config;
    if (c.datapath != static_cast<int>(Datapath::kBlinn)) return;
    for (std::size_t k = 0; k < 3; ++k) {
      const Wide a = batch.interpolate_frame[k][i], b = batch.interpolate_frame[3 + k][i],
                 last = batch.interpolate_frame[6 + k][i];
      const Wide fu = batch.texture_bump[0][i], fv = batch.texture_bump[1][i], limit = one(c.wide_bits + 2);
      const Wide bent =
          saturate(round_half_up((a << c.gradient_bits) - fu * b - fv * last, c.gradient_bits), -limit, limit - 1);
      expect_equal(batch.perturb_n[k][i], context.draw.bump ? bent : a, "perturb n");
    }
  });
}

// One vector through `faithful`: P magnitude bits, the table of F, halves away from zero.
std::array<Wide, 3> faithful(const std::array<std::int64_t, 3>& v, int v_bits, int f) {
  const Wide most = one(v_bits + 1) - 1;
  std::array<Wide, 3> m;
  Wide all = 0;
  for (std::size_t k = 0; k < 3; ++k) all |= m[k] = std::min<Wide>(v[k] < 0 ? -Wide{v[k]} : Wide{v[k]}, most);
  if (all == 0) return {0, 0, 0};
  int shift = 0;
  while ((all << shift) >> v_bits == 0) ++shift;
  Wide sum = 0;
  for (Wide& magnitude : m) magnitude <<= shift, sum += magnitude * magnitude;
  const int p = v_bits + 1;
  const bool e = sum >= one(2 * p);
  const RsqrtGeometry& geometry = rsqrt_geometry(f);
  const Wide scaled = e ? sum : sum << 2;
  const auto t =
      static_cast<std::int64_t>(2 * p + 2 >= geometry.input_bits ? scaled >> (2 * p + 2 - geometry.input_bits)
                                                                 : scaled << (geometry.input_bits - 2 * p - 2));
  const Wide r = rsqrt(geometry, rsqrt_table(geometry), t);
  std::array<Wide, 3> n;
  for (std::size_t k = 0; k < 3; ++k) {
    const Wide magnitude = round_half_up(m[k] * r, p + geometry.output_bits - f + (e ? 1 : 0));
    n[k] = v[k] < 0 ? -magnitude : magnitude;
  }
  return n;
}

TEST(Contract, NormalizeFaithfulAndNone) {
  for_each_fragment(kNormalize, [](const Context& context, const Batch64& batch, std::size_t i) {
    const Shape& c = context.config;
    if (c.normalizes_after != 0) return;
    const auto check = [&](int kind, Columns<std::int64_t> in, Columns<std::int64_t> out, int v_bits,
                           const char* what) {
      const std::array v{in[0][i], in[1][i], in[2][i]};
      const Wide limit = one(c.normalized_width - 1);
      for (std::size_t k = 0; k < 3; ++k) {
        if (kind == static_cast<int>(Normalizer::kFaithful))
          expect_equal(out[k][i], faithful(v, v_bits, c.unit_bits)[k], what);
        if (kind == static_cast<int>(Normalizer::kNone))
          expect_equal(out[k][i], saturate(round_half_up(v[k], v_bits - c.unit_bits), -limit, limit - 1), what);
      }
    };
    if (c.normal_width != 0)
      check(c.normalizer_n, batch.perturb_n, batch.normalize_n, c.normal_input_bits, "normalize n");
    if (c.has_light_planes == 0) return;
    check(c.normalizer_l, batch.interpolate_l, batch.normalize_l, c.vector_bits, "normalize l");
    if (c.glossy != 0 && !c.is(Lighting::kPixelHalfangle))
      check(c.normalizer_h, batch.interpolate_h, batch.normalize_h, c.vector_bits, "normalize h");
  });
}

Wide dot(Columns<std::int64_t> a, Columns<std::int64_t> b, std::size_t i) {
  return Wide{a[0][i]} * b[0][i] + Wide{a[1][i]} * b[1][i] + Wide{a[2][i]} * b[2][i];
}

// N.L or N.H; with the order `after`, scaled by the scale of N and that of the other vector.
Wide cosine(const Shape& c, const Batch64& batch, Columns<std::int64_t> other, std::size_t k, std::size_t i) {
  const Wide d = round_half_up(std::max<Wide>(dot(batch.normalize_n, other, i), 0), 2 * c.unit_bits - c.dot_bits);
  if (c.normalizes_after == 0) return std::min(d, one(c.dot_bits));
  const Wide s =
      round_half_up(Wide{batch.normalize_scale[0][i]} * batch.normalize_scale[k][i], 2 * c.scale_bits - c.dot_bits);
  return std::min(round_half_up(d * s, c.dot_bits), one(c.dot_bits));
}

Wide reflected(const Shape& c, const Batch64& batch, std::size_t i) {
  const Wide limit = one(c.unit_bits), nl = dot(batch.normalize_n, batch.normalize_l, i);
  const auto rounded = [&](Wide x) { return saturate(round_half_up(x, c.unit_bits), -limit, limit); };
  const Wide r = 2 * rounded(nl) * rounded(dot(batch.normalize_n, batch.normalize_h, i)) -
                 dot(batch.normalize_l, batch.normalize_h, i);
  const Wide nh = round_half_up(std::max<Wide>(r, 0), 2 * c.unit_bits - c.dot_bits);
  return nl > 0 ? std::min(nh, one(c.dot_bits)) : 0;
}

TEST(Contract, Light) {
  for_each_fragment(kLight, [](const Context& context, const Batch64& batch, std::size_t i) {
    const Shape& c = context.config;
    const DrawWords& draw = context.draw;
    const Wide nl = cosine(c, batch, batch.normalize_l, 1, i);
    expect_equal(batch.light_nl[0][i], nl, "light nl");
    Wide p = 0;
    if (c.glossy != 0) {
      const Wide nh = c.is(Lighting::kReflection) ? reflected(c, batch, i) : cosine(c, batch, batch.normalize_h, 2, i);
      expect_equal(batch.light_nh[0][i], nh, "light nh");
      p = draw.exponent_zero ? one(c.power_bits) : nh << (c.power_bits - c.dot_bits);
      for (int k = 0; k < draw.squarings && !draw.exponent_zero; ++k) p = round_half_up(p * p, c.power_bits);
    }
    Wide diffuse = nl;
    if (c.self_shadow != 0 && draw.shadow) {
      const bool is_surface = c.surface_is_z != 0 && draw.bump;
      const Wide s = is_surface
                         ? std::min(round_half_up(std::max<Wide>(batch.normalize_l[2][i], 0), c.unit_bits - c.dot_bits),
                                    one(c.dot_bits))
                         : nl;
      const bool is_hard = c.self_shadow == static_cast<int>(SelfShadow::kHard);
      const Wide g = is_hard ? (s > 0 ? one(c.dot_bits) : 0) : std::min(8 * s, one(c.dot_bits));
      diffuse = round_half_up(nl * g, c.dot_bits);
      p = nl > 0 ? round_half_up(p * g, c.dot_bits) : 0;
    }
    expect_equal(batch.light_diffuse[0][i], diffuse, "light diffuse");
    if (c.glossy != 0) expect_equal(batch.light_specular[0][i], p, "light specular");
  });
}

TEST(Contract, Output) {
  for_each_fragment(kOutput, [](const Context& context, const Batch64& batch, std::size_t i) {
    const Shape& c = context.config;
    const DrawWords& draw = context.draw;
    Wide specular = c.glossy != 0 ? batch.light_specular[0][i] : 0;
    if (c.gloss_map != 0) {
      const Wide code = batch.texture_gloss[0][i];
      specular = round_half_up(specular * (code + (code >> (c.texel_bits - 1))), c.texel_bits);
    }
    for (std::size_t k = 0; k < static_cast<std::size_t>(c.count); ++k) {
      Wide base = (Wide{draw.ambient[k]} << c.dot_bits) + Wide{draw.diffuse[k]} * batch.light_diffuse[0][i];
      if (c.decal != 0) {
        const Wide code = batch.texture_decal[k][i];
        base = round_half_up(base * (code + (code >> (c.texel_bits - 1))), c.texel_bits);
      }
      const Wide sum = (base << (c.power_bits - c.dot_bits)) + Wide{draw.specular[k]} * specular;
      const Wide full = one(c.colour_bits) - 1;
      expect_equal(batch.output_colour[k][i],
                   saturate(round_half_up(sum * full, c.colour_bits + c.power_bits), 0, full), "output colour");
    }
  });
}

}  // namespace
}  // namespace wrinkle

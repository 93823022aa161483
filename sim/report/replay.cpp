#include "sim/report/replay.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <stdexcept>

#include "golden/exact/light.h"
#include "golden/exact/normalize.h"
#include "golden/exact/perturb.h"
#include "golden/exact/texture.h"
#include "golden/pixel/pixel.h"

namespace wrinkle {
namespace {

// The values that a part puts out.
struct PartFields {
  std::vector<Vec3 ExactFragment::*> vectors;
  std::vector<Vec2 ExactFragment::*> pairs;
  std::vector<double ExactFragment::*> numbers;
};

const PartFields& fields_of(Part part) {
  using F = ExactFragment;
  static const PartFields texture{{&F::texture_n, &F::decal}, {&F::gradient}, {}};
  static const std::array<PartFields, kParts> all{
      PartFields{{&F::interpolated_n, &F::interpolated_l, &F::interpolated_h, &F::interpolated_a, &F::interpolated_b,
                  &F::interpolated_c},
                 {},
                 {&F::u, &F::v, &F::lod}},
      texture,
      texture,
      PartFields{{&F::perturbed_n}, {}, {}},
      PartFields{{&F::n, &F::l, &F::h}, {}, {}},
      PartFields{{}, {}, {&F::nl, &F::nh}},
      PartFields{{}, {}, {&F::diffuse, &F::specular}},
      PartFields{{&F::colour}, {}, {}}};
  return all[std::size_t(part)];
}

void add_rounding(const PartOutput& output, Part part, ExactFragment& fragment) {
  const PartFields& fields = fields_of(part);
  const auto add = [&](const auto field) {
    fragment.*field = fragment.*field + (output.rounded.*field - output.exact.*field);
  };
  std::for_each(fields.vectors.begin(), fields.vectors.end(), add);
  std::for_each(fields.pairs.begin(), fields.pairs.end(), add);
  std::for_each(fields.numbers.begin(), fields.numbers.end(), add);
}

void sample(const exact::DrawContext& draw, const ExactTexture* texture, ExactFragment& f) {
  if (texture == nullptr) return;
  const exact::Sample texel = exact::sample(draw.config, draw.words, *texture, {f.u, f.v}, f.lod);
  if (draw.config.has_blinn()) {
    f.gradient = {texel[0], texel[1]};
  } else {
    f.texture_n = {texel[0], texel[1], texel[2]};
  }
  if (draw.config.decal != 0) f.decal = {texel[3], texel[4], texel[5]};
}

void perturb(const exact::DrawContext& draw, ExactFragment& f) {
  f.perturbed_n = draw.config.has_blinn()
                      ? exact::displace(draw.words, f.interpolated_a, f.interpolated_b, f.interpolated_c, f.gradient)
                      : exact::perturb(draw.words, f.interpolated_n, f.texture_n);
}

void normalize(const exact::DrawContext& draw, ExactFragment& f) {
  const Config& config = draw.config;
  f.n = config.has_normal() ? exact::normalize(config.normalizer_n, f.perturbed_n) : Vec3{0, 0, 1};
  f.l = config.has_light_planes() ? exact::normalize(config.normalizer_l, f.interpolated_l) : draw.l;
  f.h = config.has_light_planes() ? exact::normalize(config.third_normalizer(), f.interpolated_h) : draw.h;
  if (config.is(Lighting::kPixelHalfangle)) f.h = wrinkle::normalize(f.l + f.h);
}

void dots(const exact::DrawContext& draw, ExactFragment& f) {
  const exact::Lit lit = exact::light(draw.config, draw.words, f.n, f.l, f.h, f.l.z);
  f.nl = lit.nl;
  f.nh = lit.nh;
}

// The twin of `light` behind its dot products: vectors along one axis have them as their product.
void power(const exact::DrawContext& draw, ExactFragment& f) {
  Config config = draw.config;
  if (config.has_specular()) config.lighting = int(Lighting::kHalfangle);
  const exact::Lit lit = exact::light(config, draw.words, {1, 0, 0}, {f.nl, 0, 0}, {f.nh, 0, 0}, f.l.z);
  f.diffuse = lit.diffuse;
  f.specular = lit.specular;
}

void output(const exact::DrawContext& draw, ExactFragment& f) {
  f.colour = exact::output(draw.reflectance, f.decal, {f.nl, f.nh, f.diffuse, f.specular});
}

void run_twin(Part part, const exact::DrawContext& draw, ExactFragment& f) {
  switch (part) {
    case Part::kInterpolate:
    case Part::kFilter:
      return;
    case Part::kTexel:
      return sample(draw, draw.texture, f);
    case Part::kPerturb:
      return perturb(draw, f);
    case Part::kNormalize:
      return normalize(draw, f);
    case Part::kDot:
      return dots(draw, f);
    case Part::kPower:
      return power(draw, f);
    case Part::kOutput:
      return output(draw, f);
  }
}

// The codes of a texture as the real numbers that they stand for.
ExactTexture decoded(const Config& config, const Texture& texture) {
  ExactTexture result{texture.log2_width, texture.log2_height, {}};
  const int bits = texture.component_bits;
  const double mask = std::ldexp(1.0, bits) - 1, half = std::ldexp(1.0, bits - 1);
  const bool is_range = !config.has_blinn() && config.decode == int(Decode::kRange);
  const double zero = is_range ? mask / 2 : half;
  const std::size_t normals = config.has_blinn() ? 2 : config.has_texture_normal() ? 3 : 0;
  for (const auto& level : texture.levels) {
    auto& texels = result.levels.emplace_back();
    for (const std::uint64_t word : level) {
      std::array<float, 6> texel{0, 0, 0, 1, 1, 1};
      for (std::size_t c = 0; c < std::size_t(texture.components); ++c) {
        const double code = double((word >> (c * std::size_t(bits))) & ((std::uint64_t{1} << bits) - 1));
        if (c < normals) {
          texel[c] = float((code - zero) / half);
        } else {
          texel[3 + c - normals] = float(code / mask);
        }
      }
      texels.push_back(texel);
    }
  }
  return result;
}

// Golden's values by name.
class ValueReader {
 public:
  explicit ValueReader(const Config& config) : config_(config), values_(values(config)) {}

  double number(const FragmentValues& from, std::string_view stage, std::string_view name,
                std::size_t element = 0) const {
    for (std::size_t i = 0; i < values_.size(); ++i) {
      if (values_[i].stage == stage && values_[i].name == name)
        return std::ldexp(double(from[i][element]), -values_[i].fraction_bits);
    }
    return 0;  // the configuration has no such value
  }
  Vec3 vector(const FragmentValues& from, std::string_view stage, std::string_view name) const {
    return {number(from, stage, name, 0), number(from, stage, name, 1), number(from, stage, name, 2)};
  }

  // N, L or H; `index` is that of its scale, where it has one.
  Vec3 normalized(const FragmentValues& from, std::string_view name, std::size_t index) const {
    const double scale = config_.normalizes_after() ? number(from, "normalize", "scale", index) : 1;
    return scale * vector(from, "normalize", name);
  }

  ExactFragment fragment(const FragmentValues& from, const exact::DrawContext& draw) const {
    ExactFragment f;
    const std::string_view divided = config_.perspective != 0 ? "perspective" : "interpolate";
    f.interpolated_n = vector(from, "interpolate", "n");
    f.interpolated_l = vector(from, "interpolate", "l");
    f.interpolated_h = vector(from, "interpolate", "h");
    f.interpolated_a = vector(from, "interpolate", "a");
    f.interpolated_b = vector(from, "interpolate", "b");
    f.interpolated_c = vector(from, "interpolate", "c");
    f.u = number(from, divided, "u");
    f.v = number(from, divided, "v");
    f.lod = number(from, "interpolate", "lod");
    f.texture_n = vector(from, "texture", "n");
    f.decal = {1, 1, 1};
    // The decal's full scale is 2^T - 1.
    if (config_.decal != 0 && draw.texture != nullptr)
      f.decal = (1 / (1 - std::ldexp(1.0, -config_.texel_bits))) * vector(from, "texture", "decal");
    f.gradient = {number(from, "texture", "gradient", 0), number(from, "texture", "gradient", 1)};
    f.perturbed_n = vector(from, "perturb", "n");
    f.n = normalized(from, "n", 0);
    f.l = normalized(from, "l", 1);
    f.h = normalized(from, "h", 2);
    f.nl = number(from, "light", "nl");
    f.nh = number(from, "light", "nh");
    f.diffuse = number(from, "light", "diffuse");
    f.specular = number(from, "light", "specular");
    const double one = 1 - std::ldexp(1.0, -config_.colour_bits);
    f.colour = (1 / one) * vector(from, "output", "colour");
    if (config_.channel_count() == 1) f.colour.y = f.colour.z = f.colour.x;
    return f;
  }

 private:
  Config config_;
  std::vector<Value> values_;
};

// Where a fragment is: triangle, row, column.
using Key = std::array<std::uint32_t, 3>;

std::map<Key, FragmentValues> golden_values(const Config& config, const Frame& frame) {
  std::map<Key, FragmentValues> found;
  const PacketStream stream = build_packets(config, frame);
  FragmentValues one;
  const auto collect = [&](const auto& batch) {
    for (int i = 0; i < batch.count; ++i) {
      extract(batch, i, one);
      const Fragment f = fragment(batch, i);
      found[{stream.packet_triangle[batch.packet[std::size_t(i)]], std::uint32_t(f.y), std::uint32_t(f.x)}] = one;
    }
  };
  Golden(config, frame.textures).draw(stream.words, {collect, collect});
  return found;
}

}  // namespace

Vec3 replay(const ReplayedPixel& pixel, const Parts& chosen) {
  ExactFragment f = pixel.exact;
  for (std::size_t i = 0; i < kParts; ++i) {
    run_twin(Part(i), pixel.draw, f);
    if (chosen[i]) add_rounding(pixel.parts[i], Part(i), f);
  }
  return f.colour;
}

void for_each_replayed(const Config& config, const Frame& frame,
                       const std::function<void(const ReplayedPixel&)>& visit) {
  const std::map<Key, FragmentValues> golden = golden_values(config, frame);
  std::vector<ExactTexture> textures;
  for (const Texture& texture : frame.textures) textures.push_back(decoded(config, texture));
  const ValueReader reader(config);
  exact::for_each_fragment(
      config, frame,
      [&](const exact::DrawContext& draw, const ScreenTriangle& triangle, const Corners&, const exact::Weights&,
          ExactFragment& exact) {
        exact::shade(draw, exact);
        const auto values = golden.find({triangle.id, std::uint32_t(exact.y), std::uint32_t(exact.x)});
        if (values == golden.end()) throw std::logic_error("golden lacks a fragment that the exact datapath draws");
        const ExactFragment g = reader.fragment(values->second, draw);
        ReplayedPixel pixel{draw, exact, g, {}};
        ExactFragment twin = g;
        const auto keep = [&](Part part, const ExactFragment& rounded) {
          pixel.parts[std::size_t(part)] = {twin, rounded};
          twin = g;
        };
        pixel.parts[std::size_t(Part::kInterpolate)] = {exact, g};
        // The texels alone are rounded first, then all that the filter rounds.
        ExactFragment quantised = g;
        const ExactTexture* codes =
            draw.texture == nullptr ? nullptr : &textures[std::size_t(frame.draws[exact.draw].state.texture)];
        sample(draw, codes, quantised);
        sample(draw, draw.texture, twin);
        keep(Part::kTexel, quantised);
        twin = quantised;
        keep(Part::kFilter, g);
        for (const Part part : {Part::kPerturb, Part::kNormalize, Part::kDot, Part::kPower, Part::kOutput}) {
          run_twin(part, draw, twin);
          keep(part, g);
        }
        visit(pixel);
      });
}

}  // namespace wrinkle

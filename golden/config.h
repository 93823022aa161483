// A configuration of the hardware: which parts are there and how wide they are.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wrinkle {

enum class Datapath { kPhong, kTangent, kBlinn, kRotated };
enum class CrossProducts { kInterpolated, kConstant };
enum class BlockExponent { kTriangle, kDraw };
enum class LightVectorSource { kInterpolated, kConstant };
enum class Lighting { kDiffuse, kHalfangle, kReflection, kPixelHalfangle };
enum class Normalizer { kNone, kFaithful, kCompact, kLite, kNear };
enum class NormalizeOrder { kBefore, kAfter };
enum class SelfShadow { kOff, kHard, kSmooth };
enum class Filter { kNearest, kBilinear, kTrilinear };
enum class Decode { kRange, kOffset };

// Textures are at most 2^12 texels wide and high.
inline constexpr int kMaxLog2Size = 12;

// One int per parameter of parameters.def, under its name, in the order of that list.
struct Config {
#define WRINKLE_CHOICE(name, standard, values, description) int name = standard;
#define WRINKLE_WIDTH(name, standard, minimum, maximum, description) int name = standard;
#include "golden/parameters.def"
#undef WRINKLE_CHOICE
#undef WRINKLE_WIDTH

  bool operator==(const Config&) const = default;

  bool is(Datapath value) const { return datapath == static_cast<int>(value); }
  bool is(Lighting value) const { return lighting == static_cast<int>(value); }

  // Pu x Pv, Pv x N, N x Pu and a texture of fu, fv [Peercy97 fig. 2].
  bool has_blinn() const { return is(Datapath::kBlinn); }
  // A texture of normals [Peercy97 fig. 3].
  bool has_texture_normal() const { return is(Datapath::kTangent); }
  bool has_bump() const { return has_blinn() || has_texture_normal(); }
  // N interpolated; a normal that is perturbed and normalized. The rotated frame has N = (0, 0, 1).
  bool has_normal_planes() const { return is(Datapath::kPhong) || has_texture_normal(); }
  bool has_normal() const { return !is(Datapath::kRotated); }
  bool has_cross_planes() const {
    return has_blinn() && cross_products == static_cast<int>(CrossProducts::kInterpolated);
  }
  // L and H (or E) interpolated and normalized; else constants of the draw.
  bool has_light_planes() const { return light_vectors == static_cast<int>(LightVectorSource::kInterpolated); }
  // A third vector, H or the view vector E, and with it a highlight.
  bool has_specular() const { return !is(Lighting::kDiffuse); }
  bool has_view_vector() const { return is(Lighting::kReflection) || is(Lighting::kPixelHalfangle); }
  // Of what is interpolated in the place of H.
  int third_normalizer() const { return is(Lighting::kPixelHalfangle) ? normalizer_l : normalizer_h; }
  bool has_texture() const { return has_bump() || decal != 0; }
  bool trilinear() const { return filter == static_cast<int>(Filter::kTrilinear); }
  // Dot products of mantissas, scaled by the reciprocal lengths of both vectors.
  bool normalizes_after() const { return normalize_order == static_cast<int>(NormalizeOrder::kAfter); }
  // Of N, L and H as `normalize` hands them on: unit vectors in s1.F, or mantissas in s0.F.
  int normalized_width() const { return unit_bits + (normalizes_after() ? 1 : 2); }
  // RB: fraction bits of a reciprocal length, u1.RB.
  int scale_bits() const;
  // Bits of the mantissa of a vector that is normalized after: of magnitudes of V + 1 bits the leading F.
  int mantissa_bits(int input_bits) const { return input_bits < unit_bits ? input_bits + 1 : unit_bits; }
  int channel_count() const { return channels == 0 ? 1 : 3; }
  int vector_width() const { return vector_bits + 2; }
  int wide_width() const { return wide_bits + 2; }
  // The perturbed normal: s1.V, or s2.VW with Pu x Pv and its companions.
  int normal_vector_bits() const { return has_blinn() ? wide_bits : vector_bits; }
  int normal_vector_width() const { return has_blinn() ? wide_bits + 3 : vector_width(); }
  // V of the contract of the unit that normalizes N: its input is s1.V.
  int normal_unit_input_bits() const { return has_blinn() ? wide_bits + 1 : vector_bits; }
  int uv_width() const { return uv_integer_bits + uv_bits; }
  int lod_fraction_bits() const { return trilinear() ? lod_bits : 0; }
  int weight_fraction_bits() const { return filter == static_cast<int>(Filter::kNearest) ? 0 : weight_bits; }
  // D of the texture stage: fraction bits of a filtered texel code.
  int filter_fraction_bits() const { return 2 * weight_fraction_bits() + lod_fraction_bits(); }
  // Left shift that makes every right shift of u and v to texel units at least 1, for sizes up to kMaxLog2Size.
  int coordinate_shift() const {
    const int fraction = kMaxLog2Size + weight_fraction_bits() + 1;
    return fraction > uv_bits ? fraction - uv_bits : 0;
  }
  // Of the bump map: a normal, or fu and fv.
  int bump_components() const { return has_blinn() ? 2 : has_texture_normal() ? 3 : 0; }
  int texel_components() const { return bump_components() + (decal != 0 ? 3 : 0); }
  // Words of a draw packet.
  int draw_words() const { return has_light_planes() ? 4 : 6; }
  int edge_bits() const { return screen_bits + subpixel_bits + 2; }
  int screen_size() const { return 1 << screen_bits; }
};

// What parameters.def says of one parameter.
struct Parameter {
  std::string_view name;
  int Config::*member;
  int standard;
  int minimum, maximum;                  // of a choice: 0 and the number of values less 1
  std::vector<std::string_view> values;  // names of a choice; empty for a width
  std::string_view description;
};
std::span<const Parameter> parameters();

// The first rule the configuration breaks; empty key when it is legal.
struct IllegalParameter {
  std::string key;
  std::string message;  // value, legal range, and why
};
IllegalParameter check(const Config& config);

// Bits of the widest intermediate of the pixel stages, sign included, and so the lane the golden model needs: 32 or 64.
// A configuration must be legal.
int widest_operand_bits(const Config& config);
int lane_bits(const Config& config);

}  // namespace wrinkle

// A configuration of the hardware: which parts are there and how wide they are.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wrinkle {

enum class Datapath { kPhong, kTangent };
enum class Lighting { kDiffuse, kHalfangle };
enum class Normalizer { kNone, kFaithful };
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

  bool has_bump() const { return datapath == static_cast<int>(Datapath::kTangent); }
  bool has_texture() const { return has_bump() || decal != 0; }
  bool has_halfangle() const { return lighting == static_cast<int>(Lighting::kHalfangle); }
  bool trilinear() const { return filter == static_cast<int>(Filter::kTrilinear); }
  int channel_count() const { return channels == 0 ? 1 : 3; }
  int vector_width() const { return vector_bits + 2; }
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
  int texel_components() const { return (has_bump() ? 3 : 0) + (decal != 0 ? 3 : 0); }
  int edge_bits() const { return screen_bits + subpixel_bits + 2; }
  int screen_size() const { return 1 << screen_bits; }
};

// What parameters.def says of one parameter.
struct Parameter {
  std::string_view name;
  int Config::*member;
  int standard;
  int minimum, maximum;                      // of a choice: 0 and the number of values less 1
  std::vector<std::string_view> values;      // names of a choice; empty for a width
  std::string_view description;
};
std::span<const Parameter> parameters();

// The first rule the configuration breaks; empty key when it is legal.
struct IllegalParameter {
  std::string key;
  std::string message;                       // value, legal range, and why
};
IllegalParameter check(const Config& config);

// Bits of the widest intermediate of the pixel stages, sign included, and so the lane the golden model needs: 32 or 64.
// A configuration must be legal.
int widest_operand_bits(const Config& config);
int lane_bits(const Config& config);

}  // namespace wrinkle

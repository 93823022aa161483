// What a datapath must say, and how to ask the one that a configuration has.
//
// A datapath is a struct in golden/datapath/NAME.h, a line of list.def, and rtl/perturb/wrinkle_perturb_NAME.v. Nothing
// else asks which datapath there is: what a stage must know has a name of its own in properties.def or below.
#pragma once

#include <array>
#include <span>
#include <stdexcept>
#include <string_view>

#include "golden/config/values.h"
#include "golden/texel/grid.h"
#include "golden/texel/texture.h"
#include "golden/texel/wrap.h"
#include "golden/vector.h"

namespace wrinkle {

// An expression in the names of parameters: its value for a configuration, and its text for the Verilog.
struct Expression {
  int value;
  std::string_view text;
};

// A property of properties.def: WRINKLE_SAYS(frame_width, vector_bits + 2).
#define WRINKLE_SAYS(property, expression) \
  Expression property() const { return {static_cast<int>(expression), #expression}; }

// The space that a draw lights in: the world's; that of the texture of a bumped draw (tangent or object space), else
// the world's; tangent space, with a texture or without.
enum class DrawSpace { kWorld, kOfTexture, kTangent };

// A vertex as it is prepared for a bumped draw: its tangent frame in the world, the derivatives of P by the texture's
// coordinates (u, v upwards) in the world, whether the slopes of the texture are by those or by lengths along T and B,
// and what the components of the texture were divided by.
struct VertexInputs {
  Vec3 N, T, B;
  Vec3 Pu, Pv;
  bool has_derivatives = false;
  double bump_scale = 1;
};
// What the texels of a draw are made from: a texture whose bump map is a normal, and the height field of it where the
// datapath asks for it and there is one.
struct TexelInputs {
  const ExactTexture& normals;
  const Grid<double>* heights;
  int texel_bits;
  Wraps wraps;  // of the draw: they say what lies beyond the edges of the heights
};
using FrameVectors = std::array<Vec3, kMaxFrameVectors>;
// The components of a texel of the bump map, filtered.
using BumpComponents = std::array<double, kMaxBumpComponents>;

// What is not said by a datapath: the defaults of properties.def.
struct DatapathDefaults : Config {
  // False: there is no N', it is (0, 0, 1). Else the datapath has perturb_lanes() and exact().
  static constexpr bool kPerturbs = true;

  // The space that a bumped draw lights in, and what is turned round where its back is seen.
  static constexpr DrawSpace kSpace = DrawSpace::kWorld;
  static constexpr bool kTurnsLight = false;
  // The height field is wanted for the texels, where there is one.
  static constexpr bool kTexelsFromHeights = false;

  explicit DatapathDefaults(const Config& config) : Config(config) {}

  // Names of the vectors in the place of N, and of the bump map, as values.
  static constexpr std::array<std::string_view, 0> frame_names() { return {}; }
  static constexpr std::string_view bump_name() { return {}; }

  // The texels, with whatever the components of the bump map were divided by.
  static ExactTexture texels(const TexelInputs& in) { return in.normals; }

  // The vectors at a vertex of a bumped draw, of a datapath that says frame_prepared.
  static FrameVectors vertex(const VertexInputs&) { return {}; }
#define WRINKLE_PROPERTY(scope, name, standard, description) WRINKLE_SAYS(name, standard)
#include "golden/datapath/properties.def"
#undef WRINKLE_PROPERTY
};

}  // namespace wrinkle

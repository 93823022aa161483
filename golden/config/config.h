// A configuration of the hardware: which parts are there and how wide they are.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wrinkle {

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
#define WRINKLE_CHOICE(scope, name, standard, values, description) int name = standard;
#define WRINKLE_WIDTH(scope, name, standard, minimum, maximum, description) int name = standard;
#include "golden/config/parameters.def"
#undef WRINKLE_CHOICE
#undef WRINKLE_WIDTH

  bool operator==(const Config&) const = default;

  bool is(Lighting value) const { return lighting == static_cast<int>(value); }
  int screen_size() const { return 1 << screen_bits; }
};

// The numbers of properties.def, as the datapath of a configuration says them.
struct DatapathProperties {
#define WRINKLE_PROPERTY(scope, name, standard, description) int name;
#include "golden/datapath/properties.def"
#undef WRINKLE_PROPERTY
};
DatapathProperties datapath_properties(const Config& config);

// A configuration with all that follows from it: one int per line of properties.def and of derived.def. Every choice
// must be in its range.
struct Shape : Config, DatapathProperties {
  // NOLINTNEXTLINE: whatever reads a shape takes a configuration.
  Shape(const Config& config) : Config(config), DatapathProperties(datapath_properties(config)) {}

#define WRINKLE_DERIVED(scope, name, expression, description) int name = expression;
#include "golden/config/derived.def"
#undef WRINKLE_DERIVED
};

// Whom a parameter or a derived value is for: the Verilog too, the golden model alone, or set-up alone.
enum class Scope { core, golden, set_up };

// What parameters.def says of one parameter.
struct Parameter {
  Scope scope;
  std::string_view name;
  int Config::*member;
  int standard;
  int minimum, maximum;                  // of a choice: 0 and the number of values less 1
  std::vector<std::string_view> values;  // names of a choice; empty for a width
  std::string_view description;
};
std::span<const Parameter> parameters();

// A property of a datapath, or a derived value.
struct DerivedValue {
  Scope scope;
  std::string_view name;
  int Shape::*member;
  std::string_view expression;  // of a property: what stands for a datapath that does not say it
  std::string_view description;
};
std::span<const DerivedValue> properties();
std::span<const DerivedValue> derived_values();

// What rules.def says of one rule.
struct Rule {
  std::string_view name, key, condition, message;
};
std::span<const Rule> rules();

// The first rule the configuration breaks; empty key when it is legal.
struct IllegalParameter {
  std::string key;
  std::string message;  // value, legal range, and why
};
IllegalParameter check(const Config& config);

}  // namespace wrinkle

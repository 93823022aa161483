// What a datapath must say, and how to ask the one that a configuration has.
//
// A datapath is a struct in golden/datapath/NAME.h, a line of list.def, and rtl/perturb/wrinkle_perturb_NAME.v. Nothing
// else asks which datapath there is: what a stage must know has a name of its own in properties.def or below.
#pragma once

#include <stdexcept>
#include <string_view>

#include "golden/config/config.h"

namespace wrinkle {

// An expression in the names of parameters: its value for a configuration, and its text for the Verilog.
struct Expression {
  int value;
  std::string_view text;
};

// A property of properties.def: WRINKLE_SAYS(frame_width, vector_bits + 2).
#define WRINKLE_SAYS(property, expression) \
  Expression property() const { return {static_cast<int>(expression), #expression}; }

// What is not said by a datapath: the defaults of properties.def.
struct DatapathDefaults : Config {
  explicit DatapathDefaults(const Config& config) : Config(config) {}
#define WRINKLE_PROPERTY(scope, name, standard, description) WRINKLE_SAYS(name, standard)
#include "golden/datapath/properties.def"
#undef WRINKLE_PROPERTY
};

}  // namespace wrinkle

#include "golden/config/tables.h"

#include <vector>

#include "golden/datapath/datapaths.h"

namespace wrinkle {
namespace {

std::string row(const std::vector<std::string>& cells) {
  std::string text = "|";
  for (const std::string& cell : cells) {
    text += ' ';
    for (const char c : cell) text += c == '|' ? std::string("\\|") : std::string(1, c);
    text += " |";
  }
  return text + "\n";
}

std::string code(std::string_view text) { return "`" + std::string(text) + "`"; }

std::string parameter_rows() {
  std::string text = row({"key", "values", "default", "what it is"}) + "| --- | --- | --- | --- |\n";
  for (const Parameter& p : parameters()) {
    std::string values = std::to_string(p.minimum) + " to " + std::to_string(p.maximum);
    std::string standard = std::to_string(p.standard);
    if (!p.values.empty()) {
      values.clear();
      for (std::string_view value : p.values) values += (values.empty() ? "" : ", ") + code(value);
      standard = code(p.values[static_cast<std::size_t>(p.standard)]);
    }
    text += row({code(p.name), values, standard, std::string(p.description)});
  }
  return text;
}

std::string rule_rows() {
  std::string text = row({"key", "is refused where", "because"}) + "| --- | --- | --- |\n";
  for (const Rule& rule : rules()) text += row({code(rule.key), code(rule.condition), std::string(rule.message)});
  return text;
}

std::string property_rows() {
  std::vector<std::string> head{"property"};
  std::string line = "| --- |";
  for_each_datapath({}, [&](std::string_view name, const auto&) {
    head.push_back(code(name));
    line += " --- |";
  });
  head.emplace_back("what it is");
  std::string text = row(head) + line + " --- |\n";
#define WRINKLE_PROPERTY(scope, name, standard, description)                                      \
  {                                                                                               \
    std::vector<std::string> cells{code(#name)};                                                  \
    for_each_datapath({}, [&](auto, const auto& said) { cells.emplace_back(said.name().text); }); \
    cells.emplace_back(description);                                                              \
    text += row(cells);                                                                           \
  }
#include "golden/datapath/properties.def"
#undef WRINKLE_PROPERTY
  return text;
}

std::string derived_rows() {
  std::string text = row({"name", "expression", "what it is"}) + "| --- | --- | --- |\n";
  for (const DerivedValue& value : derived_values())
    text += row({code(value.name), code(value.expression), std::string(value.description)});
  return text;
}

// An expression of values.def without the name of its configuration.
std::string plain(std::string_view expression) {
  std::string text;
  for (std::size_t i = 0; i < expression.size(); ++i) {
    if (expression.substr(i, 2) == "c." && (i == 0 || expression[i - 1] == ' ' || expression[i - 1] == '('))
      ++i;
    else
      text += expression[i];
  }
  return text;
}

std::string value_rows() {
  std::string text = row({"stage", "value", "elements", "bits", "fraction bits", "signed", "where"}) +
                     "| --- | --- | --- | --- | --- | --- | --- |\n";
#define WRINKLE_VALUE(stage, name, elements, width, fraction_bits, is_signed, present, kind)            \
  text += row({#stage, code(#name), plain(#elements), code(plain(#width)), code(plain(#fraction_bits)), \
               is_signed ? "yes" : "no", std::string_view(#present) == "true" ? "always" : code(plain(#present))});
#define WRINKLE_FRAME(stage, name, reader)                                                                       \
  for (const char k : {'0', '1', '2'}) {                                                                         \
    const std::string vector = std::string("frame_") + k;                                                        \
    text += row({#stage, code(std::string(#name " ") + k), "3", code(vector + "_width"), code(vector + "_bits"), \
                 "yes", code(vector + "_width != 0")});                                                          \
  }
#define WRINKLE_BUMP(stage, name)                                                                        \
  text += row({#stage, code(#name), "bump_components", code("bump_width"), code("bump_fraction"), "yes", \
               code("bump_components != 0")});
#include "golden/values.def"
  return text;
}

std::string stage_rows() {
  std::string text = row({"stage", "latency"}) + "| --- | --- |\n";
#define WRINKLE_STAGE(name, title, moves, latency) text += row({#name, code(plain(#latency))});
#include "golden/stages.def"
#undef WRINKLE_STAGE
  return text;
}

}  // namespace

std::string parameter_page() {
  return "# Parameters and what follows from them\n\n"
         "This page is made by `./wrinkle generate` from `golden/config/*.def`, `golden/datapath`, "
         "`golden/stages.def` and `golden/values.def`; change those.\n\n"
         "## Parameters\n\nA key of a configuration file, and in capitals a parameter of `wrinkle_core`.\n\n" +
         parameter_rows() + "\n## Rules\n\nWhat is illegal besides a value out of its range, in both languages.\n\n" +
         rule_rows() + "\n## Datapaths\n\nWhat each datapath says of itself in `golden/datapath/NAME.h`.\n\n" +
         property_rows() +
         "\n## Derived values\n\nMembers of `Shape`, and in capitals local parameters of `wrinkle_core`.\n\n" +
         derived_rows() +
         "\n## Stages\n\nThe clocks that each takes of the way of a packet's first fragment, from the last word of the "
         "packet to the port, where nothing stalls and the memory answers in the clock after a request.\n\n" +
         stage_rows() +
         "\n## Values\n\nWhat crosses a stage. The vectors of `frame` and the components of `bump` have the names that "
         "the "
         "datapath gives them.\n\n" +
         value_rows();
}

}  // namespace wrinkle

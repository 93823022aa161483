#include "golden/config/verilog.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include "golden/datapath/datapaths.h"

namespace wrinkle {
namespace {

constexpr std::string_view kHead =
    R"(// What wrinkle_core can be: its parameters, what follows from them, and which of them are illegal together. Made by
// `./wrinkle generate` from golden/config/*.def and golden/datapath/*.h; change those. The file is included once for each
// of its sections, with the macro defined that selects it:
//
//   WRINKLE_PARAMETERS   in a parameter list: every parameter with its default
//   WRINKLE_DERIVED      in a module: local parameters, which nobody can override
//   WRINKLE_RULES        in a module: an illegal configuration stops the elaboration in every tool, by an instance of a
//                        module that does not exist and whose name says the fault; a legal one leaves nothing
)";

constexpr std::size_t kColumns = 120;

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size(), width), ' ');
  return text;
}

std::string joined(const std::vector<std::string_view>& words, char separator) {
  std::string text;
  for (std::string_view word : words) text += (text.empty() ? "" : std::string(1, separator)) + std::string(word);
  return text;
}

std::string section(std::string_view macro, const std::string& body) {
  return "\n`ifdef " + std::string(macro) + "\n" + body + "`endif\n";
}

std::string parameter_list() {
  std::vector<const Parameter*> list;
  std::size_t width = 0;
  for (const Parameter& parameter : parameters()) {
    if (parameter.scope != Scope::core) continue;
    list.push_back(&parameter);
    width = std::max(width, parameter.name.size());
  }
  std::string text;
  for (const Parameter* p : list) {
    const std::string value = std::to_string(p->standard) + (p == list.back() ? "" : ",");
    const std::string what =
        p->values.empty() ? std::to_string(p->minimum) + " to " + std::to_string(p->maximum) : joined(p->values, '|');
    const std::string line =
        "  parameter " + padded(verilog_text(p->name), width) + " = " + padded(value, 3) + " // " + what;
    const std::string described = line + "; " + std::string(p->description);
    text += (described.size() <= kColumns ? described : line) + "\n";
  }
  return text;
}

// An expression between `?` and `:`.
std::string operand(const std::string& expression) {
  return expression.find('?') == expression.npos ? expression : "(" + expression + ")";
}

// `DATAPATH == 0 ? X : DATAPATH == 1 ? Y : ...`, or X alone where all say the same.
std::string by_datapath(const std::vector<std::string>& said) {
  if (std::all_of(said.begin(), said.end(), [&](const std::string& s) { return s == said.front(); }))
    return said.front();
  std::string text;
  for (std::size_t i = 0; i + 1 < said.size(); ++i)
    text += "DATAPATH == " + std::to_string(i) + " ? " + operand(said[i]) + " : ";
  return text + said.back();
}

// One line a value, the description above it where both do not fit.
std::string local_parameter(std::string_view name, const std::string& expression, std::string_view description) {
  const std::string line = "  localparam " + verilog_text(name) + " = " + expression + ";";
  const std::string comment = "// " + std::string(description);
  if (line.size() + 2 + comment.size() <= kColumns) return line + "  " + comment + "\n";
  return "  " + comment + "\n" + line + "\n";
}

std::string derived() {
  std::string text;
#define WRINKLE_PROPERTY(scope, name, standard, description)                                                        \
  if (Scope::scope == Scope::core) {                                                                                \
    std::vector<std::string> said;                                                                                  \
    for_each_datapath({}, [&](auto, const auto& datapath) { said.push_back(verilog_text(datapath.name().text)); }); \
    text += local_parameter(#name, by_datapath(said), description);                                                 \
  }
#include "golden/datapath/properties.def"
#undef WRINKLE_PROPERTY
  for (const DerivedValue& value : derived_values())
    if (value.scope == Scope::core)
      text += local_parameter(value.name, verilog_text(value.expression), value.description);
  return text;
}

std::string refusal(std::string_view condition, const std::string& block, const std::string& fault) {
  return "    if (" + std::string(condition) + ") begin : " + block + "\n      wrinkle_error_" + fault +
         " error ();\n    end\n";
}

std::string rule_book() {
  std::string text = "  generate\n";
  for (const Parameter& p : parameters()) {
    if (p.scope != Scope::core) continue;
    const std::string name = verilog_text(p.name), low = std::to_string(p.minimum), high = std::to_string(p.maximum);
    text += refusal(name + " < " + low + " || " + name + " > " + high, std::string(p.name) + "_range",
                    std::string(p.name) + "_is_not_" + low + "_to_" + high);
  }
  for (const Rule& rule : rules())
    text += refusal(verilog_text(rule.condition), std::string(rule.name), std::string(rule.name));
  return text + "  endgenerate\n";
}

}  // namespace

std::string verilog_text(std::string_view expression) {
  std::string text(expression);
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

std::string verilog_config() {
  return std::string(kHead) + section("WRINKLE_PARAMETERS", parameter_list()) + section("WRINKLE_DERIVED", derived()) +
         section("WRINKLE_RULES", rule_book());
}

}  // namespace wrinkle

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
//   WRINKLE_SECTION_PARAMETERS   in a parameter list: every parameter with its default and its range
//   WRINKLE_SECTION_DERIVED      in a module: local parameters, which nobody can override
//   WRINKLE_SECTION_RULES        in a module: an illegal configuration stops the elaboration in every tool, by an
//                                instance of a module that does not exist and whose name says the fault
//   WRINKLE_SECTION_PERTURB      in wrinkle_core: the perturb stage of the datapath
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
    const std::string what = std::to_string(p->minimum) + " to " + std::to_string(p->maximum) +
                             (p->values.empty() ? "" : ": " + joined(p->values, '|'));
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

// A line broken at spaces where it is too long.
std::string folded(std::string line) {
  std::string text;
  while (line.size() > kColumns) {
    const std::size_t end = line.rfind(' ', kColumns);
    text += line.substr(0, end) + "\n";
    line = "    " + line.substr(end + 1);
  }
  return text + line;
}

// One line a value, the description above it where both do not fit.
std::string local_parameter(std::string_view name, const std::string& expression, std::string_view description) {
  const std::string line = "  localparam " + verilog_text(name) + " = " + expression + ";";
  const std::string comment = "// " + std::string(description);
  if (line.size() + 2 + comment.size() <= kColumns) return line + "  " + comment + "\n";
  return "  " + comment + "\n" + folded(line) + "\n";
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
  return folded("    if (" + std::string(condition) + ") begin : " + block) + "\n      wrinkle_error_" + fault +
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

// The fields of `interpolate` in the order of the planes part of a packet, from its first bit.
struct Field {
  std::string_view elements, width, held;
  int reader;  // the stage that reads it first: 1 perspective, 2 texture, 3 perturb, 4 normalize, 5 light, 6 output
};
constexpr Field kFields[] = {
    {"FRAME_0_ELEMENTS", "FRAME_0_WIDTH", "FRAME_0_HELD", 3},
    {"FRAME_1_ELEMENTS", "FRAME_1_WIDTH", "FRAME_1_HELD", 3},
    {"FRAME_2_ELEMENTS", "FRAME_2_WIDTH", "FRAME_2_HELD", 3},
    {"L_VECTOR_ELEMENTS", "LIGHT_WIDTH", "", 4},
    {"H_VECTOR_ELEMENTS", "LIGHT_WIDTH", "", 4},
    {"TEXTURED", "UV", "", 1},
    {"TEXTURED", "UV", "", 1},
    {"Q_ELEMENTS", "Q", "", 1},
    {"LOD_PLANE_ELEMENTS", "LOD_PLANE", "", 2},
    {"Z_ELEMENTS", "Z", "", 6},
    {"LOD_HELD_ELEMENTS", "LOD_HELD", "1", 2},
};

// A packed vector of 32 bits a field; the last field comes first, as in every concatenation.
template <class Text>
std::string field_vector(std::string_view name, const Text& text_of) {
  std::string text = "  localparam [32*FIELDS-1:0] " + std::string(name) + " = {";
  for (std::size_t i = std::size(kFields); i-- > 0;)
    text += "\n    32'd" + std::string(text_of(kFields[i])) + (i == 0 ? "};\n" : ",");
  return text;
}

std::string field_vectors() {
  const auto value = [](std::string_view name) { return "0 | " + std::string(name) + "[31:0]"; };
  return "  // The list of wrinkle_interpolate: of each field the number of elements, the bits of one, whether it is "
         "held over\n"
         "  // a triangle, and the stage that reads it first: 1 perspective, 2 texture, 3 perturb, 4 normalize, 6 "
         "output.\n"
         "  localparam FIELDS = " +
         std::to_string(std::size(kFields)) + ";\n" +
         field_vector("FIELD_ELEMENTS", [&](const Field& field) { return value(field.elements); }) +
         field_vector("FIELD_WIDTHS", [&](const Field& field) { return value(field.width); }) +
         field_vector("FIELD_HELD",
                      [&](const Field& field) {
                        return field.held.empty() ? "0" : field.held == "1" ? "1" : value(field.held);
                      }) +
         field_vector("FIELD_READERS", [&](const Field& field) { return std::to_string(field.reader); });
}

// The one stage that a datapath has of its own; all have the same ports.
std::string perturb_stage() {
  std::string text = "  generate\n";
  int number = 0;
  for_each_datapath({}, [&](std::string_view name, const auto&) {
    text += (number == 0 ? "    if" : " else if") + std::string(" (DATAPATH == ") + std::to_string(number) +
            ") begin : " + std::string(name) + "\n      wrinkle_perturb_" + std::string(name) +
            R"( #(.FRAME(FRAME), .BUMP(BUMP), .NORMAL(NORMAL), .CARRY(PERTURB_CARRY)) perturb (
        .clk(clk), .rst(rst), .draw_bump_i(draw_bump), .in_valid_i(texture_valid), .in_ready_o(texture_ready),
        .frame_i(texture_frame), .bump_i(texture_bump), .carry_i(texture_others), .out_valid_o(perturb_valid),
        .out_ready_i(perturb_ready), .n_o(perturb_n), .carry_o(perturb_others), .busy_o(perturb_busy));
    end)";
    ++number;
  });
  return text + "\n  endgenerate\n";
}

}  // namespace

std::string verilog_text(std::string_view expression) {
  std::string text(expression);
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

std::string verilog_config() {
  return std::string(kHead) + section("WRINKLE_SECTION_PARAMETERS", parameter_list()) +
         section("WRINKLE_SECTION_DERIVED", derived() + field_vectors()) +
         section("WRINKLE_SECTION_RULES", rule_book()) + section("WRINKLE_SECTION_PERTURB", perturb_stage());
}

}  // namespace wrinkle

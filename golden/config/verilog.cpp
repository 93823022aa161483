#include "golden/config/verilog.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include "golden/datapath/datapaths.h"
#include "golden/stages.h"

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

// A field of `interpolate`: Verilog expressions, and the stage that reads it first.
struct Field {
  std::string name, present, elements, width, held;
  Stage reader;
};

// An expression of values.def in the names of the Verilog.
std::string of_shape(std::string_view expression) {
  std::string text(expression);
  for (std::size_t at = 0; (at = text.find("c.", at)) != text.npos;) text.erase(at, 2);
  return verilog_text(text);
}

// In the order of the planes part of a packet, from its first bit: the planes of values.def, then the level of detail
// where it is held, which has no sign there and is below 16.
std::vector<Field> fields() {
  std::vector<Field> list, last;
#define WRINKLE_FRAME(stage, name, reader)                                                                     \
  for (const char k : {'0', '1', '2'}) {                                                                       \
    const std::string vector = verilog_text(#name "_") + k;                                                    \
    list.push_back({vector, vector + "_WIDTH != 0", "3", vector + "_WIDTH", vector + "_HELD", Stage::reader}); \
  }
#define WRINKLE_PLANE(name, elements, width, fraction_bits, is_signed, present, reader) \
  list.push_back({verilog_text(#name), of_shape(#present), #elements, of_shape(#width), "0", Stage::reader});
#define WRINKLE_LEVEL(name, width, fraction_bits, present, reader)                                                \
  list.push_back(                                                                                                 \
      {verilog_text(#name), of_shape(#present) + " && DIVIDES != 0", "1", of_shape(#width), "0", Stage::reader}); \
  last.push_back({verilog_text(#name "_held"), of_shape(#present) + " && DIVIDES == 0", "1",                      \
                  of_shape(#width) + " - 2", "1", Stage::reader});
#include "golden/values.def"
  list.insert(list.end(), last.begin(), last.end());
  return list;
}

// A packed vector of 32 bits a field; the last field comes first, as in every concatenation.
template <class Text>
std::string field_vector(std::string_view name, const std::vector<Field>& list, const Text& text_of) {
  std::string text = "  localparam [32*FIELDS-1:0] " + std::string(name) + " = {";
  for (std::size_t i = list.size(); i-- > 0;)
    text += "\n    32'd" + std::string(text_of(list[i])) + (i == 0 ? "};\n" : ",");
  return text;
}

std::string field_vectors() {
  const std::vector<Field> list = fields();
  std::string text =
      "  // The list of wrinkle_interpolate: of each field the number of elements, the bits of one, whether it is held "
      "over\n  // a triangle, and how many stages further on it is first read.\n  localparam FIELDS = " +
      std::to_string(list.size()) + ";\n";
  std::string bits;
  for (const Field& f : list) {
    const std::string elements = "FIELD_" + f.name + "_ELEMENTS", width = "FIELD_" + f.name + "_WIDTH";
    text += folded("  localparam " + elements + " = " + f.present + " ? " + f.elements + " : 0;") + "\n";
    text += folded("  localparam " + width + " = " + f.width + ";") + "\n";
    const std::string of_plane = "3 * (" + width + " + GUARD_BITS)";
    bits += (bits.empty() ? "" : " + ") + elements + " * " +
            (f.held == "0"   ? of_plane
             : f.held == "1" ? width
                             : "(" + f.held + " != 0 ? " + width + " : " + of_plane + ")");
  }
  const auto value = [](const std::string& name) { return "0 | " + name + "[31:0]"; };
  text += local_parameter("plane_bits", bits, "bits of the planes part of a packet");
  text += local_parameter("plane_words", "(PLANE_BITS + 63) / 64", "its words");
  text += field_vector("FIELD_ELEMENTS", list, [&](const Field& f) { return value("FIELD_" + f.name + "_ELEMENTS"); });
  text += field_vector("FIELD_WIDTHS", list, [&](const Field& f) { return value("FIELD_" + f.name + "_WIDTH"); });
  text += field_vector("FIELD_HELD", list, [&](const Field& f) { return f.held.size() == 1 ? f.held : value(f.held); });
  text += field_vector("FIELD_READERS", list, [&](const Field& f) {
    return std::to_string(static_cast<int>(f.reader) - static_cast<int>(Stage::interpolate));
  });
  return text;
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

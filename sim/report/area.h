// Area by stage: every stage of a configuration synthesised alone, and all of them flat.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "golden/config/config.h"
#include "sim/synthesis/synthesis.h"

namespace wrinkle {

struct StageArea {
  std::string stage;
  SynthesisResult result;
  // Of Fig. 1 to 3: a part that the paper takes as given (scan, texture unit, texture coordinates).
  bool given = false;
};

struct AreaReport {
  std::string name;  // of the configuration
  std::string library;
  std::vector<StageArea> stages;
  SynthesisResult flat;  // the whole; no cells when it was not asked for
  // um2 of stages that are counted but are not in the flat netlist: of Fig. 1, the texture unit of Fig. 3.
  double lent_um2 = 0;

  double sum_um2() const;
  double sum_nand2() const;
  int flip_flops() const;
  // The longest of the stages and of flat.
  double critical_path_ns() const;
  // Of the stages together, how many clocks a netlist and its Verilog were compared: the fewest of any.
  int clocks_equal() const;
  // (sum of stages in the flat netlist - flat) / flat; 0 without flat.
  double deviation() const;
};

struct AreaOptions {
  CellLibrary library = CellLibrary::kOsu035;
  bool flat = true;
  std::vector<std::string> stages;  // empty: all
  SynthesisOptions synthesis;
  SynthesisProgress progress;
};

// Two stages at a time.
AreaReport measure_area(const std::string& name, const Config& config, const AreaOptions& options);

// What shades by [Peercy97 fig. 3], or by fig. 1 with datapath = phong, and nothing else: interpolators of N, L and H,
// multiplexer, normalization, dot products and power, with x and y carried along. `interpolate` of the configuration
// without texture, decal, gloss and depth; `perturb`, `normalize`, `light` without decal, gloss and depth. Two stages
// at a time. Throws std::invalid_argument for another datapath.
AreaReport measure_shading(const std::string& name, const Config& config, const AreaOptions& options);

// [Peercy97 fig. 1, 2 and 3] with everything around them alike: packets, scan, interpolation, normalization, light and
// output at the widths of `standard`, without self-shadow, which the figures do not have. What the paper takes as given
// counts in all three and is marked: scan, texture unit, and `texture coordinates`, the interpolators and draw state of
// u, v and level of detail. Fig. 1 has the very texture unit of Fig. 3.
struct Figures {
  AreaReport fig1, fig2, fig3;
};
Figures measure_figures(const Config& phong, const Config& blinn, const Config& tangent, const AreaOptions& options);

// One normalizer at V = F without its registers: its logic alone, and the path through all of its ranks.
struct NormalizerArea {
  Normalizer kind;
  int unit_bits;  // F
  SynthesisResult result;
};

// Widths that are measured.
const std::vector<int> kNormalizerWidths{8, 9, 10, 12, 16};

// Every kind but `none`, at every F given.
std::vector<NormalizerArea> measure_normalizers(const std::vector<int>& unit_bits, const AreaOptions& options);

// Of Parameter::values of normalizer_n.
std::string normalizer_name(Normalizer kind);

// "2 of 11 x 11, 1 of 9 x 8"; "-" for none.
std::string multiplier_text(const std::vector<Multiplier>& multipliers);

nlohmann::json to_json(const AreaReport& report);
nlohmann::json to_json(const Figures& figures);
nlohmann::json to_json(const NormalizerArea& area);

}  // namespace wrinkle

// Figs. 5, 6 and 7 of [Peercy97] drawn and compared, and what else the paper says of pictures, as numbers.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/command.h"
#include "sim/engine.h"
#include "sim/picture.h"

namespace wrinkle {

struct PaperOptions {
  Engine engine = Engine::kRtl;  // of the pictures; the RTL is compared with golden, fragment by fragment
  int size = 512;                // pixels, both ways
  RtlOptions rtl;
};

// A picture, and the name of its file without the ending.
struct NamedPicture {
  std::string name;
  Picture picture;
};

struct PaperFigures {
  // `figures`, `pairs`, `tessellation`, `held`, `highlight`, `warp` and more: docs/commands.md.
  nlohmann::json results;
  std::vector<NamedPicture> pictures;  // of the engine: fig5, fig6, fig7, their differences, and those of the others
  std::vector<NamedPicture> sheets;    // pictures side by side: figures, held, highlight
  bool equal = true;                   // the RTL drew what golden does, wherever the RTL was asked for
};
PaperFigures draw_paper_figures(const PaperOptions& options);

}  // namespace wrinkle

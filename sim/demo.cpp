// demo: the paper's patch, Newell's teapot and a glTF model, by golden and RTL under random stalls, compared and drawn.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "sim/command.h"
#include "sim/comparison.h"
#include "sim/layout.h"
#include "sim/picture.h"
#include "sim/progress.h"
#include "sim/tessellation.h"

namespace wrinkle {
namespace {

struct Options {
  std::filesystem::path folder = "out", json;
  RtlOptions rtl;
};

std::vector<Comparison> entries() {
  std::vector<Comparison> list{{"fig1", "patch_fig1", {}, {}},
                               {"fig6", "patch_fig6", {}, {}},
                               {"fig7", "patch_fig7", {}, {}},
                               {"teapot", "teapot", {}, {}}};
  const std::filesystem::path assets = shared_assets();
  if (!assets.empty()) list.push_back({"avocado", (assets / "gltf/Avocado/glTF/Avocado.gltf").string(), {}, {}});
  return list;
}

int demo(const Options& options) {
  print_comparison_heading();
  nlohmann::json frames = nlohmann::json::array();
  std::vector<Picture> sheet;
  bool equal = true;
  for (const Comparison& entry : entries()) {
    frames.push_back(compare_engines(entry, options.rtl, options.folder, sheet));
    equal &= frames.back()["mismatches"] == 0;
  }
  if (shared_assets().empty()) fmt::print("avocado: left out, ../shared/assets is not here\n");
  const std::filesystem::path sheet_path = options.folder / "sheet.png";
  write_picture(sheet_path, contact_sheet(sheet, 3));
  fmt::print("{}: each frame, its method error and its precision error ({} times as large)\n", sheet_path.string(),
             kDifferenceGain);
  const nlohmann::json tessellation = tessellation_table();
  write_json(options.json,
             {{"equal", equal}, {"frames", frames}, {"sheet", sheet_path.string()}, {"tessellation", tessellation}});
  return equal ? kExitEqual : kExitDifferent;
}

}  // namespace

void add_demo(CLI::App& app, Action& run) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("demo", "The main job: the paper's pictures by golden and RTL, compared bit for bit");
  command->add_option("-o,--output", options->folder, "Folder for the pictures")->capture_default_str();
  add_rtl_options(*command, options->rtl);
  add_json_option(*command, options->json);
  command->callback([options, &run] { run = [options] { return demo(*options); }; });
}

}  // namespace wrinkle

#include "sim/tessellation.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "golden/vertex/tessellate.h"
#include "sim/command.h"
#include "sim/engine.h"
#include "sim/picture.h"

namespace wrinkle {
namespace {

constexpr int kDivisions[] = {4, 8, 16, 32};

void take_level_zero_alone(Object& object) {
  object.shadow = false;
  object.wrap_u = object.wrap_v = Wrap::kClamp;
  if (!object.texture) return;
  auto texture = std::make_shared<ExactTexture>(*object.texture);
  texture->levels.resize(1);
  object.texture = std::move(texture);
}

}  // namespace

DividedFrame divided_frame(const DividedPatch& patch) {
  Scene scene = scene_named(patch.scene);
  scene.width = scene.height = patch.size;
  DividedFrame result;
  result.config_name = patch.config.empty() ? scene.config : patch.config;
  result.config = chosen_config({}, result.config_name);
  if (patch.filtering == Filtering::kLevelZero) result.config.filter = static_cast<int>(Filter::kBilinear);
  for (Object& object : scene.objects) {
    object.mesh = tessellate(object.mesh.surfaces, patch.divisions, patch.divisions);
    result.triangles += object.mesh.triangles.size();
    if (patch.filtering == Filtering::kLevelZero) take_level_zero_alone(object);
  }
  result.frame = build_frame(result.config, scene);
  return result;
}

nlohmann::json method_error(const DividedPatch& patch) {
  const DividedFrame divided = divided_frame(patch);
  const Framebuffer golden = drawn(Engine::kGolden, divided.config, divided.frame);
  const Picture exact = drawn(Engine::kExact, divided.config, divided.frame).colour();
  const Picture ideal = drawn(Engine::kIdeal, divided.config, divided.frame).colour();
  const PictureDifference method = compare(exact, ideal, golden.covered());
  const PictureDifference precision = compare(golden.colour(), exact, golden.covered());
  return {{"scene", patch.scene},
          {"config", divided.config_name},
          {"divisions", patch.divisions},
          {"triangles", divided.triangles},
          {"psnr_method_db", method.psnr_db},
          {"max_error_method", method.max_error},
          {"psnr_precision_db", precision.psnr_db}};
}

nlohmann::json tessellation_table() {
  fmt::print("patch          squares  triangles  method dB  worst of 1  precision dB\n");
  nlohmann::json rows = nlohmann::json::array();
  for (const char* name : {"patch_fig1", "patch_fig6"}) {
    for (const int divisions : kDivisions) {
      const nlohmann::json& row = rows.emplace_back(method_error({name, "", divisions, 1024, {}}));
      fmt::print("{:<12} {:>9} {:>10} {:>10.2f} {:>11.4f} {:>13.2f}\n", name, fmt::format("{0}x{0}", divisions),
                 row["triangles"].get<int>(), row["psnr_method_db"].get<double>(),
                 row["max_error_method"].get<double>(), row["psnr_precision_db"].get<double>());
    }
  }
  return rows;
}

nlohmann::json method_table(int size) {
  constexpr struct {
    const char *method, *scene, *config;
  } kMethods[] = {{"fig1", "patch_fig1", "phong"},
                  {"fig2", "patch_fig5", "blinn"},
                  {"fig2_held", "patch_constant", "blinn_constant"},
                  {"fig3_eq3-6", "patch_fig6", "standard"},
                  {"fig3_eq8-11", "patch_fig7", "standard"}};
  nlohmann::json rows = nlohmann::json::array();
  for (const auto& [method, scene, config] : kMethods) {
    for (const Filtering filtering : {Filtering::kConfigured, Filtering::kLevelZero}) {
      const bool configured = filtering == Filtering::kConfigured;
      for (const int divisions : kDivisions) {
        rows.push_back(method_error({scene, config, divisions, size, filtering}));
        rows.back()["method"] = method;
        rows.back()["filtering"] = configured ? "configured" : "level0";
      }
    }
  }
  return rows;
}

}  // namespace wrinkle

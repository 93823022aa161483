#include "sim/tessellation.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "golden/vertex/tessellate.h"
#include "sim/command.h"
#include "sim/engine.h"
#include "sim/picture.h"

namespace wrinkle {
namespace {

constexpr int kSize = 1024;

Framebuffer drawn(Engine engine, const Config& config, const Frame& frame) {
  Framebuffer framebuffer = framebuffer_for(config, frame);
  draw(engine, config, frame, {}, [&](const Sample& sample) { framebuffer.add(sample); });
  return framebuffer;
}

nlohmann::json row(const std::string& name, int divisions) {
  Scene scene = scene_named(name);
  scene.width = scene.height = kSize;
  std::size_t triangles = 0;
  for (Object& object : scene.objects) {
    object.mesh = tessellate(object.mesh.surfaces, divisions, divisions);
    triangles += object.mesh.triangles.size();
  }
  const Config config = chosen_config({}, scene.config);
  const Frame frame = build_frame(config, scene);
  const Framebuffer golden = drawn(Engine::kGolden, config, frame);
  const Picture exact = drawn(Engine::kExact, config, frame).colour();
  const Picture ideal = drawn(Engine::kIdeal, config, frame).colour();
  const PictureDifference method = compare(exact, ideal, golden.covered());
  const PictureDifference precision = compare(golden.colour(), exact, golden.covered());
  fmt::print("{:<12} {:>9} {:>10} {:>10.2f} {:>11.4f} {:>13.2f}\n", name, fmt::format("{0}x{0}", divisions), triangles,
             method.psnr_db, method.max_error, precision.psnr_db);
  return {{"scene", name},
          {"divisions", divisions},
          {"triangles", triangles},
          {"psnr_method_db", method.psnr_db},
          {"max_error_method", method.max_error},
          {"psnr_precision_db", precision.psnr_db}};
}

}  // namespace

nlohmann::json tessellation_table() {
  fmt::print("patch          squares  triangles  method dB  worst of 1  precision dB\n");
  nlohmann::json rows = nlohmann::json::array();
  for (const char* name : {"patch_fig1", "patch_fig6"})
    for (int divisions : {4, 8, 16, 32}) rows.push_back(row(name, divisions));
  return rows;
}

}  // namespace wrinkle

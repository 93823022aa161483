// bench: clocks a pixel for triangles of several sizes, and how fast golden and RTL simulate.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "golden/pixel/pixel.h"
#include "sim/command.h"
#include "sim/progress.h"
#include "tb/cpu_time.h"

namespace wrinkle {
namespace {

struct Options {
  ConfigOptions config;
  std::string scene = "patch_fig6";
  int runs = 5;
  std::filesystem::path json;
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

ScreenVertex corner(const Config& config, int x, int y) {
  ScreenVertex v;
  v.x = x << config.subpixel_bits;
  v.y = y << config.subpixel_bits;
  v.z = 0.5;
  v.uv = {x / 512.0, y / 512.0};
  v.N = v.H = {0, 0, 1};
  v.L = normalize(Vec3{0.3, 0.2, 1});
  return v;
}

// A textured screen of 512 by 512 pixels, cut into squares of `side` pixels with two triangles each. It has the draw
// state of `like`.
Frame squares(const Config& config, const Frame& like, int side) {
  Frame frame;
  frame.name = fmt::format("squares of {}", side);
  frame.width = frame.height = 512;
  frame.textures = like.textures;
  Draw& draw = frame.draws.emplace_back();
  draw.state = like.draws.front().state;
  for (int y = 0; y + side <= 512; y += side)
    for (int x = 0; x + side <= 512; x += side) {
      const ScreenVertex a = corner(config, x, y), b = corner(config, x + side, y);
      const ScreenVertex c = corner(config, x + side, y + side), d = corner(config, x, y + side);
      for (const auto& v : {std::array{a, b, c}, std::array{a, c, d}}) {
        ScreenTriangle t;
        t.v = v;
        t.id = std::uint32_t(draw.triangles.size());
        draw.triangles.push_back(t);
      }
    }
  return frame;
}

nlohmann::json throughput(const Config& config, const Frame& like) {
  nlohmann::json result;
  for (const auto& [key, side] : {std::pair{"quad", 512}, {"t64", 64}, {"t16", 16}, {"t6", 6}}) {
    BenchOptions options = quiet_bench_options();
    const BenchResult run = run_bench(config, squares(config, like, side), options);
    const double rate = double(run.fragments) / double(run.cycles);
    fmt::print("{:<5} {:>7} pixels {:>8} clocks  {:.3f} pixels per clock{}\n", key, run.fragments, run.cycles, rate,
               run.equal() ? "" : "  DIFFERENT FROM GOLDEN");
    result[key] = rate;
  }
  return result;
}

// Fragments per second of CPU time of one instance of the golden model, over enough frames to be measured.
double golden_rate(const Config& config, const PacketStream& stream, const std::vector<Texture>& textures,
                   Lanes lanes) {
  Golden golden(config, textures, lanes);
  std::uint64_t fragments = 0, sink = 0;
  const auto count = [&](const auto& batch) {
    fragments += std::uint64_t(batch.count);
    sink += std::uint64_t(batch.output_colour[0][0]);
  };
  const double start = cpu_seconds();
  double spent = 0;
  do {
    golden.draw(stream.words, {count, count});
    spent = cpu_seconds() - start;
  } while (spent < 0.2);
  return sink == ~std::uint64_t{0} ? 0 : double(fragments) / spent;
}

int bench(const Options& options) {
  const Scene scene = scene_named(options.scene);
  const Config config = chosen_config(options.config, "standard");
  const Frame frame = build_frame(config, scene);
  nlohmann::json result{{"config", options.config.name.empty() ? "standard" : options.config.name},
                        {"scene", scene.name}};
  result["throughput"] = throughput(config, frame);

  const PacketStream stream = build_packets(config, frame);
  std::vector<double> rtl, simd, scalar;
  Progress progress("bench", std::uint64_t(options.runs));
  for (int run = 0; run < options.runs; ++run) {
    const BenchResult drawn = run_bench(config, stream, frame.textures, frame.name, quiet_bench_options());
    rtl.push_back(double(drawn.fragments) / drawn.cpu_seconds);
    simd.push_back(1e-6 * golden_rate(config, stream, frame.textures, Lanes::kSimd));
    scalar.push_back(1e-6 * golden_rate(config, stream, frame.textures, Lanes::kScalar));
    progress.at(std::uint64_t(run + 1));
  }
  progress.clear();
  result["runs"] = options.runs;
  result["rtl_fragments_per_cpu_s"] = median(rtl);
  result["golden_mpixels_per_cpu_s"] = median(simd);
  result["golden_scalar_mpixels_per_cpu_s"] = median(scalar);
  result["simd_target"] = simd_target();
  fmt::print("medians of {} interleaved runs on {}:\n", options.runs, scene.name);
  fmt::print("RTL, compare included   {:>12.0f} fragments per CPU second\n", median(rtl));
  fmt::print("golden, {:<15} {:>12.2f} million pixels per CPU second\n", simd_target(), median(simd));
  fmt::print("golden, scalar          {:>12.2f} million pixels per CPU second\n", median(scalar));
  write_json(options.json, result);
  return kExitEqual;
}

}  // namespace

void add_bench(CLI::App& app, Action& run) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("bench", "Measure throughput in clocks and speed of simulation");
  add_config_options(*command, options->config);
  command->add_option("--scene", options->scene, "What golden and RTL are timed on")->capture_default_str();
  command->add_option("--runs", options->runs, "Interleaved runs that medians are taken of")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  add_json_option(*command, options->json);
  command->callback([options, &run] { run = [options] { return bench(*options); }; });
}

}  // namespace wrinkle

// M level and rows of texel codes; S wrap u/4096 v/4096 lod/256 expected: one filtered texel code a sample.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/input_error.h"
#include "sim/vectors/vectors.h"

namespace wrinkle {
namespace {

struct Sample {
  Wrap wrap;
  std::int64_t u, v, lod;  // 1/4096, 1/4096, 1/256
  double expected;
};

std::vector<std::uint64_t> texel_row(const std::filesystem::path& path, const VectorLine& line) {
  const std::string& digits = line.words[0];
  std::vector<std::uint64_t> row;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
    VectorLine pair{line.number, {digits.substr(i, 2)}};
    const auto code = std::uint64_t(whole(path, pair, 0, 16));
    row.push_back(code | code << 8 | code << 16);
  }
  return row;
}

Texture read_texture(const std::filesystem::path& path, std::span<const VectorLine> lines) {
  Texture texture;
  for (const VectorLine& line : lines) {
    if (line.words[0] == "S") continue;
    if (line.words[0] == "M") {
      texture.levels.emplace_back();
    } else {
      const auto row = texel_row(path, line);
      if (texture.levels.size() == 1 && texture.levels[0].empty())
        while ((std::size_t{1} << texture.log2_width) < row.size()) ++texture.log2_width;
      texture.levels.back().insert(texture.levels.back().end(), row.begin(), row.end());
    }
  }
  texture.log2_height = texture.log2_width;
  for (int level = 0; level <= texture.max_level(); ++level) {
    const std::size_t expected = std::size_t(texture.width(level)) * std::size_t(texture.height(level));
    if (texture.levels[std::size_t(level)].size() != expected)
      throw InputError(Place{path.string()},
                       fmt::format("{} texels in level {}", texture.levels[std::size_t(level)].size(), level),
                       fmt::format("{}", expected));
  }
  return texture;
}

std::vector<Sample> read_samples(const std::filesystem::path& path, std::span<const VectorLine> lines) {
  std::vector<Sample> samples;
  for (const VectorLine& line : lines) {
    if (line.words[0] != "S") continue;
    const std::int64_t wrap = whole(path, line, 1);
    if (wrap < 0 || wrap > 2)
      throw InputError(Place{path.string(), line.number, 0, ""}, fmt::format("wrap mode {}", wrap), "0, 1 or 2");
    samples.push_back(
        {Wrap(wrap), whole(path, line, 2), whole(path, line, 3), whole(path, line, 4), real(path, line, 5)});
  }
  return samples;
}

// The filtered code, computed back from the normal that the stage decoded it to.
double code_of(const Config& config, std::int64_t normal) {
  const double full = (1 << config.texel_bits) - (config.decode == static_cast<int>(Decode::kRange) ? 1 : 0);
  return (std::ldexp(double(normal), config.texel_bits - config.vector_bits) + full) / 2;
}

}  // namespace

VectorReport check_trilinear(const std::filesystem::path& path, std::span<const VectorLine> lines, const Config& config,
                             const BenchOptions* rtl) {
  const std::vector<Sample> samples = read_samples(path, lines);
  Stimulus stimulus(config);
  DrawState state;
  state.bump = state.textured = true;
  state.texture = stimulus.add_texture(read_texture(path, lines));
  const int to_uv = config.uv_bits - 12;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& s = samples[i];
    if (i == 0 || s.wrap != samples[i - 1].wrap) {
      state.wrap_u = state.wrap_v = s.wrap;
      stimulus.add_draw(state);
    }
    TriangleWords words = stimulus.row(int(i) % 64, int(i) / 64 % 64);
    stimulus.set(words, "u", 0, s.u << to_uv);
    stimulus.set(words, "v", 0, s.v << to_uv);
    words.lod = int(s.lod);
    stimulus.add(words);
  }

  // Weights of B bits move a sample by at most half a step each way; between texels codes change by at most 255. What
  // is left is the rounding to s1.V.
  const double bound =
      255 * std::ldexp(1.0, -config.weight_bits) + std::ldexp(1.0, config.texel_bits - config.vector_bits - 2);
  VectorReport report{VectorKind::kTrilinear, "texel codes", bound, {}};
  const auto score = [&](const std::string& engine, const std::vector<FragmentValues>& fragments) {
    VectorScore result{.engine = engine};
    const std::size_t n = stimulus.index("texture", "n");
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double code = i < fragments.size() ? code_of(config, fragments[i][n][0]) : NAN;
      result.measure(std::abs(code - samples[i].expected), bound,
                     fmt::format("sample {}: {} instead of {}", i, code, samples[i].expected));
    }
    report.scores.push_back(result);
  };
  score("golden", stimulus.golden());
  if (rtl) score("rtl", rtl_values(stimulus, *rtl));
  return report;
}

}  // namespace wrinkle

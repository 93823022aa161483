#include "sim/vectors/vectors.h"

#include <algorithm>
#include <cmath>

#include "golden/datapath/datapaths.h"

namespace wrinkle {

void VectorScore::measure(double error, double allowed, const std::string& description) {
  ++cases;
  if (!(error <= allowed)) {
    if (outside++ == 0) first = description;
  }
  if (!(error <= worst)) worst = error;
}

bool VectorReport::good() const {
  return std::all_of(scores.begin(), scores.end(), [](const VectorScore& s) { return s.outside == 0 && s.cases > 0; });
}

std::vector<FragmentValues> rtl_values(const Stimulus& stimulus, const BenchOptions& options) {
  std::vector<FragmentValues> all;
  BenchSinks sinks;
  sinks.values = [&](const Fragment&, const FragmentValues& values) { all.push_back(values); };
  BenchOptions drawn = options;
  drawn.compare = false;
  run_bench(stimulus.config(), stimulus.stream(), stimulus.textures(), "vectors", drawn, sinks);
  return all;
}

Config config_for(VectorKind kind, Config config) {
  switch (kind) {
    case VectorKind::kCoverage:
      config.subpixel_bits = 8;
      config.screen_bits = std::max(config.screen_bits, 6);
      break;
    case VectorKind::kTrilinear:
      // Level of detail in 1/256, and vectors so fine that a texel code is read back to 1/1024.
      config.datapath = static_cast<int>(Datapath::kNormalMapped);
      config.filter = static_cast<int>(Filter::kTrilinear);
      config.perspective = 0;
      config.texel_bits = 8;
      config.lod_bits = 8;
      config.vector_bits = 18;
      break;
    case VectorKind::kNormalize:
    case VectorKind::kRsqrt:
      // 16-bit components.
      config.vector_bits = 14;
      config.normalizer_n = config.normalizer_l = config.normalizer_h = static_cast<int>(Normalizer::kFaithful);
      config.normalize_order = static_cast<int>(NormalizeOrder::kBefore);
      config.lighting = static_cast<int>(Lighting::kHalfangle);
      break;
  }
  return config;
}

VectorReport check_vectors(const std::filesystem::path& path, const Config& config, const BenchOptions* rtl) {
  VectorKind kind{};
  const std::vector<VectorLine> lines = read_vector_lines(path, kind);
  const Config fitting = config_for(kind, config);
  switch (kind) {
    case VectorKind::kCoverage:
      return check_coverage(path, lines, fitting, rtl);
    case VectorKind::kTrilinear:
      return check_trilinear(path, lines, fitting, rtl);
    case VectorKind::kNormalize:
      return check_normalize(path, lines, fitting, rtl);
    case VectorKind::kRsqrt:
      break;
  }
  return check_rsqrt(path, lines, fitting, rtl);
}

}  // namespace wrinkle

// Files of vectors with known answers, drawn by golden and RTL: coverage, trilinear filtering, normalization,
// reciprocal root. Which of them a file holds is seen from its lines; formats in docs/formats.md.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "golden/config/config.h"
#include "sim/stress/stimulus.h"
#include "tb/bench.h"

namespace wrinkle {

enum class VectorKind { kCoverage, kTrilinear, kNormalize, kRsqrt };
std::string name(VectorKind kind);

// One engine against the known answers.
struct VectorScore {
  std::string engine;
  std::uint64_t cases = 0;
  std::uint64_t outside = 0;  // cases that are further off than the bound
  double worst = 0;           // in `unit` of the report
  std::string first;          // description of the first case outside

  // Takes a case into account; `allowed` is its bound.
  void measure(double error, double allowed, const std::string& description);
};

struct VectorReport {
  VectorKind kind{};
  std::string unit;
  double bound = 0;
  std::vector<VectorScore> scores;
  bool good() const;
};

// The line of a file of vectors, without comments: its number and its words.
struct VectorLine {
  unsigned number;
  std::vector<std::string> words;
};
// All lines of the file, and what kind they are. Throws InputError.
std::vector<VectorLine> read_vector_lines(const std::filesystem::path& path, VectorKind& kind);
// The word as a whole number; throws InputError naming the place.
std::int64_t whole(const std::filesystem::path& path, const VectorLine& line, std::size_t word, int base = 10);
double real(const std::filesystem::path& path, const VectorLine& line, std::size_t word);

// The configuration that the vectors of a kind need: `config` with the widths they are written in.
Config config_for(VectorKind kind, Config config);

// Draws the vectors and compares them with the answers. Where `rtl` is null, only golden draws.
VectorReport check_vectors(const std::filesystem::path& path, const Config& config, const BenchOptions* rtl);

// The four kinds.
VectorReport check_coverage(const std::filesystem::path&, std::span<const VectorLine>, const Config&,
                            const BenchOptions*);
VectorReport check_trilinear(const std::filesystem::path&, std::span<const VectorLine>, const Config&,
                             const BenchOptions*);
VectorReport check_normalize(const std::filesystem::path&, std::span<const VectorLine>, const Config&,
                             const BenchOptions*);
VectorReport check_rsqrt(const std::filesystem::path&, std::span<const VectorLine>, const Config&, const BenchOptions*);

// Every value of every fragment as the RTL has it, in order.
std::vector<FragmentValues> rtl_values(const Stimulus& stimulus, const BenchOptions& options);

}  // namespace wrinkle

// Vectors with known answers, by golden and RTL. The files stay where they are and are read in place.
#include "sim/vectors/vectors.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "sim/input_error.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

class Vectors : public testing::TestWithParam<const char*> {};

TEST_P(Vectors, GoldenAndRtlInsideTheBound) {
  const fs::path path = fs::path(WRINKLE_SHARED_DIR) / "assets/vectors" / GetParam();
  if (!fs::exists(path)) GTEST_SKIP() << "../shared/assets/vectors is not here";
  const BenchOptions rtl;
  const VectorReport report = check_vectors(path, Config{}, &rtl);
  ASSERT_GE(report.scores.size(), 2U);
  for (const VectorScore& score : report.scores) {
    EXPECT_GT(score.cases, 1000U) << score.engine;
    EXPECT_EQ(score.outside, 0U) << score.engine << ": " << score.first;
  }
}

INSTANTIATE_TEST_SUITE_P(File, Vectors,
                         testing::Values("coverage_topleft_64x64.txt", "trilinear_32x32.txt", "normalize_exact.txt",
                                         "rsqrt_exact.txt"),
                         [](const auto& instance) {
                           const std::string name = instance.param;
                           return name.substr(0, name.find('_'));
                         });

// A file whose answers are wrong is found to be wrong, so the comparison can fail.
struct Wrong {
  const char* name;
  const char* text;
};

class WrongVectors : public testing::TestWithParam<Wrong> {};

TEST_P(WrongVectors, AreCaught) {
  const fs::path path = fs::path(testing::TempDir()) / (std::string(GetParam().name) + "_wrong.txt");
  std::ofstream(path) << GetParam().text;
  const VectorReport report = check_vectors(path, Config{}, nullptr);
  EXPECT_EQ(report.scores.back().outside, 1U);
  EXPECT_FALSE(report.good());
}

INSTANTIATE_TEST_SUITE_P(
    Kind, WrongVectors,
    testing::Values(Wrong{"coverage", "T 0 0 0 0 512 0 0 512 1\nR 0 1\nT 1 0 0 0 512 0 0 512 1\nR 0 3\n"},
                    Wrong{"trilinear", "M 0\n10\nS 0 0 0 0 16 16\nS 0 0 0 0 20 20\n"},
                    Wrong{"normalize", "0 0 1 0 0 1073741824 0 0 16384\n1 0 0 0 1073741824 0 0 16384 0\n"},
                    Wrong{"rsqrt", "1 1099511627776\n4 1099511627776\n"}),
    [](const auto& instance) { return instance.param.name; });

TEST(VectorFiles, BadOnesAreRefused) {
  for (const char* text :
       {"", "# nothing\n", "hello\n", "1 2 3\n", "T 0 0 1\n", "M 0\n10\n20\n", "M 0\nzz\nS 0 0 0 0 0\n"}) {
    const fs::path path = fs::path(testing::TempDir()) / "bad_vectors.txt";
    std::ofstream(path) << text;
    EXPECT_THROW(check_vectors(path, Config{}, nullptr), InputError) << text;
  }
  EXPECT_THROW(check_vectors("/no/such/file", Config{}, nullptr), InputError);
}

}  // namespace
}  // namespace wrinkle

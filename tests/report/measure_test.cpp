// The measurements of `area`, `error` and `report`, on cases whose answers are known.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bitset>
#include <cmath>
#include <filesystem>

#include "sim/aov.h"
#include "sim/command.h"
#include "sim/config_file.h"
#include "sim/engine.h"
#include "sim/report/area.h"
#include "sim/report/baseline.h"
#include "sim/report/error.h"
#include "sim/report/modules.h"
#include "sim/report/similarity.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

Picture constant(float value) {
  Picture picture(24, 20, {"R", "G", "B"});
  std::fill(picture.data.begin(), picture.data.end(), value);
  return picture;
}

const std::vector<std::uint8_t> kEverywhere(24 * 20, 1);

TEST(Similarity, ConstantPicturesByHand) {
  EXPECT_DOUBLE_EQ(structural_similarity(constant(.5F), constant(.5F), kEverywhere), 1);
  const double a = .25, b = .75, c1 = 1e-4;
  EXPECT_NEAR(structural_similarity(constant(.25F), constant(.75F), kEverywhere),
              (2 * a * b + c1) / (a * a + b * b + c1), 1e-9);
}

TEST(Similarity, StructureCounts) {
  Picture checks = constant(.5F), inverse = checks;
  for (std::size_t i = 0; i < checks.data.size(); ++i) {
    const bool odd = ((i / 3) % 24 + i / 72) % 2 == 1;
    checks.data[i] = odd ? .4F : .6F;
    inverse.data[i] = odd ? .6F : .4F;
  }
  EXPECT_LT(structural_similarity(checks, inverse, kEverywhere), -.5);
}

TEST(Similarity, PercentileIsOfTheMaskedChannels) {
  Picture a = constant(0), b = constant(0);
  std::vector<std::uint8_t> mask(24 * 20, 0);
  for (std::size_t i = 0; i < 100; ++i) {
    mask[i] = 1;
    for (std::size_t c = 0; c < 3; ++c) a.data[3 * i + c] = float(i) / 128;
  }
  a.data[3 * 200] = 1;  // outside of the mask
  EXPECT_DOUBLE_EQ(error_percentile(a, b, mask, 1), 99. / 128);
  EXPECT_DOUBLE_EQ(error_percentile(a, b, mask, 0), 0);
  EXPECT_DOUBLE_EQ(error_percentile(a, b, mask, .5), 49. / 128);
}

TEST(Baseline, OnlyWorseFiguresFail) {
  const fs::path file = fs::path(testing::TempDir()) / "wrinkle_baseline.json";
  write_baseline(file, {{"fig1.nand2", 1000}, {"patch_db", 50}});
  EXPECT_TRUE(check_baseline(file, {{"fig1.nand2", 1004}, {"patch_db", 49.96}}));
  EXPECT_TRUE(check_baseline(file, {{"fig1.nand2", 10}, {"patch_db", 80}}));
  EXPECT_FALSE(check_baseline(file, {{"fig1.nand2", 1006}, {"patch_db", 50}}));
  EXPECT_FALSE(check_baseline(file, {{"fig1.nand2", 1000}, {"patch_db", 49.9}}));
  EXPECT_FALSE(check_baseline(file, {{"fig1.nand2", 1000}}));
  EXPECT_FALSE(check_baseline(file, {{"fig1.nand2", 1000}, {"patch_db", 50}, {"new", 1}}));
  fs::remove(file);
}

TEST(Modules, AStageIsAsTheCoreHasIt) {
  Config config = load_config("standard");
  config.screen_bits = 7;
  const auto binary = [](int value) { return "32'b" + std::bitset<32>(static_cast<unsigned>(value)).to_string(); };
  const VerilogParameters expected{{"SCREEN_BITS", binary(7)},
                                   {"SUBPIXEL_BITS", binary(config.subpixel_bits)},
                                   {"SHARING", binary(0)},
                                   {"BUFFERING", binary(0)},
                                   {"WORDS", binary(4)}};
  const StageModule scan = stage_module("scan", config), perturb = stage_module("perturb", config);
  EXPECT_EQ(scan.module, "wrinkle_scan");
  EXPECT_EQ(scan.parameters, expected);
  EXPECT_EQ(perturb.module, "wrinkle_perturb_normal_map");
  EXPECT_FALSE(core_parameters(config).contains("BLOCK_EXPONENT"));
}

// The values N, L and H are unit vectors in either order of normalization, since mantissas are multiplied by their
// scales.
TEST(Aov, VectorsOfMantissasHaveUnitLength) {
  const Config config = load_config("deferred");
  const Frame frame = build_frame(config, scene_named("patch_fig6"));
  double worst = 0;
  std::uint64_t fragments = 0;
  draw(Engine::kGolden, config, frame, aov_channels(config, {"N", "L", "H"}), [&](const Sample& sample) {
    ++fragments;
    for (std::size_t k = 0; k < 9; k += 3)
      worst = std::max(worst, std::abs(length(Vec3{sample.aov[k], sample.aov[k + 1], sample.aov[k + 2]}) - 1));
  });
  EXPECT_GT(fragments, 10000u);
  EXPECT_LT(worst, std::ldexp(1.0, -config.unit_bits));
}

// The map of a datapath has a channel as every other value has, of golden and of its float64 twin.
TEST(Aov, ValuesOfADatapathHaveChannels) {
  const Config config = load_config("offset");
  const Frame frame = build_frame(config, scene_named("patch_offset"));
  const std::vector<AovChannel> channels =
      aov_channels(config, {"texture_offset", "interpolate_l", "perturb_n", "lod", "z"});
  ASSERT_EQ(channels.size(), 2u + 3 + 3 + 1 + 1);
  EXPECT_EQ(channels[1].name, "texture_offset.y");
  const Picture golden = drawn(Engine::kGolden, config, frame, channels).all_channels();
  const Picture exact = drawn(Engine::kExact, config, frame, channels).all_channels();
  ASSERT_EQ(golden.data.size(), exact.data.size());
  const std::size_t stride = 3 + channels.size();
  for (std::size_t k = 0; k < channels.size(); ++k) {
    double worst = 0, largest = 0;
    for (std::size_t i = 3 + k; i < golden.data.size(); i += stride) {
      worst = std::max(worst, double(std::abs(golden.data[i] - exact.data[i])));
      largest = std::max(largest, double(std::abs(exact.data[i])));
    }
    EXPECT_GT(largest, 0.01) << channels[k].name;
    EXPECT_LT(worst, 0.07) << channels[k].name;  // of a level of detail, two of its LSB
  }
}

double difference(std::size_t count, const Replay::Colours& a, const Replay::Colours& b) {
  double worst = 0;
  for (std::size_t i = 0; i < count; ++i) worst = std::max(worst, length(a[i] - b[i]));
  return worst;
}

class Replays : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(Replays, AllRoundingsGiveGoldenAndNoneGivesExact) {
  const auto& [config_name, scene] = GetParam();
  const Config config = load_config(config_name);
  const Frame frame = build_frame(config, scene_named(scene));
  Parts every, none{};
  every.fill(true);
  double golden = 0, exact = 0, parts = 0;
  std::uint64_t fragments = 0;
  for_each_replayed(config, frame, [&](Replay& replay) {
    fragments += replay.count();
    const auto deviation = [&](const Parts& chosen, const exact::Fragments& expected) {
      double worst = 0;
      const Replay::Colours& colours = replay.replay(chosen);
      for (std::size_t i = 0; i < replay.count(); ++i) worst = std::max(worst, length(colours[i] - expected.colour[i]));
      return worst;
    };
    golden = std::max(golden, deviation(every, replay.golden()));
    exact = std::max(exact, deviation(none, replay.exact()));
    // One part or all but one, from what was left of the others, is what a replay of its own gives.
    replay.for_each_part([&](Part part, const Replay::Colours& alone, const Replay::Colours& without) {
      Parts chosen = none;
      chosen[std::size_t(part)] = true;
      const Replay::Colours one = alone, others = without;
      parts = std::max(parts, difference(replay.count(), Replay(replay).replay(chosen), one));
      for (bool& other : chosen) other = !other;
      parts = std::max(parts, difference(replay.count(), Replay(replay).replay(chosen), others));
    });
  });
  EXPECT_EQ(parts, 0);
  EXPECT_GT(fragments, 10000u);
  EXPECT_LT(golden, 1e-9);
  EXPECT_LT(exact, 1e-9);
}

TEST_P(Replays, StagesKeepTheirBounds) {
  const auto& [config_name, scene] = GetParam();
  const Config config = load_config(config_name);
  const ErrorReport report = measure_error(config_name, config, build_frame(config, scene_named(scene)));
  for (const PartError& part : report.parts) {
    EXPECT_LE(part.ulp.rms, part.ulp.max) << part.name;
    if (part.name == "dot" && !config.is(Lighting::kReflection)) {
      EXPECT_LE(part.ulp.max, Shape(config).normalizes_after != 0 ? 2.625 : .5 + 1e-9);
    }
    if (part.name == "normalizer" && !config.is(Lighting::kPixelHalfangle)) {
      EXPECT_LT(part.ulp.max, Shape(config).normalizes_after != 0 ? 3 : 1);
    }
    if (part.name == "interpolators") {
      EXPECT_LT(part.ulp.max, 2);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Datapaths, Replays,
                         testing::Values(std::pair{"standard", "patch_fig6"}, std::pair{"lean", "patch_fig6"},
                                         std::pair{"blinn", "patch_fig5"}, std::pair{"rotated", "patch_rotated"},
                                         std::pair{"reflection", "patch_reflection"},
                                         std::pair{"pixel_halfangle", "patch_pixel_halfangle"},
                                         std::pair{"object_constant", "patch_object"},
                                         std::pair{"deferred", "patch_fig6"}, std::pair{"gloss", "patch_gloss"}));

// The limits that `smallest` is made for: 45 dB on the paper's patch, 12,061 NAND2 for a complete Fig. 3.
TEST(Shading, SmallestIsSmallAndPreciseEnough) {
  const Config config = load_config("smallest");
  EXPECT_GE(measure_error("smallest", config, build_frame(config, scene_named("patch_fig6"))).precision.psnr_db, 45);
  const AreaReport report = measure_shading("smallest", config, {});
  std::vector<std::string> stages;
  for (const StageArea& stage : report.stages) {
    stages.push_back(stage.stage);
    EXPECT_GT(stage.result.nand2, 0) << stage.stage;
  }
  EXPECT_THAT(stages, testing::ElementsAre("interpolate", "perturb", "normalize", "light"));
  EXPECT_LE(report.sum_nand2(), 12061);
}

TEST(Shading, IsOfFig1AndFig3) {
  EXPECT_THROW(measure_shading("blinn", load_config("blinn"), {}), std::invalid_argument);
}

}  // namespace
}  // namespace wrinkle

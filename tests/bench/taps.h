// Every stage's values, tapped in the RTL, held against those of the golden model.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "golden/pixel/pixel.h"
#include "tb/bench.h"
#include "tb/random_frame.h"

namespace wrinkle {

inline std::vector<FragmentValues> golden_values(const Config& config, const std::vector<Texture>& textures,
                                                 const PacketStream& stream) {
  std::vector<FragmentValues> golden;
  const auto keep = [&](const auto& batch) {
    for (int i = 0; i < batch.count; ++i) extract(batch, i, golden.emplace_back());
  };
  Golden(config, textures).draw(stream.words, {keep, keep});
  return golden;
}

// Draws the packets. The first values that differ are named.
inline void expect_taps_are_golden(const Config& config, const PacketStream& stream,
                                   const std::vector<Texture>& textures, const BenchOptions& options) {
  const std::vector<FragmentValues> golden = golden_values(config, textures, stream);
  ASSERT_GT(golden.size(), 1000U);
  const std::vector<Value> names = values(config);
  std::size_t next = 0, differences = 0;
  BenchSinks sinks;
  sinks.values = [&](const Fragment&, const FragmentValues& rtl) {
    ASSERT_LT(next, golden.size());
    for (std::size_t v = 0; v < names.size(); ++v) {
      for (std::size_t e = 0; e < static_cast<std::size_t>(names[v].elements); ++e) {
        if (rtl[v][e] == golden[next][v][e] || differences++ > 3) continue;
        ADD_FAILURE() << "fragment " << next << ", " << names[v].stage << '.' << names[v].name << '[' << e
                      << "]: golden " << golden[next][v][e] << ", rtl " << rtl[v][e];
      }
    }
    ++next;
  };
  const BenchResult result = run_bench(config, stream, textures, "taps", options, sinks);
  EXPECT_TRUE(result.equal()) << (result.first ? describe(*result.first) : "");
  EXPECT_EQ(next, golden.size());
  EXPECT_EQ(differences, 0U);
}

// Draws a frame of about 3,000 fragments under random stalls.
inline void expect_taps_are_golden(const Config& config) {
  RandomFrame wish;
  wish.seed = 60;
  wish.fragments = 3000;
  const Frame frame = random_frame(config, wish);
  BenchOptions options;
  options.stalls = StallProfile::kRandom;
  expect_taps_are_golden(config, build_packets(config, frame), frame.textures, options);
}

}  // namespace wrinkle

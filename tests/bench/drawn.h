// The fragments that the bench draws of a frame.
#pragma once

#include <gtest/gtest.h>

#include <span>
#include <vector>

#include "tb/bench.h"

namespace wrinkle {

inline std::vector<Fragment> drawn(const Config& config, const Frame& frame, const BenchOptions& options = {},
                                   BenchResult* result = nullptr) {
  std::vector<Fragment> fragments;
  BenchSinks sinks;
  sinks.fragments = [&](std::span<const Fragment> block) {
    fragments.insert(fragments.end(), block.begin(), block.end());
  };
  const BenchResult r = run_bench(config, frame, options, sinks);
  EXPECT_TRUE(r.equal()) << (r.first ? describe(*r.first) : "stopped");
  if (result != nullptr) *result = r;
  return fragments;
}

}  // namespace wrinkle

// What the tests of datapaths share: the stage `perturb` with inputs of every kind.
#pragma once

#include "golden/datapath/datapaths.h"
#include "tests/stage/support.h"

namespace wrinkle {

// Whether two values have the same codes for all fragments of a batch.
inline bool are_equal(Columns<std::int64_t> a, Columns<std::int64_t> b) { return std::ranges::equal(a, b); }

// The configurations of the stage tests that have this datapath.
inline std::vector<NamedConfig> configurations_with(Datapath datapath) {
  std::vector<NamedConfig> list;
  for (const NamedConfig& named : configurations())
    if (named.second.datapath == static_cast<int>(datapath)) list.push_back(named);
  return list;
}

// Fills every value of a batch and sends it through some of the stages, in a draw with or without bump.
inline std::unique_ptr<Batch<std::int64_t>> run_filled(const Config& config, bool bump, unsigned stages) {
  Context context = make_context(config);
  DrawWords draw;
  draw.bump = bump;
  set_draw(context, draw, nullptr);
  auto batch = std::make_unique<Batch<std::int64_t>>(context.config);
  fill(config, base_seed(), *batch);
  batch->count = kBatch;
  return run_one(context, stages, std::move(batch));
}

}  // namespace wrinkle

// Twin of the stage `perturb`: the datapath's own, over the fragments of a batch.
#pragma once

#include <type_traits>

#include "golden/datapath/datapaths.h"
#include "golden/exact/fragments.h"
#include "golden/triangle/packet.h"

namespace wrinkle::exact {

inline void perturb(const Shape& config, const DrawWords& draw, Fragments& batch) {
  with_datapath(config, [&](const auto& said) {
    using Kind = std::decay_t<decltype(said)>;
    if constexpr (Kind::kPerturbs) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i)
        batch.perturbed_n.set(i, Kind::exact(draw.bump, batch.frame[i], batch.bump[i]));
    }
  });
}

}  // namespace wrinkle::exact

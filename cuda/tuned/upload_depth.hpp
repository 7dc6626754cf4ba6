#pragma once

#include "core/depth_counts.hpp"

namespace facet {

/// Metres of whole units that are on the device.
struct MetresOfCountsOp {
  static constexpr int radius = 0;
  DepthCounts depth;
  ImageView<float> depth_m;

  template <class Access>
  FACET_HD void operator()(int x, int y, Access) const {
    depth_m(x, y) = metres_of(depth.counts(x, y), depth.unit_m);
  }
};

}  // namespace facet

#pragma once

#include <optional>

#include "core/depth_counts.hpp"
#include "core/image.hpp"

namespace facet {

/// A depth image in whole units, as files hold it; missing depth is 0.
struct CountedDepth {
  Image<std::uint16_t> counts;
  double unit_m = 0;  ///< metres per count

  /// Nothing where it is empty.
  std::optional<DepthCounts> view() const {
    return counts.empty() ? std::nullopt : std::optional(DepthCounts{counts.view(), unit_m});
  }
};

}  // namespace facet

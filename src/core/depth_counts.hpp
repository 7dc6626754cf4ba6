#pragma once

#include <cstdint>

#include "core/image_view.hpp"

namespace facet {

/// Metres of a whole number of units, rounded once: how readers make them and devices make them again.
FACET_HD inline float metres_of(std::uint16_t count, double unit_m) {
  return static_cast<float>(count * unit_m);
}

/// A depth image in host memory as the sensor's integers: half the bytes of metres.
struct DepthCounts {
  ImageView<const std::uint16_t> counts;  ///< 0 = missing
  double unit_m = 0;                      ///< metres per count
};

}  // namespace facet

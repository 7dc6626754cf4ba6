#pragma once

#include <cstdint>

#include "core/host_device.hpp"

namespace facet {

/// Sums over the pixels of a component: integers, so that their order does not matter.
struct RegionStatistics {
  static constexpr float depth_units_per_m = 16384;

  std::int64_t twice_depth = 0;  ///< each run of a row by the trapezoid over its ends; units: see above
  std::int32_t first = 0;        ///< raster index of the first pixel
  std::int32_t area_px = 0;
  std::int32_t filled_px = 0;  ///< pixels with made-up depth
  std::int32_t place = 0;      ///< in a list of components

  /// What a run of a row adds to `twice_depth`.
  FACET_HD static std::int64_t twice_depth_of_run(int length_px, float first_m, float last_m) {
    return length_px * (units(first_m) + units(last_m));
  }
  float mean_depth_m() const {
    return static_cast<float>(static_cast<double>(twice_depth) / (2.0 * double{depth_units_per_m} * area_px));
  }

 private:
  FACET_HD static std::int64_t units(float depth_m) {
    return static_cast<std::int64_t>(depth_m * depth_units_per_m + 0.5f);
  }
};

}  // namespace facet

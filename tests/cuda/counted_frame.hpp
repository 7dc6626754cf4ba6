#pragma once

#include <optional>

#include "core/depth_counts.hpp"
#include "core/image.hpp"

namespace facet {

/// A frame as readers make it of 16-bit images.
struct CountedFrame {
  Image<std::uint16_t> units;
  Image<float> depth_m;
  double unit_m;

  /// count(x, y) is cut to an integer.
  template <class Count>
  CountedFrame(Size size, double unit, const Count& count) : units(size), depth_m(size), unit_m(unit) {
    for (int y = 0; y < size.height; ++y)
      for (int x = 0; x < size.width; ++x) {
        units(x, y) = static_cast<std::uint16_t>(count(x, y));
        depth_m(x, y) = metres_of(units(x, y), unit_m);
      }
  }
  std::optional<DepthCounts> counts() const { return DepthCounts{units.view(), unit_m}; }
};

}  // namespace facet

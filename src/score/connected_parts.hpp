#pragma once

#include <cstdint>
#include <vector>

#include "core/image.hpp"

namespace facet {

/// A 4-connected set of pixels with one label.
struct ConnectedPart {
  int label = 0;
  int area_px = 0;
};

/// The parts of a label image that have at least `least_px` pixels.
struct ConnectedParts {
  Image<std::int32_t> map;           ///< index in `parts` + 1, 0 = none or too small
  std::vector<ConnectedPart> parts;  ///< in raster order of their first pixels
};

/// Label 0 is no label.
ConnectedParts connected_parts(const Image<std::uint16_t>& labels, int least_px);

}  // namespace facet

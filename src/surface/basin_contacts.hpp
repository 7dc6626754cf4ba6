#pragma once

#include <vector>

#include "surface/basin_landscape.hpp"

namespace facet {

/// Two 4-neighbours in different regions.
struct BasinContact {
  int a, b;        ///< the regions, a < b
  int place;       ///< raster index of the left or upper one, twice, plus 1 if the other lies below it
  float strength;  ///< of the stronger one
};

/// All of them in raster order of the left or upper one, which is in the rows begin_y ... end_y - 1.
/// `region`: numbers, -1 = none.
void collect_contacts(const BasinLandscape& landscape, ImageView<const std::int32_t> region, int begin_y,
                      int end_y, std::vector<BasinContact>& contacts);

}  // namespace facet

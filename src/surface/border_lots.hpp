#pragma once

#include <span>
#include <vector>

#include "core/disjoint_sets.hpp"
#include "surface/basin_graph.hpp"

namespace facet {

/// Shares borders out among threads. Depth edges separate islands of basins, which no border links: all
/// borders of an island are in one lot, so that the lots can be worked through at the same time.
class BorderLots {
 public:
  /// `borders` between basins 0 ... basin_count - 1. Returns numbers of borders, ascending, by lot; the lots
  /// are about as long as each other where the islands let them be.
  const std::vector<std::vector<int>>& cast(std::span<const BasinBorder> borders, int basin_count,
                                            int lot_count);

 private:
  struct Island {
    int first_basin = 0;
    int borders = 0;
    int lot = 0;
  };

  DisjointSets linked_;          ///< basins
  std::vector<Island> islands_;  ///< those with borders, the largest first
  std::vector<int> place_;       ///< in that list, by first basin; -1 = none yet
  std::vector<std::vector<int>> lots_;
  std::vector<int> loads_;  ///< borders by lot
};

}  // namespace facet

#pragma once

#include <cstdint>
#include <vector>

#include "core/disjoint_sets.hpp"
#include "core/image.hpp"
#include "surface/basin_landscape.hpp"

namespace facet {

/// Joins small basins that are no deeper than noise to the neighbour across their lowest pass.
class ShallowBasins {
 public:
  /// Basins of at most `most_px` pixels are small; a basin is as deep as its lowest pass is above its bottom
  /// (its topographic dynamics), and noise is landscape.floor deep. `region` receives numbers from 0 on in
  /// the order of their first pixels, -1 = none; returns how many.
  int join(const BasinLandscape& landscape, double most_px, Image<std::int32_t>& region);

 private:
  struct Basin {
    int count_px = 0;
    float lowest = unknown_strength;  ///< of the known strengths inside
  };
  struct Pass {
    float height;
    int a, b;
  };
  void number_basins(const BasinLandscape& landscape, ImageView<std::int32_t> region);
  bool is_shallow(const Pass& pass, const Basin& a, const Basin& b) const;
  void collect_passes(const BasinLandscape& landscape, ImageView<const std::int32_t> region);
  void join_passes();
  int number_regions(ImageView<std::int32_t> region);

  Basin& basin(int i) { return basins_[static_cast<std::size_t>(i)]; }

  double most_px_ = 0;
  float floor_ = 0;
  std::vector<Basin> basins_;
  std::vector<Pass> passes_;
  std::vector<std::uint64_t> order_;  ///< of the passes: height, then index
  std::vector<std::int32_t> number_;  ///< of a basin by raster index of its name; then of a region by basin
  DisjointSets sets_;
};

}  // namespace facet

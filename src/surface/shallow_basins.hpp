#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/counting_sort.hpp"
#include "core/depth_noise.hpp"
#include "core/disjoint_sets.hpp"
#include "core/host_threads.hpp"
#include "core/image.hpp"
#include "surface/basin_contacts.hpp"

namespace facet {

/// Which basins say nothing by themselves.
struct ShallowLimits {
  double most_px = 0;  ///< basins of more pixels are not shallow
  /// Basins whose strength is known nowhere join each other while they have no more pixels together.
  double most_blind_px = 0;
  /// None join across a larger step of depth, relative to it [m/m], that is more than noise.
  double step_ratio = 0;
  double step_sigmas = 0;  ///< deviations of a reading that a step of noise may have
  DepthNoise noise{};
};

/// Joins basins that say nothing by themselves: small ones no deeper than noise to the neighbour across their
/// lowest pass, and those whose strength is known nowhere to each other across the least step of depth.
class ShallowBasins {
 public:
  /// A basin is as deep as its lowest pass is above its bottom (its topographic dynamics); noise is
  /// landscape.floor deep. `region` receives numbers from 0 on in the order of their names, -1 = none,
  /// and `contacts` all between those; returns how many there are.
  int join(HostThreads& threads, const BasinLandscape& landscape, const ShallowLimits& limits,
           Image<std::int32_t>& region, std::vector<BasinContact>& contacts);

 private:
  struct Basin {
    int count_px = 0;
    float bottom = 0;  ///< strength there; unknown_strength where it is known nowhere
  };
  struct Pass {
    float height;  ///< strength; above unknown_strength by the share of the largest step between blind basins
    int a, b;
  };
  /// What is found in rows that follow each other.
  struct Part {
    int begin_y = 0, end_y = 0;
    std::vector<Basin> basins;  ///< what of them is there
    std::vector<BasinContact> contacts;
    std::vector<Pass> passes;
  };
  template <class Work>
  void for_each_part(HostThreads& threads, const Work& work);
  void lay_out_parts(int height, int count);
  int number_basins(HostThreads& threads, const BasinLandscape& landscape, ImageView<std::int32_t> region);
  void measure_basins(const BasinLandscape& landscape, ImageView<const std::int32_t> region, int count,
                      Part& part) const;
  void add_up_basins();
  bool is_shallow(const Pass& pass, const Basin& a, const Basin& b) const;
  bool are_blind(const Basin& a, const Basin& b) const;
  bool may_join(const Pass& pass) const;
  void collect_passes(const BasinLandscape& landscape, Part& part) const;
  void sort_passes();
  void join_passes();
  int number_regions();
  void number_contacts(std::vector<BasinContact>& contacts) const;

  Basin& basin(int i) { return basins_[static_cast<std::size_t>(i)]; }
  const Basin& basin(int i) const { return basins_[static_cast<std::size_t>(i)]; }

  ShallowLimits limits_;
  float floor_ = 0;
  std::vector<Part> parts_;  ///< by worker
  std::vector<Basin> basins_;
  std::vector<Pass> passes_;
  CountingSort<Pass> sort_;
  std::vector<std::int32_t> number_;   ///< of a basin by raster index of its name; then of a region by basin
  std::vector<std::uint8_t> is_name_;  ///< by pixel of a row
  DisjointSets sets_;
};

}  // namespace facet

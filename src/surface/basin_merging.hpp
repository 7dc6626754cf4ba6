#pragma once

#include <cstdint>
#include <vector>

#include "core/depth_noise.hpp"
#include "core/host_threads.hpp"
#include "core/image.hpp"
#include "surface/basin_graph.hpp"
#include "surface/border_competition.hpp"
#include "surface/border_lots.hpp"
#include "surface/merge_params.hpp"
#include "surface/region_joining.hpp"
#include "surface/shallow_basins.hpp"

namespace facet {

/// Merges basins across borders that are no creases, so that noise, texture and the curvature of a cylinder
/// do not split a surface. First, basins that say nothing by themselves join a neighbour. Then regions join
/// that are alike. Last, the borders that are left move to where the patches meet.
class BasinMerging {
 public:
  /// `region` receives, for every pixel, the number of its region, -1 = none.
  void merge(HostThreads& threads, const BasinLandscape& landscape, const MergeParams& params,
             const DepthNoise& noise, Image<std::int32_t>& region);

 private:
  ShallowBasins shallow_;
  std::vector<BasinContact> contacts_;
  BasinGraph graph_;
  BorderLots lots_;
  std::vector<RegionJoining> joinings_;  ///< by lot
  BorderCompetition competition_;
  std::vector<PatchFit> fits_;               ///< by region
  std::vector<BorderJudgement> judgements_;  ///< by border
  std::vector<std::int32_t> first_of_;       ///< basin that names the region, by basin
};

}  // namespace facet

#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "core/depth_noise.hpp"
#include "core/image.hpp"
#include "surface/basin_graph.hpp"
#include "surface/border_competition.hpp"
#include "surface/merge_params.hpp"
#include "surface/shallow_basins.hpp"

namespace facet {

/// Merges basins across borders that are no creases, so that noise, texture and the curvature of a cylinder
/// do not split a surface. First, basins that say nothing by themselves join a neighbour. Then regions join
/// by the difference to be expected of their patches, least first, if one patch explains both; first across
/// borders that turn by little, so that fits within faces are sure before those near creases are judged by
/// them. Last, the borders that are left move to where the patches meet.
class BasinMerging {
 public:
  /// `region` receives, for every pixel, the number of its region, -1 = none.
  void merge(const BasinLandscape& landscape, const MergeParams& params, const DepthNoise& noise,
             Image<std::int32_t>& region);

 private:
  /// What a border was like when its difference was computed.
  struct Judgement {
    double pixels = 0;  ///< of both regions
    int length = 0;     ///< of the border
    int serial = 0;     ///< the newest judgement of a border counts
  };
  struct Candidate {
    float difference;  ///< to be expected
    int border, serial;
  };
  static bool is_later(const Candidate& l, const Candidate& r) {
    return std::tie(l.difference, l.border) > std::tie(r.difference, r.border);
  }
  double reading_variance(const PatchMoments& moments) const;
  PatchFit fitted(const PatchMoments& moments) const;
  bool has_changed(int border);
  /// Whether the border is a candidate, the last one then.
  bool judge(int border);
  void judge_anew(int border);
  bool explains_both(const PatchFit& fit, const PatchMoments& both, int a, int b) const;
  bool join_across(int border);
  /// Whether it joined any; what it refused may be alike when its sides have grown.
  bool join_alike(float most_strength);

  ShallowBasins shallow_;
  std::vector<BasinContact> contacts_;
  BasinGraph graph_;
  BorderCompetition competition_;
  std::vector<PatchFit> fits_;          ///< by region
  std::vector<Judgement> judgements_;   ///< by border
  std::vector<Candidate> candidates_;   ///< a heap, least difference first
  std::vector<std::int32_t> first_of_;  ///< basin that names the region, by basin
  float most_strength_ = 0;             ///< borders stronger than this are not judged yet
  MergeParams params_;
  SeamTolerance tolerance_;
  DepthNoise noise_;
  double focal_px_ = 1;
};

}  // namespace facet

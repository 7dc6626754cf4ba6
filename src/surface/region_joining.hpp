#pragma once

#include <span>
#include <tuple>
#include <vector>

#include "core/depth_noise.hpp"
#include "surface/basin_graph.hpp"
#include "surface/merge_params.hpp"
#include "surface/patch_fit.hpp"
#include "surface/patch_seam.hpp"

namespace facet {

/// The patch of a region: the most likely one for its pixels, of a surface of usual slope and curvature.
PatchFit fit_region(const PatchMoments& moments, const MergeParams& params, const DepthNoise& noise,
                    double focal_px);

/// What a border was like when its difference was computed.
struct BorderJudgement {
  double pixels = 0;  ///< of both regions
  int length = 0;     ///< of the border
  int serial = 0;     ///< the newest judgement of a border counts
};

/// Regions that are to be joined where they are alike.
struct JoiningTask {
  BasinGraph& graph;
  std::span<PatchFit> fits;               ///< by region; of joined ones the new one
  std::span<BorderJudgement> judgements;  ///< by border
  MergeParams params;
  DepthNoise noise;
  double focal_px = 1;
};

/// Joins regions by the difference to be expected of their patches, least first, if one patch explains both;
/// first across borders that turn by little, so that fits within faces are sure before those near creases are
/// judged by them.
class RegionJoining {
 public:
  /// `borders`: those that are looked at. Another one may be at work on the same task as long as no chain of
  /// borders leads from the regions of the one to those of the other.
  void run(const JoiningTask& task, std::span<const int> borders);

 private:
  struct Candidate {
    float difference;  ///< to be expected
    int border, serial;
  };
  static bool is_later(const Candidate& l, const Candidate& r) {
    return std::tie(l.difference, l.border) > std::tie(r.difference, r.border);
  }
  bool has_changed(const JoiningTask& task, int border) const;
  /// Whether the border is a candidate, the last one then.
  bool judge(const JoiningTask& task, int border);
  void judge_anew(const JoiningTask& task, int border);
  bool join_across(const JoiningTask& task, int border);
  /// Whether it joined any; what it refused may be alike when its sides have grown.
  bool join_alike(const JoiningTask& task, std::span<const int> borders, float most_strength);

  std::vector<Candidate> candidates_;  ///< a heap, least difference first
  std::vector<int> touched_;
  SeamTolerance tolerance_;
  float most_strength_ = 0;  ///< borders stronger than this are not judged yet
};

}  // namespace facet

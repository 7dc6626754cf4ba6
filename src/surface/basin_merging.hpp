#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "core/depth_noise.hpp"
#include "core/image.hpp"
#include "surface/basin_graph.hpp"
#include "surface/border_competition.hpp"
#include "surface/shallow_basins.hpp"

namespace facet {

/// When a border between two regions is a crease: the patches fitted to both sides must differ where they
/// meet, by more than a smooth surface's would and more than their noise explains.
struct MergeParams {
  /// Least angle between the patches [deg], 0..180.
  float crease_deg = 25;
  /// Least step between the patches, relative to depth [m/m], 0..1: a third of the least jump of a depth
  /// edge.
  float step_ratio = 0.005f;
  float fit_sigmas = 3;        ///< least difference in deviations of the fits, 0..100
  float curve_radius_mm = 40;  ///< radius of usual curved surfaces [mm], 0..100000; 0 = patches are planes
  float flat_deg = 45;         ///< borders that turn by less are judged first [deg], 0..180
  /// Farthest that a border moves to where the patches meet [px], 0..16: strengths are known to within the
  /// window of the normals.
  int border_moves_px = 4;
};

/// Merges basins across borders that are no creases, so that noise, texture and the curvature of a cylinder
/// do not split a surface. First, small basins that are no deeper than noise join the neighbour across their
/// lowest pass. Then regions join by the difference to be expected of their patches, least first, if one
/// patch explains both; first across borders that turn by little, so that fits within faces are sure before
/// those near creases are judged by them. Last, the borders that are left move to where the patches meet.
class BasinMerging {
 public:
  /// `region` receives, for every pixel, the number of its region, -1 = none.
  void merge(const BasinLandscape& landscape, const MergeParams& params, const DepthNoise& noise,
             Image<std::int32_t>& region);

 private:
  /// What a border was like when its difference was computed.
  struct Judgement {
    double pixels = 0, fewer_pixels = 0;  ///< of both regions, and of the smaller one
    int length = 0;                       ///< of the border
    int serial = 0;                       ///< the newest judgement of a border counts
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
  bool has_changed(int border, double growth);
  void judge(int border);
  bool explains_both(const PatchFit& fit, const PatchMoments& both, int a, int b) const;
  void join_across(int border);
  void join_alike(float most_strength);

  ShallowBasins shallow_;
  BasinGraph graph_;
  BorderCompetition competition_;
  std::vector<PatchFit> fits_;         ///< by region
  std::vector<double> judged_px_;      ///< pixels of a region when all its borders were last looked at
  std::vector<Judgement> judgements_;  ///< by border
  std::vector<Candidate> candidates_;  ///< a heap, least difference first
  float most_strength_ = 0;            ///< borders stronger than this are not judged yet
  MergeParams params_;
  SeamTolerance tolerance_;
  DepthNoise noise_;
  double focal_px_ = 1;
};

}  // namespace facet

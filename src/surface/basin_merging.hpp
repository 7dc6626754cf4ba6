#pragma once

#include <cstdint>
#include <vector>

#include "core/depth_noise.hpp"
#include "core/image.hpp"
#include "surface/basin_graph.hpp"

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
};

/// Merges basins across borders that are no creases, so that noise, texture and the curvature of a cylinder
/// do not split a surface. First, small basins that are no deeper than noise join the neighbour across their
/// lowest pass. Then regions join by the difference of their patches, least first, in rounds in which a
/// region joins once at most, so that every decision rests on what the regions are now; first across borders
/// that turn by little, so that fits within faces are sure before those near creases are judged by them.
class BasinMerging {
 public:
  /// `region` receives, for every pixel, a raster index naming its region, -1 = none.
  void merge(const BasinLandscape& landscape, const MergeParams& params, const DepthNoise& noise,
             Image<std::int32_t>& region);

 private:
  struct Candidate {
    float difference = 0;
    int a = 0, b = 0;
  };
  void join_shallow_basins(float floor);
  void fit(int i);
  bool merge_round(float most_strength);

  BasinGraph graph_;
  std::vector<PatchFit> fits_;  ///< by basin
  std::vector<int> joined_in_;  ///< last round in which a basin's region changed
  std::vector<Candidate> candidates_;
  std::vector<int> order_;
  int round_ = 0;
  MergeParams params_;
  DepthNoise noise_;
  double focal_px_ = 1;
};

}  // namespace facet

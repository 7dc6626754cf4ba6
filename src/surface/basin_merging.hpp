#pragma once

#include <cstdint>
#include <vector>

#include "core/depth_noise.hpp"
#include "core/image.hpp"
#include "surface/patch_fit.hpp"

namespace facet {

/// The over-segmentation into basins and what it was made from.
struct BasinLandscape {
  ImageView<const std::int32_t> basin;          ///< raster index naming the basin, -1 = none
  ImageView<const std::int32_t> inverse_depth;  ///< fixed point, as stage/normals.hpp makes it; unit below
  double inverse_depth_unit = 1;                ///< 1/m per step
  ImageView<const float> strength;              ///< crease strength, chord of the angle
  ImageView<const std::uint8_t> distance_px;
  int guard_px = 0;  ///< strength is known where the distance is larger
};

/// When a border between two regions is a crease: it must rise above the strength inside both of them, and
/// two patches must explain the pixels better than one: better than one plane and, where the border turns by
/// little enough for a smooth surface, better than one quadric.
struct MergeCriteria {
  float rise_deg = 10;
  float smooth_deg = 45;
  float fit_ratio = 10;  ///< (residual of one patch - of two) / 3 over the noise of one independent reading
};

/// Merges basins across borders that are no creases, so that noise, texture and the even curvature of a
/// cylinder do not split a surface: there the border is as strong as its surroundings. In rounds, each taking
/// the borders from the least convincing one upwards and merging a region once at most, so that every
/// decision rests on what the regions are now; until a round merges nothing.
class BasinMerging {
 public:
  /// `region` receives, for every pixel, a raster index naming its region, -1 = none.
  void merge(const BasinLandscape& landscape, const MergeCriteria& criteria, const DepthNoise& noise,
             Image<std::int32_t>& region);

 private:
  struct Basin {
    int parent = 0;  ///< union-find over basins
    std::int32_t name = 0;
    int merged_in = 0;        ///< last round in which it changed
    double strength_sum = 0;  ///< over pixels where it is known
    double strength_count = 0;
    PatchMoments moments;
  };
  struct Border {
    int a = 0, b = 0;        ///< a < b
    float strength_sum = 0;  ///< over pairs of pixels where it is known
    float strength_count = 0;
    float rise = 0;
    int place = 0;  ///< in the order before sorting
  };

  void collect_basins(const BasinLandscape& landscape);
  void collect_borders(const BasinLandscape& landscape);
  void aggregate_borders();
  bool merge_round();
  int find(int i);
  float rise_of(const Border& border) const;
  bool is_crease(const Border& border) const;
  bool needs_two_patches(const PatchMoments& a, const PatchMoments& b, bool may_be_smooth) const;

  std::vector<Basin> basins_;
  std::vector<Border> borders_;
  std::vector<std::int32_t> index_;  ///< basin index by raster index of its name
  int round_ = 0;
  MergeCriteria criteria_;
  DepthNoise noise_;
};

}  // namespace facet

#pragma once

#include <cstdint>
#include <queue>
#include <unordered_map>
#include <vector>

#include "core/depth_noise.hpp"
#include "core/image.hpp"

namespace facet {

/// Sums of a plane fit of inverse depth, q = c + a x + b y, over the pixels of a region; two regions' sums add up.
/// x, y [px] relative to the image centre, q [1/m].
struct PlaneMoments {
  double n = 0, x = 0, y = 0, q = 0, xx = 0, xy = 0, yy = 0, xq = 0, yq = 0, qq = 0;

  void add(double px, double py, double pq);
  PlaneMoments& operator+=(const PlaneMoments& other);
  /// Sum of squared residuals of the least-squares plane [1/m^2].
  double residual() const;
};

/// The over-segmentation into basins and what it was made from.
struct BasinLandscape {
  ImageView<const std::int32_t> basin;    ///< raster index naming the basin, -1 = none
  ImageView<const float> depth_m;
  ImageView<const float> strength;        ///< crease strength, chord of the angle
  ImageView<const std::uint8_t> distance_px;
  int guard_px = 0;                       ///< strength is known where the distance is larger
};

/// When a border between two regions is a crease: it must rise above the strength inside both of them, and two
/// planes must explain the pixels better than one.
struct MergeCriteria {
  float rise_deg = 10;
  float fit_ratio = 10;  ///< (residual of one plane - of two) / 3 over the noise of one independent reading
};

/// Merges basins across borders that are no creases, the least convincing border first, so that noise, texture and
/// the even curvature of a cylinder do not split a surface: there the border is as strong as its surroundings.
class BasinMerging {
 public:
  /// `region` receives, for every pixel, a raster index naming its region, -1 = none.
  void merge(const BasinLandscape& landscape, const MergeCriteria& criteria, const DepthNoise& noise,
             Image<std::int32_t>& region);

 private:
  struct Basin {
    int parent = 0;
    std::int32_t name = 0;
    int version = 0;
    double strength_sum = 0;  ///< over pixels where it is known
    double strength_count = 0;
    PlaneMoments moments;
    std::unordered_map<int, int> border_with;  ///< neighbour -> index into borders_
  };
  struct Border {
    double strength_sum = 0;  ///< over pairs of pixels where it is known
    double strength_count = 0;
    int length_px = 0;
  };
  struct Candidate {
    float rise = 0;
    int a = 0, b = 0;
    int version_a = 0, version_b = 0;
    bool operator<(const Candidate& other) const;  ///< weakest first in a max heap
  };

  void collect(const BasinLandscape& landscape);
  void add_border_pair(const BasinLandscape& landscape, int a, int b, int x0, int y0, int x1, int y1);
  int find(int i);
  void consider(int a, int b);
  float rise_of(int a, int b, const Border& border) const;
  bool is_crease(const Candidate& candidate);
  void unite(int a, int b);

  std::vector<Basin> basins_;
  std::vector<Border> borders_;
  std::vector<std::int32_t> index_;  ///< basin index by raster index of its name
  std::priority_queue<Candidate> queue_;
  MergeCriteria criteria_;
  DepthNoise noise_;
};

}  // namespace facet

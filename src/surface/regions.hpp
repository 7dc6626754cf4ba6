#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/camera.hpp"
#include "core/image.hpp"
#include "surface/contours.hpp"
#include "surface/pose.hpp"
#include "surface/region_statistics.hpp"
#include "surface/validation.hpp"

namespace facet {

/// Runs of the pixels of components, in raster order.
struct ComponentRuns {
  std::span<const int> begin, end;          ///< columns of each run
  std::span<const int> first_of_row;        ///< the run with which each row begins, and the number of runs
  std::span<const int> first_of_component;  ///< the first run of each run's component
};

/// Numbers the components that may be surfaces, in raster order of their first pixels; drops those that are
/// too small or mostly made-up depth, with a reason, so that their pixels can go to the surfaces around them.
/// Keeps its memory between frames.
class RegionNumbering {
 public:
  /// Writes labels (0 = none); appends to `rejected`. Returns the number of labels.
  int number(const ComponentRuns& runs, ImageView<const float> depth_m, ImageView<const std::uint8_t> filled,
             const Camera& camera, const ValidationParams& validation, ImageView<std::uint16_t> labels,
             std::vector<RejectedRegion>& rejected);
  /// The same where `root` holds the raster index of each pixel's component, -1 = none.
  int number(ImageView<const std::int32_t> root, ImageView<const float> depth_m,
             ImageView<const std::uint8_t> filled, const Camera& camera, const ValidationParams& validation,
             ImageView<std::uint16_t> labels, std::vector<RejectedRegion>& rejected);
  /// The same for components that are known, in raster order of their first pixels; `width_px` of the image.
  int choose(std::span<const RegionStatistics> components, int width_px, const Camera& camera,
             const ValidationParams& validation, std::vector<RejectedRegion>& rejected);
  std::span<const std::uint16_t> labels() const { return label_; }  ///< of the components, 0 = none

 private:
  ComponentRuns list_runs(ImageView<const std::int32_t> root);
  void collect(const ComponentRuns& runs, ImageView<const float> depth_m,
               ImageView<const std::uint8_t> filled);
  void write_labels(const ComponentRuns& runs, ImageView<std::uint16_t> labels);

  std::vector<RegionStatistics> components_;
  std::vector<int> component_of_;  ///< by run
  std::vector<int> begin_, end_, first_of_row_, first_of_component_;
  std::vector<std::int32_t> run_at_;  ///< by raster index of a component's first pixel, set there alone
  std::vector<std::uint16_t> label_, row_;
};

/// What validation and pose need to know of the pixels of each label; filled in one pass over the label
/// image.
class RegionPixels {
 public:
  std::vector<PixelBox> boxes;
  std::vector<int> area_px;
  std::vector<int> measured_px;  ///< pixels whose depth was not made up by filling
  std::vector<PointSample> points;

  /// `filled`: 1 where depth was made up. Every region is sampled evenly, at most about max_points each.
  void collect(ImageView<const std::uint16_t> labels, int label_count, ImageView<const float> depth_m,
               ImageView<const std::uint8_t> filled, const Camera& camera, int max_points);

 private:
  struct Run {
    std::size_t region = 0;
    int y = 0, begin = 0, end = 0;
  };
  void sample_points(ImageView<const float> depth_m, ImageView<const std::uint8_t> filled,
                     const Camera& camera, int max_points);
  /// Samples measured pixels of a row; `ray_y`: of the row.
  void sample_run(std::size_t region, float ray_y, int begin, int end, const float* depth_m);

  std::vector<Run> runs_;
  std::vector<int> stride_, wait_;  ///< of the samples, by region
  std::vector<std::size_t> taken_;
  std::vector<float> ray_x_;  ///< of the columns: x of the point at a depth of 1 m
};

}  // namespace facet

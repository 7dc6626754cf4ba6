#pragma once

#include <vector>

#include "surface/surface.hpp"
#include "truth/truth_map.hpp"

namespace facet {

/// Pixels of an outline.
using Outline = std::vector<ContourPoint>;

/// Outer outlines of the labels 1 ... count of a label image, one pixel wide, on the label's own pixels
/// (cv::findContours, RETR_EXTERNAL); every pixel once, in raster order. Pixels with void among their eight
/// neighbours are left out.
std::vector<Outline> region_outlines(const Image<std::uint16_t>& labels, std::size_t count,
                                     const Image<TruthRegion>& regions);

/// Counts outline pixels that lie near others. Reused for many pairs of outlines of one frame.
class NearbyCounter {
 public:
  /// "Near" is a distance of at most `radius_px`.
  NearbyCounter(Size size, double radius_px);
  /// Number of `points` with a pixel of `others` near.
  int count(const Outline& points, const Outline& others);

 private:
  std::vector<ContourPoint> disk_;
  Image<std::int32_t> stamp_;
  std::int32_t current_ = 0;
};

/// Radius of the dilation of boundary scores (UOIS): ceil(0.003 image diagonal) [px].
double boundary_radius_px(Size size);

}  // namespace facet

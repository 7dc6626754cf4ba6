#pragma once

#include <opencv2/core/mat.hpp>

#include "dataset/dataset.hpp"

namespace facet {

/// The range of depths that a picture spans: from the 1st to the 99th percentile of what was measured.
struct DepthRange {
  float nearest_m = 0, farthest_m = 0;  ///< both 0 where nothing was measured

  /// 0 at the near end, 1 at the far end, in equal steps of inverse depth, clamped.
  double position(float depth_m) const;
};
DepthRange displayed_range(const Image<float>& depth_m);

/// Depth in the perceptually uniform colours of viridis, near = light; missing depth is black.
cv::Mat draw_depth(const Frame& frame);

/// The colours of draw_depth from near to far, as a strip of that size.
cv::Mat draw_depth_scale(cv::Size size);

}  // namespace facet

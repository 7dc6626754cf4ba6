#include "overlay/depth_panel.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "overlay/panel.hpp"

namespace facet {
namespace {

/// Grey levels 0..255 from far to near, so that the light end of viridis is near.
std::uint8_t level_of(double position) {
  return static_cast<std::uint8_t>(std::lround(255 * (1 - position)));
}

cv::Mat colored(const cv::Mat& levels) {
  cv::Mat bgr;
  cv::applyColorMap(levels, bgr, cv::COLORMAP_VIRIDIS);
  return bgr;
}

}  // namespace

double DepthRange::position(float depth_m) const {
  if (farthest_m <= nearest_m || depth_m <= nearest_m) return depth_m > nearest_m ? 1 : 0;
  // Equal steps of inverse depth: the sensor's resolution is spread evenly, and a far wall leaves the table
  // its share.
  const double near = 1.0 / nearest_m, far = 1.0 / farthest_m;
  return std::min((near - 1.0 / depth_m) / (near - far), 1.0);
}

DepthRange displayed_range(const Image<float>& depth_m) {
  std::vector<float> measured;
  for (int y = 0; y < depth_m.height(); ++y)
    std::copy_if(depth_m.row(y), depth_m.row(y) + depth_m.width(), std::back_inserter(measured),
                 [](float depth) { return depth > 0; });
  if (measured.empty()) return {};
  const auto percentile = [&](std::size_t percent) {
    const auto place = measured.begin() + static_cast<std::ptrdiff_t>((measured.size() - 1) * percent / 100);
    std::nth_element(measured.begin(), place, measured.end());
    return *place;
  };
  const float nearest_m = percentile(1);
  return {nearest_m, percentile(99)};
}

cv::Mat draw_depth(const Frame& frame) {
  const DepthRange range = displayed_range(frame.depth_m);
  cv::Mat levels(frame.depth_m.height(), frame.depth_m.width(), CV_8U);
  cv::Mat missing(levels.size(), CV_8U);
  for (int y = 0; y < levels.rows; ++y) {
    for (int x = 0; x < levels.cols; ++x) {
      levels.at<std::uint8_t>(y, x) = level_of(range.position(frame.depth_m(x, y)));
      missing.at<std::uint8_t>(y, x) = frame.depth_m(x, y) > 0 ? 0 : 255;
    }
  }
  cv::Mat bgr = colored(levels), panel;
  bgr.setTo(cv::Scalar::all(0), missing);
  const PanelGeometry geometry(frame.depth_m.size());
  cv::resize(bgr, panel, geometry.panel_size, 0, 0, geometry.scale < 1 ? cv::INTER_AREA : cv::INTER_NEAREST);
  return panel;
}

cv::Mat draw_depth_scale(cv::Size size) {
  cv::Mat levels(size, CV_8U);
  for (int x = 0; x < size.width; ++x) levels.col(x) = level_of(x / std::max(1.0, size.width - 1.0));
  return colored(levels);
}

}  // namespace facet

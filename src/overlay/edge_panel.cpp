#include "overlay/edge_panel.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace facet {
namespace {

bool is_graspable(int code) {
  return (code & graspable_edge_bit) != 0;
}

/// Paints every edge pixel of one class as a square that is at least `least_side_px` wide on the panel.
void paint(cv::Mat& panel, const Image<std::uint8_t>& edges, bool graspable, double least_side_px) {
  const PanelGeometry geometry(edges.size());
  const double half = std::max(geometry.scale, least_side_px) / 2;
  for (int y = 0; y < edges.height(); ++y) {
    for (int x = 0; x < edges.width(); ++x) {
      const int code = edges(x, y);
      if (code == 0 || is_graspable(code) != graspable) continue;
      const cv::Point2d centre = geometry.to_panel(x, y) + cv::Point2d(0.5, 0.5);
      const cv::Point from(cvRound(centre.x - half), cvRound(centre.y - half));
      const cv::Point to(cvRound(centre.x + half), cvRound(centre.y + half));
      const cv::Rect square = cv::Rect(from, to) & cv::Rect({}, panel.size());
      panel(square).setTo(edge_color(edges(x, y)));
    }
  }
}

}  // namespace

cv::Scalar edge_color(std::uint8_t code) {
  const double brightness = is_graspable(code) ? 1.0 : 0.72;
  switch (edge_kind_of(code)) {
    case EdgeKind::depth:
      return brightness * cv::Scalar(60, 60, 255);
    case EdgeKind::convex:
      return brightness * cv::Scalar(80, 235, 60);
    case EdgeKind::concave:
      return cv::Scalar(255, 165, 70);
    default:
      return cv::Scalar::all(0);
  }
}

cv::Mat draw_edges(const Frame& frame, const Prediction& prediction) {
  constexpr double plain_side_px = 2, graspable_side_px = 3;
  cv::Mat panel = draw_ground(frame, 0.5);
  paint(panel, prediction.edges, false, plain_side_px);
  paint(panel, prediction.edges, true, graspable_side_px);
  return panel;
}

}  // namespace facet

#include "score/region_outlines.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/neighbours.hpp"
#include "score/offsets.hpp"
#include "surface/contours.hpp"

namespace facet {
namespace {

Outline outline(const Image<std::uint16_t>& labels, int label, const PixelBox& box) {
  cv::Mat mask(box.y1 - box.y0 + 1, box.x1 - box.x0 + 1, CV_8U);
  for (int y = box.y0; y <= box.y1; ++y)
    for (int x = box.x0; x <= box.x1; ++x)
      mask.at<std::uint8_t>(y - box.y0, x - box.x0) = labels(x, y) == label ? 1 : 0;
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(mask, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE, {box.x0, box.y0});
  Outline points;
  for (const auto& contour : contours)
    for (const cv::Point p : contour) points.push_back({p.x, p.y});
  std::sort(points.begin(), points.end(),
            [](ContourPoint a, ContourPoint b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

bool touches_void(ContourPoint p, const Image<TruthRegion>& regions) {
  for (int i = 0; i < 8; ++i) {
    const int x = p.x + neighbour8(i).dx, y = p.y + neighbour8(i).dy;
    if (regions.size().contains(x, y) && regions(x, y) == TruthRegion::ignored) return true;
  }
  return false;
}

}  // namespace

std::vector<Outline> region_outlines(const Image<std::uint16_t>& labels, std::size_t count,
                                     const Image<TruthRegion>& regions) {
  std::vector<PixelBox> boxes(count, PixelBox{labels.width(), labels.height(), -1, -1});
  for (int y = 0; y < labels.height(); ++y)
    for (int x = 0; x < labels.width(); ++x)
      if (labels(x, y) != 0) boxes[labels(x, y) - 1u].add(x, y);
  std::vector<Outline> outlines(count);
  for (std::size_t k = 0; k < count; ++k) {
    if (boxes[k].empty()) continue;
    outlines[k] = outline(labels, static_cast<int>(k) + 1, boxes[k]);
    std::erase_if(outlines[k], [&](ContourPoint p) { return touches_void(p, regions); });
  }
  return outlines;
}

NearbyCounter::NearbyCounter(Size size, double radius_px) : stamp_(size, 0) {
  for (const GridOffset& o : offsets_within(radius_px)) disk_.push_back({o.dx, o.dy});
}

int NearbyCounter::count(const Outline& points, const Outline& others) {
  ++current_;
  for (const ContourPoint p : others) {
    for (const ContourPoint d : disk_)
      if (stamp_.size().contains(p.x + d.x, p.y + d.y)) stamp_(p.x + d.x, p.y + d.y) = current_;
  }
  return static_cast<int>(std::count_if(points.begin(), points.end(),
                                        [&](ContourPoint p) { return stamp_(p.x, p.y) == current_; }));
}

double boundary_radius_px(Size size) {
  return std::ceil(0.003 * std::hypot(size.width, size.height) - distance_slack_px);
}

}  // namespace facet

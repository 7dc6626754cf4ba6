#include "overlay/surface_panel.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "prediction/label_images.hpp"

namespace facet {
namespace {

cv::Mat panel_labels(const Image<std::uint16_t>& labels) {
  cv::Mat panel;
  cv::resize(as_mat(labels), panel, PanelGeometry(labels.size()).panel_size, 0, 0, cv::INTER_NEAREST);
  return panel;
}

bool differs_right_or_below(const cv::Mat& labels, int x, int y) {
  const auto label = labels.at<std::uint16_t>(y, x);
  const bool right = x + 1 < labels.cols && labels.at<std::uint16_t>(y, x + 1) != label;
  const bool below = y + 1 < labels.rows && labels.at<std::uint16_t>(y + 1, x) != label;
  return right || below;
}

void blend(cv::Mat& panel, const cv::Mat& labels, const std::map<int, cv::Scalar>& colors) {
  constexpr double share = 0.62;
  for (int y = 0; y < panel.rows; ++y) {
    for (int x = 0; x < panel.cols; ++x) {
      auto& pixel = panel.at<cv::Vec3b>(y, x);
      if (differs_right_or_below(labels, x, y)) {
        pixel = cv::Vec3b::all(255);
      } else if (const int label = labels.at<std::uint16_t>(y, x); label != 0) {
        const cv::Scalar& color = colors.at(label);
        for (int c = 0; c < 3; ++c)
          pixel[c] = cv::saturate_cast<std::uint8_t>(share * color[c] + (1 - share) * pixel[c]);
      }
    }
  }
}

std::map<int, cv::Rect> bounding_boxes(const cv::Mat& labels) {
  std::map<int, cv::Rect> boxes;
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      if (const int label = labels.at<std::uint16_t>(y, x); label != 0) boxes[label] |= cv::Rect(x, y, 1, 1);
  return boxes;
}

/// Writes the id where the surface is widest, if it fits in there.
void write_id(cv::Mat& panel, const cv::Mat& labels, int id, const cv::Rect& box) {
  const std::string text = std::to_string(id);
  const int needed_px = text_width(text) + 4;
  if (std::min(box.width, box.height) < needed_px) return;
  cv::Mat padded, distance_px;
  cv::copyMakeBorder(labels(box) == id, padded, 1, 1, 1, 1, cv::BORDER_CONSTANT | cv::BORDER_ISOLATED,
                     cv::Scalar(0));
  cv::distanceTransform(padded, distance_px, cv::DIST_L2, cv::DIST_MASK_3);
  double radius_px = 0;
  cv::Point centre;
  cv::minMaxLoc(distance_px, nullptr, &radius_px, nullptr, &centre);
  if (2 * radius_px < needed_px) return;
  const cv::Point middle = box.tl() + centre - cv::Point(1, 1);
  draw_text(panel, text, middle - cv::Point(text_width(text) / 2, text_height_px / 2), cv::Scalar::all(0));
}

}  // namespace

cv::Mat draw_surfaces(const Frame& frame, const Prediction& prediction,
                      const std::map<int, cv::Scalar>& colors) {
  cv::Mat panel = draw_ground(frame, 0.8);
  const cv::Mat labels = panel_labels(prediction.labels);
  blend(panel, labels, colors);
  for (const auto& [id, box] : bounding_boxes(labels)) write_id(panel, labels, id, box);
  return panel;
}

}  // namespace facet

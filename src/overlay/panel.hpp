#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "dataset/dataset.hpp"
#include "prediction/prediction.hpp"

namespace facet {

/// Where the pixels of an image lie in a panel: scaled to fit, aspect kept.
struct PanelGeometry {
  explicit PanelGeometry(Size image);
  double scale = 1;     ///< panel pixels per image pixel
  cv::Size panel_size;  ///< at most 640 in either direction

  /// Panel coordinates of a place in the image; in both, pixel centres are at integers.
  cv::Point2d to_panel(double x_px, double y_px) const {
    return {(x_px + 0.5) * scale - 0.5, (y_px + 0.5) * scale - 0.5};
  }
};

/// An entry of a panel's legend.
struct LegendEntry {
  std::string text;
  cv::Scalar bgr;
};

/// The frame's colour image (where it has none, its depth in grey, near = light) in the size of a panel.
cv::Mat draw_color(const Frame& frame);
/// The same without colour, as a ground for drawing: mixed with black, `brightness` 0..1.
cv::Mat draw_ground(const Frame& frame, double brightness);

/// Writes one line of text, its top left corner at `corner`; returns its width in pixels.
int draw_text(cv::Mat& image, const std::string& text, cv::Point corner, const cv::Scalar& bgr);
int text_width(const std::string& text);
inline constexpr int text_height_px = 18;  ///< of a line without spacing

/// The panel below a line with its title on the left and a legend on the right.
cv::Mat with_title(const cv::Mat& panel, const std::string& title,
                   const std::vector<LegendEntry>& legend = {});

/// The picture in the middle of a white image of that size, aspect kept.
cv::Mat fitted(const cv::Mat& picture, cv::Size size);

/// Panels in rows, white between them. All panels of a row have the same height.
cv::Mat panel_grid(const std::vector<std::vector<cv::Mat>>& rows);

}  // namespace facet

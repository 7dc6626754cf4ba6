#include "overlay/panel.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "overlay/depth_panel.hpp"

namespace facet {
namespace {

constexpr double panel_side_px = 640;
constexpr int title_height_px = 34;
constexpr int font = cv::FONT_HERSHEY_DUPLEX;
constexpr double font_scale = 0.62;
const cv::Scalar black(0, 0, 0), white(255, 255, 255);

/// Depth in grey, near = light, missing = black.
cv::Mat grey_depth(const Frame& frame) {
  const DepthRange range = displayed_range(frame.depth_m);
  cv::Mat grey(frame.depth_m.height(), frame.depth_m.width(), CV_8UC3);
  for (int y = 0; y < grey.rows; ++y) {
    for (int x = 0; x < grey.cols; ++x) {
      const float depth = frame.depth_m(x, y);
      const double value = depth > 0 ? 235 - 180 * range.position(depth) : 0;
      grey.at<cv::Vec3b>(y, x) = cv::Vec3b::all(cv::saturate_cast<std::uint8_t>(value));
    }
  }
  return grey;
}

}  // namespace

PanelGeometry::PanelGeometry(Size image) {
  scale = panel_side_px / std::max({image.width, image.height, 1});
  panel_size = {std::max(1, static_cast<int>(std::lround(image.width * scale))),
                std::max(1, static_cast<int>(std::lround(image.height * scale)))};
}

cv::Mat draw_color(const Frame& frame) {
  const PanelGeometry geometry(frame.depth_m.size());
  const cv::Mat image = frame.color.empty() ? grey_depth(frame) : frame.color;
  cv::Mat panel;
  cv::resize(image, panel, geometry.panel_size, 0, 0,
             geometry.scale < 1 ? cv::INTER_AREA : cv::INTER_NEAREST);
  return panel;
}

cv::Mat draw_ground(const Frame& frame, double brightness) {
  cv::Mat grey, ground;
  cv::cvtColor(draw_color(frame), grey, cv::COLOR_BGR2GRAY);
  cv::cvtColor(grey, ground, cv::COLOR_GRAY2BGR);
  constexpr double darkest = 45;  // so that dark objects still show on the ground
  ground.convertTo(ground, CV_8UC3, brightness * (1 - darkest / 255), brightness * darkest);
  return ground;
}

int text_width(const std::string& text) {
  int baseline = 0;
  return cv::getTextSize(text, font, font_scale, 1, &baseline).width;
}

int draw_text(cv::Mat& image, const std::string& text, cv::Point corner, const cv::Scalar& bgr) {
  constexpr int ascent_px = 14;
  cv::putText(image, text, corner + cv::Point(0, ascent_px), font, font_scale, bgr, 1, cv::LINE_AA);
  return text_width(text);
}

cv::Mat fitted(const cv::Mat& picture, cv::Size size) {
  const double scale = std::min(static_cast<double>(size.width) / picture.cols,
                                static_cast<double>(size.height) / picture.rows);
  const cv::Size drawn(std::clamp(static_cast<int>(std::lround(picture.cols * scale)), 1, size.width),
                       std::clamp(static_cast<int>(std::lround(picture.rows * scale)), 1, size.height));
  cv::Mat image(size, CV_8UC3, white);
  cv::Mat middle =
      image({(size.width - drawn.width) / 2, (size.height - drawn.height) / 2, drawn.width, drawn.height});
  cv::resize(picture, middle, drawn, 0, 0, cv::INTER_AREA);
  return image;
}

cv::Mat panel_grid(const std::vector<std::vector<cv::Mat>>& rows) {
  constexpr int margin_px = 10;
  const auto white_border = [](const cv::Mat& panel, int bottom, int left, int right) {
    cv::Mat framed;
    cv::copyMakeBorder(panel, framed, 0, bottom, left, right, cv::BORDER_CONSTANT, white);
    return framed;
  };
  std::vector<cv::Mat> joined;
  int width = 0;
  for (const std::vector<cv::Mat>& row : rows) {
    std::vector<cv::Mat> framed;
    for (const cv::Mat& panel : row) framed.push_back(white_border(panel, 0, margin_px, 0));
    cv::hconcat(framed, joined.emplace_back());
    width = std::max(width, joined.back().cols);
  }
  for (cv::Mat& row : joined) row = white_border(row, margin_px, 0, width - row.cols + margin_px);
  cv::Mat picture;
  cv::vconcat(joined, picture);
  return picture;
}

cv::Mat with_title(const cv::Mat& panel, const std::string& title, const std::vector<LegendEntry>& legend) {
  constexpr int swatch_px = 14, gap_px = 6, top_px = 9;
  const int width = std::max(panel.cols, static_cast<int>(panel_side_px));
  cv::Mat framed(panel.rows + title_height_px, width, CV_8UC3, white);
  panel.copyTo(framed(cv::Rect((width - panel.cols) / 2, title_height_px, panel.cols, panel.rows)));
  draw_text(framed, title, {1, top_px}, black);
  int x = width;
  for (auto entry = legend.rbegin(); entry != legend.rend(); ++entry) {
    x -= text_width(entry->text);
    draw_text(framed, entry->text, {x, top_px}, black);
    x -= swatch_px + gap_px;
    cv::rectangle(framed, {x, top_px + 1, swatch_px, swatch_px}, entry->bgr, cv::FILLED);
    x -= 2 * gap_px;
  }
  return framed;
}

}  // namespace facet

#include "overlay/strip.hpp"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "overlay/edge_panel.hpp"
#include "overlay/palette.hpp"
#include "overlay/panel.hpp"
#include "overlay/surface_panel.hpp"

namespace facet {
namespace {

constexpr int margin_px = 5;
constexpr double scale = 0.6;  // of other pictures: many steps stand in a row

cv::Mat draw_step(const Frame& frame, const StripStep& step) {
  const auto colors = surface_colors(step.prediction.labels);
  cv::Mat column;
  cv::vconcat(with_title(draw_edges(frame, step.prediction), step.title),
              with_title(draw_surfaces(frame, step.prediction, colors),
                         fmt::format("{} surfaces", step.prediction.surfaces.size())),
              column);
  cv::resize(column, column, {}, scale, scale, cv::INTER_AREA);
  cv::copyMakeBorder(column, column, 0, margin_px, margin_px, margin_px, cv::BORDER_CONSTANT,
                     cv::Scalar::all(255));
  return column;
}

}  // namespace

cv::Mat draw_strip(const Frame& frame, const std::vector<StripStep>& steps) {
  std::vector<cv::Mat> columns;
  for (const StripStep& step : steps) columns.push_back(draw_step(frame, step));
  cv::Mat strip;
  cv::hconcat(columns, strip);
  return strip;
}

}  // namespace facet

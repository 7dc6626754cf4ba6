#include "overlay/overlay.hpp"

#include <fmt/format.h>
#include <opencv2/core.hpp>

#include "core/error.hpp"
#include "file/image_file.hpp"
#include "overlay/depth_panel.hpp"
#include "overlay/edge_panel.hpp"
#include "overlay/palette.hpp"
#include "overlay/panel.hpp"
#include "overlay/pose_panel.hpp"
#include "overlay/summary_panel.hpp"
#include "overlay/surface_panel.hpp"

namespace facet {
namespace {

void check_sizes(const Frame& frame, const Prediction& prediction) {
  const Size size = frame.depth_m.size();
  const bool labels_fit = prediction.labels.size() == size;
  const bool edges_fit = prediction.edges.empty() || prediction.edges.size() == size;
  if (size.empty() || !labels_fit || !edges_fit)
    throw Error(ErrorKind::internal, "frame " + frame.id + ": depth, labels and edges differ in size");
}

void check_ids(const Prediction& prediction, const std::map<int, cv::Scalar>& colors) {
  for (const Surface& surface : prediction.surfaces)
    if (!colors.contains(surface.id))
      throw Error(ErrorKind::internal,
                  "surface " + std::to_string(surface.id) + " is not in the label image");
}

cv::Mat titled_color(const Frame& frame) {
  return with_title(draw_color(frame), frame.color.empty() ? "Depth in grey (no colour)" : "Colour");
}

cv::Mat titled_depth(const Frame& frame) {
  const DepthRange range = displayed_range(frame.depth_m);
  const std::string from = fmt::format("{:.2f} m ", range.nearest_m),
                    to = fmt::format(" {:.2f} m", range.farthest_m);
  cv::Mat panel = with_title(draw_depth(frame), "Depth (scale 1/z)", {{"missing", cv::Scalar::all(0)}});
  constexpr int left_px = 195, top_px = 9;
  const cv::Rect strip(left_px + text_width(from), top_px + 1, 150, 14);
  draw_text(panel, from, {left_px, top_px}, cv::Scalar::all(0));
  draw_depth_scale(strip.size()).copyTo(panel(strip));
  draw_text(panel, to, {strip.x + strip.width, top_px}, cv::Scalar::all(0));
  return panel;
}

cv::Mat titled_edges(const Frame& frame, const Prediction& prediction) {
  const auto color = [](EdgeKind kind) {
    return edge_color(static_cast<std::uint8_t>(kind) | graspable_edge_bit);
  };
  return with_title(draw_edges(frame, prediction), "Edges (thick: graspable)",
                    {{"depth", color(EdgeKind::depth)},
                     {"convex", color(EdgeKind::convex)},
                     {"concave", color(EdgeKind::concave)}});
}

cv::Mat titled_surfaces(const Frame& frame, const Prediction& prediction, const std::string& title) {
  return with_title(draw_surfaces(frame, prediction, surface_colors(prediction.labels)), title);
}

}  // namespace

cv::Mat draw_overlay(const Frame& frame, const Prediction& prediction) {
  check_sizes(frame, prediction);
  const auto colors = surface_colors(prediction.labels);
  check_ids(prediction, colors);
  return panel_grid({{titled_color(frame), titled_depth(frame), titled_edges(frame, prediction)},
                     {with_title(draw_surfaces(frame, prediction, colors), "Surfaces"),
                      with_title(draw_poses(frame, prediction, colors), "Contours and poses",
                                 {{"x", axis_colors[0]},
                                  {"y", axis_colors[1]},
                                  {"z", axis_colors[2]},
                                  {"best grasp", grasp_color}}),
                      with_title(draw_summary(frame, prediction), "Summary")}});
}

cv::Mat draw_comparison(const Frame& frame, const Prediction& prediction,
                        const std::optional<Prediction>& truth) {
  check_sizes(frame, prediction);
  const cv::Mat known = truth
                            ? titled_surfaces(frame, *truth, fmt::format("Truth: {}", truth->surfaces.size()))
                            : titled_depth(frame);
  return panel_grid(
      {{titled_color(frame), titled_edges(frame, prediction)},
       {titled_surfaces(frame, prediction, fmt::format("Surfaces: {}", prediction.surfaces.size())), known}});
}

void write_overlays(const Frame& frame, const Prediction& prediction,
                    const std::filesystem::path& directory) {
  write_png_file(directory / (frame.id + ".png"), draw_overlay(frame, prediction), PngEffort::least_time);
}

}  // namespace facet

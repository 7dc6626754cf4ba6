#include "overlay/summary_panel.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <map>
#include <set>

#include "overlay/depth_panel.hpp"

namespace facet {
namespace {

std::array<int, 256> count_codes(const Image<std::uint8_t>& edges) {
  std::array<int, 256> counts{};
  for (int y = 0; y < edges.height(); ++y)
    for (int x = 0; x < edges.width(); ++x) ++counts[edges(x, y)];
  return counts;
}

std::string edge_line(const Image<std::uint8_t>& edges) {
  if (edges.empty()) return "edges: not provided";
  const auto counts = count_codes(edges);
  const auto both = [&](EdgeKind kind) {
    const auto code = static_cast<std::size_t>(kind);
    return counts[code] + counts[code | graspable_edge_bit];
  };
  return fmt::format("edge pixels: {} depth, {} convex, {} concave", both(EdgeKind::depth),
                     both(EdgeKind::convex), both(EdgeKind::concave));
}

std::string surface_line(const std::vector<Surface>& surfaces) {
  const auto count = [&](auto&& has) { return std::count_if(surfaces.begin(), surfaces.end(), has); };
  return fmt::format("{} surfaces: {} with a pose, {} with a grasp, {} curved", surfaces.size(),
                     count([](const Surface& s) { return s.pose.has_value(); }),
                     count([](const Surface& s) { return !s.grasps.empty(); }),
                     count([](const Surface& s) { return s.curved; }));
}

/// Empty where the method does not tell objects apart.
std::string object_line(const std::vector<Surface>& surfaces) {
  std::set<int> objects;
  for (const Surface& surface : surfaces) objects.insert(surface.object);
  objects.erase(0);
  return objects.empty() ? std::string() : fmt::format("{} objects", objects.size());
}

}  // namespace

std::vector<std::string> summary_lines(const Frame& frame, const Prediction& prediction) {
  const Size size = frame.depth_m.size();
  const DepthRange range = displayed_range(frame.depth_m);
  const double missing = 100.0 * static_cast<double>(frame.missing_px) /
                         static_cast<double>(std::max<std::ptrdiff_t>(size.area(), 1));
  std::vector<std::string> lines{
      frame.id, "", fmt::format("{} x {} px, fx {:.1f} px", size.width, size.height, frame.camera.fx),
      fmt::format("depth {:.2f} to {:.2f} m, {:.1f} % missing", range.nearest_m, range.farthest_m, missing),
      surface_line(prediction.surfaces)};
  if (const std::string objects = object_line(prediction.surfaces); !objects.empty())
    lines.push_back(objects);
  lines.push_back(edge_line(prediction.edges));
  lines.push_back(fmt::format("{} regions dropped", prediction.rejected.size()));
  std::map<std::string, int> reasons;
  for (const RejectedRegion& region : prediction.rejected) ++reasons[region.reason];
  for (const auto& [reason, count] : reasons) lines.push_back(fmt::format("    {}: {}", reason, count));
  if (!prediction.note.empty()) lines.push_back(prediction.note);
  return lines;
}

cv::Mat draw_summary(const Frame& frame, const Prediction& prediction) {
  constexpr int margin_px = 16, line_px = 30;
  cv::Mat panel(PanelGeometry(frame.depth_m.size()).panel_size, CV_8UC3, cv::Scalar::all(244));
  int y = margin_px;
  for (const std::string& line : summary_lines(frame, prediction)) {
    draw_text(panel, line, {margin_px, y}, cv::Scalar::all(30));
    y += line_px;
  }
  return panel;
}

}  // namespace facet

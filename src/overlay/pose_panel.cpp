#include "overlay/pose_panel.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

namespace facet {
namespace {

constexpr int subpixel_bits = 4;

cv::Point fixed_point(cv::Point2d p) {
  constexpr double unit = 1 << subpixel_bits;
  constexpr double farthest_px = 1e5;  // a point behind the picture must not overflow the drawing functions
  const auto convert = [&](double v) { return cvRound(std::clamp(v, -farthest_px, farthest_px) * unit); };
  return {convert(p.x), convert(p.y)};
}

void draw_closed(cv::Mat& panel, const Polyline& outline, const PanelGeometry& geometry,
                 const cv::Scalar& color, int thickness_px) {
  std::vector<cv::Point> points;
  for (const ContourPoint& p : outline) points.push_back(fixed_point(geometry.to_panel(p.x, p.y)));
  if (!points.empty()) cv::polylines(panel, points, true, color, thickness_px, cv::LINE_AA, subpixel_bits);
}

/// Pixel of a point in the camera frame, nothing where it lies behind the camera or is not finite.
std::optional<cv::Point2d> project(const Camera& camera, Vec3 p) {
  const cv::Point2d pixel(camera.fx * p.x / p.z + camera.cx, camera.fy * p.y / p.z + camera.cy);
  if (!(p.z > 0) || !std::isfinite(pixel.x) || !std::isfinite(pixel.y)) return std::nullopt;
  return pixel;
}

void draw_line(cv::Mat& panel, cv::Point2d from, cv::Point2d to, const cv::Scalar& color, int thickness_px) {
  cv::line(panel, fixed_point(from), fixed_point(to), color, thickness_px, cv::LINE_AA, subpixel_bits);
}

void draw_pose(cv::Mat& panel, const Surface& surface, const Camera& camera, const PanelGeometry& geometry) {
  const SurfacePose& pose = *surface.pose;
  const auto origin = project(camera, pose.centre_m);
  if (!origin) return;
  const double size_px = std::sqrt(static_cast<double>(surface.area_px)) * geometry.scale;
  const double length_px = std::clamp(0.35 * size_px, 9.0, 48.0) / geometry.scale;
  const int thickness_px = size_px < 40 ? 1 : 2;
  const auto length_m = static_cast<float>(length_px * pose.centre_m.z / camera.fx);
  const std::array<Vec3, 3> axes = pose_axes(pose.quaternion_wxyz);
  const cv::Point2d from = geometry.to_panel(origin->x, origin->y);
  for (const bool halo : {true, false}) {
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const auto end = project(camera, pose.centre_m + length_m * axes[i]);
      if (!end) continue;
      draw_line(panel, from, geometry.to_panel(end->x, end->y), halo ? cv::Scalar::all(255) : axis_colors[i],
                thickness_px + (halo ? 2 : 0));
    }
  }
}

bool is_drawable(ImagePoint p) {
  return std::isfinite(p.x) && std::isfinite(p.y);
}

/// Two dots and a thin line.
void draw_grasp(cv::Mat& panel, const Grasp& grasp, const PanelGeometry& geometry) {
  const auto [a, b] = grasp.contacts_px;
  if (!is_drawable(a) || !is_drawable(b)) return;
  const cv::Point2d from = geometry.to_panel(a.x, a.y), to = geometry.to_panel(b.x, b.y);
  for (const bool halo : {true, false}) {
    const cv::Scalar color = halo ? cv::Scalar::all(255) : grasp_color;
    draw_line(panel, from, to, color, halo ? 3 : 1);
    for (const cv::Point2d& end : {from, to})
      cv::circle(panel, fixed_point(end), (halo ? 4 : 3) << subpixel_bits, color, cv::FILLED, cv::LINE_AA,
                 subpixel_bits);
  }
}

}  // namespace

std::array<Vec3, 3> pose_axes(const std::array<float, 4>& q) {
  const auto [w, x, y, z] = q;
  return {Vec3{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
          Vec3{2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
          Vec3{2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}};
}

cv::Mat draw_poses(const Frame& frame, const Prediction& prediction,
                   const std::map<int, cv::Scalar>& colors) {
  const PanelGeometry geometry(frame.depth_m.size());
  cv::Mat panel = draw_ground(frame, 0.6);
  for (const Surface& surface : prediction.surfaces) {
    draw_closed(panel, surface.contour.outer, geometry, colors.at(surface.id), 2);
    for (const Polyline& hole : surface.contour.holes)
      draw_closed(panel, hole, geometry, colors.at(surface.id), 1);
  }
  for (const Surface& surface : prediction.surfaces)
    if (!surface.grasps.empty()) draw_grasp(panel, surface.grasps.front(), geometry);
  for (const Surface& surface : prediction.surfaces)
    if (surface.pose) draw_pose(panel, surface, frame.camera, geometry);
  return panel;
}

}  // namespace facet

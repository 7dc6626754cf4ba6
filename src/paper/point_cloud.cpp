#include "paper/point_cloud.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "overlay/palette.hpp"
#include "overlay/pose_panel.hpp"

namespace facet {
namespace {

std::array<std::uint8_t, 3> rgb_of(const cv::Scalar& bgr) {
  return {cv::saturate_cast<std::uint8_t>(bgr[2]), cv::saturate_cast<std::uint8_t>(bgr[1]),
          cv::saturate_cast<std::uint8_t>(bgr[0])};
}

void add_axes(PoseCloud& cloud, const SurfacePose& pose, float length_m) {
  const std::array<Vec3, 3> axes = pose_axes(pose.quaternion_wxyz);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const int first = static_cast<int>(cloud.points.size());
    cloud.points.push_back({pose.centre_m, rgb_of(axis_colors[i])});
    cloud.points.push_back({pose.centre_m + length_m * axes[i], rgb_of(axis_colors[i])});
    cloud.axes.push_back({first, first + 1});
  }
}

/// The view of draw_cloud(): camera coordinates turned about the middle of the cloud.
struct CloudView {
  Vec3 middle;
  float cos_yaw, sin_yaw, cos_pitch, sin_pitch, focal_px;
  cv::Size size;

  Vec3 turned(Vec3 p) const {
    const Vec3 d = p - middle;
    const Vec3 y{cos_yaw * d.x + sin_yaw * d.z, d.y, -sin_yaw * d.x + cos_yaw * d.z};
    return Vec3{y.x, cos_pitch * y.y - sin_pitch * y.z, sin_pitch * y.y + cos_pitch * y.z} +
           Vec3{0, 0, middle.z};
  }
  cv::Point pixel(Vec3 t) const {
    return {cvRound(size.width / 2.0 + focal_px * t.x / t.z),
            cvRound(size.height / 2.0 + focal_px * t.y / t.z)};
  }
};

Vec3 middle_of(const PoseCloud& cloud) {
  std::vector<float> z;
  for (const ColoredPoint& p : cloud.points) z.push_back(p.p_m.z);
  if (z.empty()) return {0, 0, 1};
  std::nth_element(z.begin(), z.begin() + static_cast<std::ptrdiff_t>(z.size() / 2), z.end());
  return {0, 0, z[z.size() / 2]};
}

}  // namespace

PoseCloud pose_cloud(const Frame& frame, const Prediction& prediction, float axis_length_m) {
  PoseCloud cloud;
  const auto colors = surface_colors(prediction.labels);
  for (int y = 0; y < frame.depth_m.height(); ++y)
    for (int x = 0; x < frame.depth_m.width(); ++x) {
      if (!(frame.depth_m(x, y) > 0)) continue;
      const int label = prediction.labels(x, y);
      cloud.points.push_back(
          {frame.camera.back_project(static_cast<float>(x), static_cast<float>(y), frame.depth_m(x, y)),
           label == 0 ? std::array<std::uint8_t, 3>{128, 128, 128} : rgb_of(colors.at(label))});
    }
  for (const Surface& surface : prediction.surfaces)
    if (surface.pose) add_axes(cloud, *surface.pose, axis_length_m);
  return cloud;
}

std::string to_ply(const PoseCloud& cloud) {
  std::string text = fmt::format(
      "ply\nformat ascii 1.0\ncomment metres, camera frame: x right, y down, z forward\nelement vertex {}\n"
      "property float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar green\n"
      "property uchar blue\nelement edge {}\nproperty int vertex1\nproperty int vertex2\nend_header\n",
      cloud.points.size(), cloud.axes.size());
  for (const ColoredPoint& p : cloud.points)
    text += fmt::format("{:.4f} {:.4f} {:.4f} {} {} {}\n", p.p_m.x, p.p_m.y, p.p_m.z, p.rgb[0], p.rgb[1],
                        p.rgb[2]);
  for (const auto& [from, to] : cloud.axes) text += fmt::format("{} {}\n", from, to);
  return text;
}

cv::Mat draw_cloud(const PoseCloud& cloud, cv::Size size, double yaw_deg, double pitch_deg) {
  const auto yaw = static_cast<float>(yaw_deg * M_PI / 180),
             pitch = static_cast<float>(pitch_deg * M_PI / 180);
  const CloudView view{middle_of(cloud),
                       std::cos(yaw),
                       std::sin(yaw),
                       std::cos(pitch),
                       std::sin(pitch),
                       1.05f * static_cast<float>(size.width),
                       size};
  cv::Mat picture(size, CV_8UC3, cv::Scalar::all(24)), nearest(size, CV_32F, cv::Scalar(1e9));
  const cv::Rect inside(0, 0, size.width - 1, size.height - 1);
  for (const ColoredPoint& p : cloud.points) {
    const Vec3 t = view.turned(p.p_m);
    if (t.z < 0.05f) continue;
    const cv::Point at = view.pixel(t);
    if (!inside.contains(at)) continue;
    for (const cv::Point q : {at, at + cv::Point(1, 0), at + cv::Point(0, 1), at + cv::Point(1, 1)}) {
      if (t.z >= nearest.at<float>(q)) continue;
      nearest.at<float>(q) = t.z;
      picture.at<cv::Vec3b>(q) = {p.rgb[2], p.rgb[1], p.rgb[0]};
    }
  }
  for (const bool halo : {true, false})
    for (const auto& [from, to] : cloud.axes) {
      const ColoredPoint &a = cloud.points[static_cast<std::size_t>(from)],
                         &b = cloud.points[static_cast<std::size_t>(to)];
      const cv::Scalar color = halo ? cv::Scalar::all(255) : cv::Scalar(b.rgb[2], b.rgb[1], b.rgb[0]);
      cv::line(picture, view.pixel(view.turned(a.p_m)), view.pixel(view.turned(b.p_m)), color, halo ? 5 : 3,
               cv::LINE_AA);
    }
  return picture;
}

}  // namespace facet

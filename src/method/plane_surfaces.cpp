#include "method/plane_surfaces.hpp"

#include <cmath>

#include "surface/regions.hpp"
#include "surface/surface_list.hpp"

namespace facet {
namespace {

/// Drops the planes that no pixel has.
void renumber(std::vector<Plane>& planes, Image<std::uint16_t>& labels) {
  std::vector<std::uint16_t> label(planes.size() + 1, 0);
  const auto for_each_label = [&](const auto& visit) {
    for (int y = 0; y < labels.height(); ++y)
      for (int x = 0; x < labels.width(); ++x) visit(labels(x, y));
  };
  for_each_label([&](std::uint16_t k) { label[k] = 1; });
  label[0] = 0;
  std::uint16_t count = 0;
  for (std::size_t k = 1; k < label.size(); ++k) {
    if (label[k] == 0) continue;
    planes[count] = planes[k - 1];
    label[k] = ++count;
  }
  planes.resize(count);
  for_each_label([&](std::uint16_t& k) { k = label[k]; });
}

void describe(const PointSample& points, const Camera& camera, const DepthNoise& noise, Plane plane,
              Surface& surface) {
  Vec3 mean;
  for (std::size_t i = 0; i < points.size(); ++i) mean = mean + points.at(i);
  mean = (1 / static_cast<float>(points.size())) * mean;
  if (dot(plane.normal, mean) > 0) plane = reversed(plane);
  const float threshold_m = plane_threshold_m(points, {}, noise);
  double squares = 0;
  int inliers = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float distance_m = plane.signed_distance_m(points.at(i));
    if (std::fabs(distance_m) > threshold_m) continue;
    ++inliers;
    squares += static_cast<double>(distance_m) * static_cast<double>(distance_m);
  }
  surface.plane = plane;
  surface.inlier_share = static_cast<float>(inliers) / static_cast<float>(points.size());
  surface.rms_m = inliers > 0 ? static_cast<float>(std::sqrt(squares / inliers)) : 0;
  surface.pose = pose_on_plane(plane, mean - plane.signed_distance_m(mean) * plane.normal);
  surface.pose->rect_axis = rectangle_axis(surface.contour.outer, plane, camera);
}

}  // namespace

void describe_planes(const Frame& frame, const DepthNoise& noise, std::vector<Plane> planes,
                     Prediction& prediction) {
  constexpr int most_points = 4096;  // as a sample of each plane
  renumber(planes, prediction.labels);
  const Size size = frame.depth_m.size();
  const Image<std::uint8_t> none(size, 0);
  RegionPixels pixels;
  pixels.collect(std::as_const(prediction.labels).view(), static_cast<int>(planes.size()),
                 frame.depth_m.view(), none.view(), frame.camera, most_points);
  prediction.surfaces.assign(planes.size(), {});
  for (std::size_t i = 0; i < planes.size(); ++i) prediction.surfaces[i].id = static_cast<int>(i) + 1;
  trace_regions(std::as_const(prediction.labels).view(), pixels.boxes, prediction.surfaces);
  const Image<std::uint8_t>& edges = prediction.edges.empty() ? none : prediction.edges;
  describe_surfaces(pixels, size, edges.view(), prediction.surfaces);
  for (std::size_t i = 0; i < planes.size(); ++i)
    if (pixels.points[i].size() > 0)
      describe(pixels.points[i], frame.camera, noise, planes[i], prediction.surfaces[i]);
    else
      prediction.surfaces[i].no_pose_reason = "no pixel with depth";
}

}  // namespace facet

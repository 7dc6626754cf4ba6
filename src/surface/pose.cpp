#include "surface/pose.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/angle.hpp"
#include "surface/outline_hull.hpp"

namespace facet {
namespace {

/// Point where the ray through a pixel meets the plane.
Vec3 on_plane(const Plane& plane, const Camera& camera, float x_px, float y_px) {
  const Vec3 ray = camera.back_project(x_px, y_px, 1);
  const float along = dot(plane.normal, ray);
  return std::fabs(along) > 1e-6f ? (-plane.d_m / along) * ray : Vec3{};
}

Vec3 project(const Plane& plane, Vec3 p) {
  return p - plane.signed_distance_m(p) * plane.normal;
}

bool lies_on_label(const PoseInput& input, Vec3 p, int label) {
  if (!(p.z > 0)) return false;
  const int x = static_cast<int>(std::lround(p.x / p.z * input.camera.fx + input.camera.cx));
  const int y = static_cast<int>(std::lround(p.y / p.z * input.camera.fy + input.camera.cy));
  return input.labels.size().contains(x, y) && input.labels(x, y) == label;
}

/// Mean of the inliers; where that is not on the surface (rings, L shapes), the inlier nearest to it.
Vec3 inlier_centre(const PoseInput& input, const PointSample& points, const PlaneFit& fit, float threshold_m,
                   int label) {
  const Vec3 mean = project(*fit.plane, fit.centroid_m);
  if (lies_on_label(input, mean, label)) return mean;
  Vec3 nearest = mean;
  float least = std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 p = points.at(i);
    const float distance = dot(p - mean, p - mean);
    if (distance >= least || std::fabs(fit.plane->signed_distance_m(p)) >= threshold_m) continue;
    least = distance;
    nearest = p;
  }
  return project(*fit.plane, nearest);
}

/// The paper's centre: mean of the contour's pixels, lifted by the depth that happens to be there.
std::optional<Vec3> contour_centre(const PoseInput& input, const Polyline& outer) {
  double x = 0, y = 0;
  for (const ContourPoint& p : outer) x += p.x, y += p.y;
  const auto n = static_cast<double>(outer.size());
  const auto cx = static_cast<float>(x / n), cy = static_cast<float>(y / n);
  const float depth_m = input.depth_m(static_cast<int>(std::lround(cx)), static_cast<int>(std::lround(cy)));
  if (!(depth_m > 0)) return std::nullopt;
  return input.camera.back_project(cx, cy, depth_m);
}

/// Median of the depths of up to 128 of the points: it only has to tell the noise.
float typical_depth(const PointSample& points) {
  constexpr std::size_t most = 128;
  std::array<float, most> z{};
  const std::size_t stride = (points.size() + most - 1) / most;
  std::size_t n = 0;
  for (std::size_t i = 0; i < points.size(); i += stride) z[n++] = points.z[i];
  const auto middle = z.begin() + static_cast<std::ptrdiff_t>(n / 2);
  std::nth_element(z.begin(), middle, z.begin() + static_cast<std::ptrdiff_t>(n));
  return *middle;
}

}  // namespace

float plane_threshold_m(const PointSample& points, const PoseParams& params, const DepthNoise& noise) {
  const float sigma_m = points.size() > 0 ? noise.sigma_m(typical_depth(points)) : 0;
  return std::max(params.inlier_sigmas * sigma_m, params.min_inlier_mm / 1000);
}

SurfacePose pose_on_plane(const Plane& plane, Vec3 centre_m) {
  const Vec3 z = plane.normal;
  const Vec3 camera_up{0, -1, 0};
  const Vec3 up = std::fabs(dot(z, camera_up)) > 0.95f ? Vec3{1, 0, 0} : camera_up;
  const Vec3 x = normalized(cross(up, z));
  const Vec3 y = cross(z, x);
  Eigen::Matrix3f rotation;
  rotation << x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z;
  Eigen::Quaternionf q(rotation);
  q.normalize();
  if (q.w() < 0) q.coeffs() = -q.coeffs();

  SurfacePose pose;
  pose.centre_m = centre_m;
  pose.quaternion_wxyz = {q.w(), q.x(), q.y(), q.z()};
  const float pitch = std::asin(std::clamp(-rotation(2, 0), -1.0f, 1.0f));
  pose.zyx_deg = {degrees_per_radian * std::atan2(rotation(1, 0), rotation(0, 0)), degrees_per_radian * pitch,
                  degrees_per_radian * std::atan2(rotation(2, 1), rotation(2, 2))};
  return pose;
}

Vec3 rectangle_axis(const Polyline& outer, const Plane& plane, const Camera& camera) {
  std::vector<cv::Point> points;
  for (const ContourPoint& p : convex_corners(outer)) points.emplace_back(p.x, p.y);
  cv::Point2f corner[4];
  cv::minAreaRect(points).points(corner);
  const Vec3 a = on_plane(plane, camera, corner[0].x, corner[0].y);
  const Vec3 b = on_plane(plane, camera, corner[1].x, corner[1].y);
  const Vec3 c = on_plane(plane, camera, corner[2].x, corner[2].y);
  const Vec3 axis = norm(b - a) >= norm(c - b) ? b - a : c - b;
  return normalized(project(plane, a + axis) - project(plane, a));
}

void estimate_pose(const PoseInput& input, const PoseParams& params, const PointSample& points,
                   Surface& surface) {
  const float threshold_m = plane_threshold_m(points, params, input.noise);
  const PlaneFit fit =
      fit_plane(points, params, threshold_m, input.seed, static_cast<std::uint64_t>(surface.id));
  surface.no_pose_reason = std::string(fit.reason);
  if (!fit.plane) return;
  surface.plane = fit.plane;
  surface.inlier_share = fit.inlier_share;
  surface.rms_m = fit.rms_m;
  surface.curved = fit.inlier_share < params.curved_below_share;

  std::optional<Vec3> centre;
  if (params.centre == PoseCentre::inliers)
    centre = inlier_centre(input, points, fit, threshold_m, surface.id);
  else
    centre = contour_centre(input, surface.contour.outer);
  surface.no_pose_reason = centre ? "" : "no depth at the contour's centre";
  if (!centre) return;
  surface.pose = pose_on_plane(*fit.plane, *centre);
  surface.pose->rect_axis = rectangle_axis(surface.contour.outer, *fit.plane, input.camera);
}

}  // namespace facet

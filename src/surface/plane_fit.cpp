#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/clones.hpp"
#include "core/random.hpp"
#include "surface/pose.hpp"

namespace facet {
namespace {

constexpr float min_triangle_area_m2 = 1e-5f;  ///< thinner triples give no direction
constexpr float confidence = 0.99f;            ///< that no better hypothesis was left out

std::optional<Plane> plane_through(Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 n = cross(b - a, c - a);
  const float twice_area = norm(n);
  if (twice_area < 2 * min_triangle_area_m2) return std::nullopt;
  const Vec3 unit = (1 / twice_area) * n;
  return Plane{unit, -dot(unit, a)};
}

FACET_CPU_CLONES int count_inliers(const PointSample& points, const Plane& plane, float threshold_m) {
  const std::size_t n = points.size();
  const float *x = points.x.data(), *y = points.y.data(), *z = points.z.data();
  const float nx = plane.normal.x, ny = plane.normal.y, nz = plane.normal.z, d = plane.d_m;
  int count = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const float distance = nx * x[i] + ny * y[i] + nz * z[i] + d;
    count += std::fabs(distance) < threshold_m ? 1 : 0;
  }
  return count;
}

/// Hypotheses needed to have drawn three inliers once with the given confidence.
int hypotheses_needed(double inlier_share, int most) {
  const double all_inliers = inlier_share * inlier_share * inlier_share;
  if (all_inliers > 0.999999) return 1;
  if (all_inliers < 1e-6) return most;
  return std::clamp(static_cast<int>(std::ceil(std::log(1 - confidence) / std::log(1 - all_inliers))), 1,
                    most);
}

std::optional<Plane> best_hypothesis(const PointSample& points, const PoseParams& params, float threshold_m,
                                     std::uint64_t seed, std::uint64_t stream) {
  const auto n = static_cast<std::uint32_t>(points.size());
  std::optional<Plane> best;
  int best_count = 0;
  int needed = params.iterations;
  for (int k = 0; k < needed; ++k) {
    const auto draw = [&](std::uint64_t i) {
      return points.at(random_below(n, seed, stream, 3 * static_cast<std::uint64_t>(k) + i));
    };
    const std::optional<Plane> plane = plane_through(draw(0), draw(1), draw(2));
    if (!plane) continue;
    const int count = count_inliers(points, *plane, threshold_m);
    if (count <= best_count) continue;
    best = plane;
    best_count = count;
    needed = std::min(needed, k + 1 + hypotheses_needed(static_cast<double>(count) / n, params.iterations));
  }
  return best;
}

/// Sums over the points near a plane, of their coordinates about `origin` and of the products of these. Four
/// of each side by side, so that the order of additions does not depend on the width of the registers.
struct Moments {
  double n = 0, x = 0, y = 0, z = 0, xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
};
FACET_CPU_CLONES Moments moments_near(const PointSample& points, const Plane& plane, float threshold_m,
                                      Vec3 origin) {
  constexpr std::size_t lanes = 4;
  double sums[10][lanes] = {};
  const auto add = [&](std::size_t i, std::size_t lane) {
    const Vec3 p = points.at(i);
    const double w = std::fabs(plane.signed_distance_m(p)) < threshold_m ? 1 : 0;
    const double x = w * double{p.x - origin.x}, y = w * double{p.y - origin.y},
                 z = w * double{p.z - origin.z};
    const double terms[10] = {w, x, y, z, x * x, x * y, x * z, y * y, y * z, z * z};
    for (std::size_t k = 0; k < 10; ++k) sums[k][lane] += terms[k];
  };
  std::size_t i = 0;
  for (; i + lanes <= points.size(); i += lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane) add(i + lane, lane);
  for (; i < points.size(); ++i) add(i, 0);
  double total[10];
  for (std::size_t k = 0; k < 10; ++k) total[k] = (sums[k][0] + sums[k][1]) + (sums[k][2] + sums[k][3]);
  return {total[0], total[1], total[2], total[3], total[4], total[5], total[6], total[7], total[8], total[9]};
}

/// Least-squares plane through the points within the threshold of `plane` (smallest principal axis).
PlaneFit refine(const PointSample& points, const Plane& plane, float threshold_m) {
  const Moments m = moments_near(points, plane, threshold_m, points.at(0));
  if (m.n < 3) return {};
  const Eigen::Vector3d mean = Eigen::Vector3d(m.x, m.y, m.z) / m.n;
  Eigen::Matrix3d squares;
  squares << m.xx, m.xy, m.xz, m.xy, m.yy, m.yz, m.xz, m.yz, m.zz;
  const Eigen::Matrix3d covariance = squares / m.n - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
  axes.computeDirect(covariance);
  const Eigen::Vector3d centre = mean + Eigen::Vector3d(points.x[0], points.y[0], points.z[0]);
  Eigen::Vector3d normal = axes.eigenvectors().col(0);
  if (normal.dot(centre) > 0) normal = -normal;  // towards the camera

  PlaneFit fit;
  fit.plane =
      Plane{{static_cast<float>(normal.x()), static_cast<float>(normal.y()), static_cast<float>(normal.z())},
            static_cast<float>(-normal.dot(centre))};
  fit.inlier_share = static_cast<float>(m.n) / static_cast<float>(points.size());
  fit.rms_m = static_cast<float>(std::sqrt(std::max(0.0, axes.eigenvalues()(0))));
  fit.centroid_m = {static_cast<float>(centre.x()), static_cast<float>(centre.y()),
                    static_cast<float>(centre.z())};
  return fit;
}

}  // namespace

bool lies_in_front(const PointSample& points, const Plane& plane) {
  std::size_t in_front = 0;
  for (std::size_t i = 0; i < points.size(); ++i) in_front += plane.signed_distance_m(points.at(i)) > 0;
  return 2 * in_front > points.size();
}

PlaneFit fit_plane(const PointSample& points, const PoseParams& params, float threshold_m, std::uint64_t seed,
                   std::uint64_t stream) {
  PlaneFit fit;
  fit.reason = "fewer than 3 measured points";
  if (points.size() < 3) return fit;
  const std::optional<Plane> hypothesis = best_hypothesis(points, params, threshold_m, seed, stream);
  fit.reason = "no three points span a plane";
  if (!hypothesis) return fit;
  PlaneFit refined = refine(points, *hypothesis, threshold_m);
  if (!refined.plane) return fit;
  // A second round takes in the points that only the refined plane explains.
  PlaneFit settled = refine(points, *refined.plane, threshold_m);
  return settled.plane ? settled : refined;
}

}  // namespace facet

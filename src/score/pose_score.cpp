#include "score/pose_score.hpp"

#include <algorithm>
#include <cmath>

#include "score/grasp_score.hpp"

namespace facet {
namespace {

constexpr double degrees_of_radian = 57.29577951308232;
constexpr double curve_end = 10;  // degrees and millimetres

/// Direction of the surface's z axis in the camera frame.
Vec3 z_axis(const SurfacePose& pose) {
  const auto [w, x, y, z] = pose.quaternion_wxyz;
  return {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)};
}

/// Angle between two unit vectors [deg], exact for small angles too.
double angle_deg(Vec3 a, Vec3 b) {
  return std::atan2(norm(cross(a, b)), dot(a, b)) * degrees_of_radian;
}

double rotation_deg(const std::array<float, 4>& p, const std::array<float, 4>& q) {
  double same = 0, opposite = 0;  // |p - q| and |p + q|: exact for small angles too
  for (std::size_t i = 0; i < 4; ++i) {
    same += std::pow(static_cast<double>(p[i]) - q[i], 2);
    opposite += std::pow(static_cast<double>(p[i]) + q[i], 2);
  }
  return 4 * std::atan2(std::sqrt(std::min(same, opposite)), std::sqrt(std::max(same, opposite))) *
         degrees_of_radian;
}

/// The valid pose of the largest surface matched with each truth surface.
std::vector<const SurfacePose*> matched_poses(const FrameTruth& frame, const RegionComparison& comparison,
                                              const Prediction& prediction) {
  std::vector<const SurfacePose*> poses(frame.scored_surfaces.size(), nullptr);
  for (const RegionMatch& match : comparison.matches) {
    const auto& region = comparison.predicted.regions[static_cast<std::size_t>(match.region)];
    for (const Surface* surface : surfaces_of(region, prediction)) {
      const SurfacePose*& pose = poses[static_cast<std::size_t>(match.truth)];
      if (pose == nullptr && surface->pose && is_valid_pose(*surface->pose)) pose = &*surface->pose;
    }
  }
  return poses;
}

}  // namespace

PoseError pose_error(const TruePose& truth, const SurfacePose& estimate) {
  const Vec3 off = estimate.centre_m - truth.centroid_m;
  const float along = dot(truth.plane->normal, off);
  return {.surface = truth.surface,
          .normal_deg = angle_deg(truth.plane->normal, z_axis(estimate)),
          .offset_m = std::abs(along),
          .lateral_m = norm(off - along * truth.plane->normal),
          .rotation_deg = rotation_deg(pose_of(truth).quaternion_wxyz, estimate.quaternion_wxyz)};
}

PoseScore score_poses(const FrameTruth& frame, const RegionComparison& comparison,
                      const Prediction& prediction) {
  PoseScore score;
  const std::vector<const SurfacePose*> poses = matched_poses(frame, comparison, prediction);
  for (std::size_t s = 0; s < frame.scored_surfaces.size(); ++s) {
    const auto truth = std::find_if(frame.poses.begin(), frame.poses.end(), [&](const TruePose& p) {
      return p.surface == frame.scored_surfaces[s].number;
    });
    if (truth == frame.poses.end()) continue;
    const double centre_m = poses[s] != nullptr ? norm(poses[s]->centre_m - truth->centroid_m) : 0;
    if (!truth->plane) {
      if (poses[s] != nullptr) score.curved_centre_m.push_back(centre_m);
      continue;
    }
    double worst = curve_end + 1;  // the larger of degrees and millimetres
    if (poses[s] != nullptr) {
      score.errors.push_back(pose_error(*truth, *poses[s]));
      worst = std::max(score.errors.back().rotation_deg, 1000 * centre_m);
    }
    score.success_5.add(worst <= 5);
    score.success_10.add(worst <= 10);
    score.auc_total += std::max(0.0, 1 - worst / curve_end);
  }
  return score;
}

}  // namespace facet

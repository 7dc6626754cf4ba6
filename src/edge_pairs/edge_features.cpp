#include "edge_pairs/edge_features.hpp"

#include <algorithm>
#include <cmath>

#include "edge_pairs/edge_map.hpp"
#include "surface/pose.hpp"

namespace facet {
namespace {

constexpr float degrees_per_radian = 57.29578f;
constexpr std::size_t least_points = 10;
/// A segment is reachable where at least half of it is.
constexpr double least_free_share = 0.5;

class Describer {
 public:
  Describer(const EdgePairParams& params, const EdgeScene& scene) : params_(params), scene_(scene) {}

  std::optional<EdgeFeature> describe(const Segment& segment) {
    EdgeFeature feature{segment, EdgeKind::none, side_of(segment, 1), side_of(segment, -1)};
    const EdgeSide &left = feature.left, &right = feature.right;
    if (left.depth_m <= 0 && right.depth_m <= 0) return std::nullopt;
    const float jump_m = left.depth_m > 0 && right.depth_m > 0 ? right.depth_m - left.depth_m : 0;
    if (std::fabs(jump_m) > least_jump_m(params_, scene_.noise, std::min(left.depth_m, right.depth_m))) {
      feature.kind = EdgeKind::depth;
      feature.left_reachable = jump_m > 0 && is_reachable(segment, 1, left.depth_m);
      feature.right_reachable = jump_m < 0 && is_reachable(segment, -1, right.depth_m);
      return feature;
    }
    if (!left.plane || !right.plane) return std::nullopt;
    const Vec3 turn = right.plane->normal - left.plane->normal;
    const float cosine = std::clamp(dot(left.plane->normal, right.plane->normal), -1.0f, 1.0f);
    if (degrees_per_radian * std::acos(cosine) < params_.convex_deg) return std::nullopt;
    const bool convex = dot(right.centre_m - left.centre_m, turn) > 0;
    feature.kind = convex ? EdgeKind::convex : EdgeKind::concave;
    feature.left_reachable = convex && is_reachable(segment, 1, left.depth_m);
    feature.right_reachable = convex && is_reachable(segment, -1, right.depth_m);
    return feature;
  }

 private:
  /// Visits the depths beside the segment, on the side `sign` of it, `near` to `far` pixels away.
  template <class Visit>
  void walk_beside(const Segment& segment, int sign, double near, double far, const Visit& visit) const {
    const Vec2 along = normalized(segment.to - segment.from);
    const Vec2 across = static_cast<double>(sign) * left_of(along);
    const int length = static_cast<int>(norm(segment.to - segment.from));
    for (int i = 0; i <= length; ++i)
      for (double k = near; k <= far; ++k) {
        const Vec2 p = segment.from + static_cast<double>(i) * along + k * across;
        const int x = static_cast<int>(std::lround(p.x)), y = static_cast<int>(std::lround(p.y));
        if (scene_.depth_m.size().contains(x, y)) visit(i, x, y, scene_.depth_m(x, y));
      }
  }

  EdgeSide side_of(const Segment& segment, int sign) {
    PointSample points;
    walk_beside(segment, sign, params_.side_near_px, params_.side_far_px, [&](int, int x, int y, float z) {
      if (z > 0) points.add(scene_.camera.back_project(static_cast<float>(x), static_cast<float>(y), z));
    });
    EdgeSide side;
    if (points.size() < least_points) return side;
    std::vector<float> depths = points.z;
    const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
    std::nth_element(depths.begin(), middle, depths.end());
    side.depth_m = *middle;
    const PlaneFit fit = fit_plane(points, {}, plane_threshold_m(points, {}, scene_.noise), 0, 0);
    side.plane = fit.plane;
    side.centre_m = fit.centroid_m;
    return side;
  }

  /// Beyond the edge, seen from the surface on the side `sign` of it.
  bool is_reachable(const Segment& segment, int sign, float depth_m) const {
    const double finger_px = static_cast<double>(params_.finger_width_mm / 1000 * scene_.camera.fx / depth_m);
    const float nearest_m = depth_m - least_jump_m(params_, scene_.noise, depth_m);
    std::vector<bool> blocked(static_cast<std::size_t>(norm(segment.to - segment.from)) + 1, false);
    walk_beside(segment, -sign, params_.side_near_px, finger_px, [&](int i, int, int, float z) {
      if (z > 0 && z < nearest_m) blocked[static_cast<std::size_t>(i)] = true;
    });
    const auto free = static_cast<double>(std::count(blocked.begin(), blocked.end(), false));
    return free >= least_free_share * static_cast<double>(blocked.size());
  }

  const EdgePairParams& params_;
  const EdgeScene& scene_;
};

}  // namespace

std::vector<EdgeFeature> describe_segments(const EdgePairParams& params, const EdgeScene& scene,
                                           const std::vector<Segment>& segments) {
  Describer describer(params, scene);
  std::vector<EdgeFeature> features;
  for (const Segment& segment : segments)
    if (auto feature = describer.describe(segment)) features.push_back(std::move(*feature));
  return features;
}

}  // namespace facet

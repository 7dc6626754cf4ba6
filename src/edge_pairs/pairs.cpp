#include "edge_pairs/pairs.hpp"

#include <algorithm>
#include <cmath>

#include "surface/plane_frame.hpp"
#include "surface/pose.hpp"

namespace facet {
namespace {

/// One side of an edge that a finger could press on.
struct Contact {
  Vec2 from, to, inward;
  const EdgeSide* surface;  ///< that is pressed
};

std::vector<Contact> contacts_of(const std::vector<EdgeFeature>& edges) {
  std::vector<Contact> contacts;
  for (const EdgeFeature& e : edges) {
    const Vec2 left = left_of(normalized(e.segment.to - e.segment.from));
    if (e.left_reachable) contacts.push_back({e.segment.from, e.segment.to, left, &e.left});
    if (e.right_reachable) contacts.push_back({e.segment.from, e.segment.to, -1.0 * left, &e.right});
  }
  return contacts;
}

Vec2 at_height(const Contact& c, Vec2 axis, double height) {
  const double from = dot(c.from, axis), to = dot(c.to, axis);
  return c.from + ((height - from) / (to - from)) * (c.to - c.from);
}

class PairFinder {
 public:
  PairFinder(const EdgePairParams& params, const EdgeScene& scene)
      : params_(params),
        scene_(scene),
        cone_(std::cos(std::atan(static_cast<double>(params.friction)))),
        double_cone_(std::cos(2 * std::atan(static_cast<double>(params.friction)))) {}

  std::optional<FreeGrasp> grasp(const Contact& a, const Contact& b) const {
    const double opposing = -dot(a.inward, b.inward);
    if (opposing < double_cone_) return std::nullopt;  // (a)
    const Vec2 closing = normalized(a.inward - b.inward), axis = left_of(closing);
    const auto [low_a, high_a] = std::minmax({dot(a.from, axis), dot(a.to, axis)});
    const auto [low_b, high_b] = std::minmax({dot(b.from, axis), dot(b.to, axis)});
    const double low = std::max(low_a, low_b), high = std::min(high_a, high_b);
    if (high - low < finger_px(a)) return std::nullopt;  // (b)
    const Vec2 p = at_height(a, axis, 0.5 * (low + high)), q = at_height(b, axis, 0.5 * (low + high));
    const Vec2 v = normalized(q - p);
    if (dot(v, a.inward) < cone_ || -dot(v, b.inward) < cone_) return std::nullopt;  // (c) and (d)
    const auto p_m = in_space(a, p), q_m = in_space(b, q);
    if (!p_m || !q_m) return std::nullopt;
    const float width_m = norm(*q_m - *p_m);
    if (!(width_m > 0) || 1000 * width_m > params_.max_opening_mm) return std::nullopt;  // (e)
    if (crosses_depth_edge(p, q)) return std::nullopt;                                   // (f)
    FreeGrasp free;
    free.grasp = {{*p_m, *q_m},
                  {ImagePoint{p.x, p.y}, ImagePoint{q.x, q.y}},
                  normalized(*q_m - *p_m),
                  width_m,
                  static_cast<float>((high - low) * opposing)};
    const auto approach = approach_axis(a, b, axis, low, high, free.grasp.closing_axis);
    if (!approach) return std::nullopt;
    free.approach_axis = *approach;
    return free;
  }

 private:
  double finger_px(const Contact& c) const {
    return static_cast<double>(params_.finger_width_mm / 1000 * scene_.camera.fx / c.surface->depth_m);
  }

  /// Where the ray through a pixel meets the surface beside the edge.
  std::optional<Vec3> in_space(const Contact& c, Vec2 px) const {
    const Vec3 ray = scene_.camera.back_project(static_cast<float>(px.x), static_cast<float>(px.y), 1);
    if (!c.surface->plane) return c.surface->depth_m * ray;
    const float along = dot(c.surface->plane->normal, ray);
    constexpr float grazing = -0.05f;
    if (along > grazing * norm(ray)) return c.surface->depth_m * ray;
    return (-c.surface->plane->d_m / along) * ray;
  }

  /// Whether a step in depth lies between the contacts; beside them are those that the edges are.
  bool crosses_depth_edge(Vec2 p, Vec2 q) const {
    const double length = norm(q - p);
    const double margin = params_.side_near_px;
    const Vec2 step = normalized(q - p);
    for (double s = margin; s <= length - margin; s += 0.5) {
      const Vec2 at = p + s * step;
      const int x = static_cast<int>(std::lround(at.x)), y = static_cast<int>(std::lround(at.y));
      if (scene_.depth_edges.size().contains(x, y) && scene_.depth_edges(x, y) != 0) return true;
    }
    return false;
  }

  /// Away from the camera along the normal of the plane through what lies between the edges, at a right
  /// angle to the closing axis.
  std::optional<Vec3> approach_axis(const Contact& a, const Contact& b, Vec2 axis, double low, double high,
                                    Vec3 closing_axis) const {
    constexpr int samples = 16;  // along either direction
    PointSample points;
    for (int i = 0; i <= samples; ++i)
      for (int k = 1; k < samples; ++k) {
        const double height = low + (high - low) * i / samples;
        const Vec2 p = at_height(a, axis, height), q = at_height(b, axis, height);
        const Vec2 at = p + (static_cast<double>(k) / samples) * (q - p);
        const int x = static_cast<int>(std::lround(at.x)), y = static_cast<int>(std::lround(at.y));
        if (!scene_.depth_m.size().contains(x, y) || !(scene_.depth_m(x, y) > 0)) continue;
        points.add(
            scene_.camera.back_project(static_cast<float>(x), static_cast<float>(y), scene_.depth_m(x, y)));
      }
    const PlaneFit fit = fit_plane(points, {}, plane_threshold_m(points, {}, scene_.noise), 0, 0);
    if (!fit.plane) return std::nullopt;
    const Vec3 inwards = -fit.plane->normal;
    const Vec3 approach = normalized(inwards - dot(inwards, closing_axis) * closing_axis);
    return norm(approach) > 0 ? std::optional(approach) : std::nullopt;
  }

  const EdgePairParams& params_;
  const EdgeScene& scene_;
  double cone_, double_cone_;
};

}  // namespace

std::vector<FreeGrasp> find_pairs(const EdgePairParams& params, const EdgeScene& scene,
                                  const std::vector<EdgeFeature>& edges) {
  const std::vector<Contact> contacts = contacts_of(edges);
  const PairFinder finder(params, scene);
  std::vector<FreeGrasp> grasps;
  for (std::size_t i = 0; i < contacts.size(); ++i)
    for (std::size_t j = i + 1; j < contacts.size(); ++j)
      if (const auto found = finder.grasp(contacts[i], contacts[j])) grasps.push_back(*found);
  std::stable_sort(grasps.begin(), grasps.end(),
                   [](const FreeGrasp& a, const FreeGrasp& b) { return a.grasp.score > b.grasp.score; });
  return grasps;
}

}  // namespace facet

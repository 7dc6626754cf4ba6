#include "surface/grasp.hpp"

#include <algorithm>
#include <cmath>

namespace facet {
namespace {

/// Places along an overlap that are tried, to either side of the one nearest to the centre.
constexpr int most_places = 16;

/// Deviations of the depth from a plane up to this are noise or the finger's own clearance.
float standoff_m(const GraspInput& input, const GraspParams& params, float depth_m) {
  return std::max(params.clearance_mm / 1000, 3 * input.noise.sigma_m(depth_m));
}

struct Interval {
  double low = 0, high = 0;
};
Interval extent(Vec2 axis, Vec2 from, Vec2 to) {
  const double a = dot(from, axis), b = dot(to, axis);
  return {std::min(a, b), std::max(a, b)};
}

Grasp to_grasp(const PlaneFrame& frame, const PlanarContact& a, const PlanarContact& b, double score) {
  Grasp grasp;
  grasp.contacts_m = {frame.to_space(a.point), frame.to_space(b.point)};
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec2 px = image_of(frame.camera(), grasp.contacts_m[i]);
    grasp.contacts_px[i] = {px.x, px.y};
  }
  const Vec3 across = grasp.contacts_m[1] - grasp.contacts_m[0];
  grasp.closing_axis = normalized(across);
  grasp.width_m = norm(across);
  grasp.score = static_cast<float>(score);
  return grasp;
}

}  // namespace

void GraspFinder::find(const GraspInput& input, const GraspParams& params, Surface& surface) {
  surface.grasps.clear();
  if (!surface.plane || !surface.pose || surface.contour.outer.empty()) return;
  const auto& edges =
      edges_.find(surface, input.labels, input.edges, static_cast<double>(params.line_tolerance_px));
  if (edges.size() < 2) return;
  const Plane plane = surface.curved ? plane_of_outline(input, params, surface) : *surface.plane;
  const PlaneFrame frame(plane, input.camera, surface.pose->centre_m);
  collect_sides(frame, params, edges);
  pairs_.clear();
  for (std::size_t i = 0; i < sides_.size(); ++i)
    for (std::size_t j = i + 1; j < sides_.size(); ++j)
      if (const auto found = pair(params, sides_[i], sides_[j])) pairs_.push_back(*found);
  std::stable_sort(pairs_.begin(), pairs_.end(),
                   [](const Pair& a, const Pair& b) { return a.score > b.score; });

  const GraspClearance clearance{input.depth_m, input.labels, frame, surface.id,
                                 standoff_m(input, params, frame.origin_m().z)};
  for (const Pair& p : pairs_) {
    if (surface.grasps.size() == static_cast<std::size_t>(params.most_per_surface)) break;
    if (const auto grasp = place(clearance, params, p)) surface.grasps.push_back(*grasp);
  }
}

/// Silhouettes of cylinders, cones and balls are plane curves.
Plane GraspFinder::plane_of_outline(const GraspInput& input, const GraspParams& params,
                                    const Surface& surface) {
  constexpr std::size_t most_points = 128;
  const std::vector<Vec2>& pixels = edges_.pixels();
  const std::size_t stride = (pixels.size() + most_points - 1) / most_points;
  outline_.resize(0);
  for (std::size_t i = 0; i < pixels.size(); i += stride) {
    const float z = input.depth_m(static_cast<int>(pixels[i].x), static_cast<int>(pixels[i].y));
    if (z > 0)
      outline_.add(
          input.camera.back_project(static_cast<float>(pixels[i].x), static_cast<float>(pixels[i].y), z));
  }
  const Vec3 centre = surface.pose->centre_m;
  const Vec3 sight = normalized(centre);
  const PlaneFit fit = fit_plane(outline_, {}, standoff_m(input, params, centre.z), input.seed,
                                 static_cast<std::uint64_t>(surface.id));
  constexpr float most_oblique_cos = 0.3f;
  if (fit.plane && dot(fit.plane->normal, sight) < -most_oblique_cos) return *fit.plane;
  return {-sight, norm(centre)};
}

void GraspFinder::collect_sides(const PlaneFrame& frame, const GraspParams& params,
                                const std::vector<StraightEdge>& edges) {
  sides_.clear();
  for (const StraightEdge& edge : edges) {
    if (norm(edge.to - edge.from) < static_cast<double>(params.min_edge_px)) continue;
    const auto from = frame.from_image(edge.from), to = frame.from_image(edge.to);
    if (!from || !to) continue;
    const Vec2 along = *to - *from;
    if (1000 * norm(along) < static_cast<double>(params.finger_width_mm)) continue;
    sides_.push_back({*from, *to, left_of(normalized(along))});
  }
}

std::optional<GraspFinder::Pair> GraspFinder::pair(const GraspParams& params, const Side& a, const Side& b) {
  const Vec2 closing = normalized(a.inward - b.inward);
  if (!(dot(closing, a.inward) > 0)) return std::nullopt;
  const Vec2 axis = left_of(closing);
  const Interval over_a = extent(axis, a.from, a.to), over_b = extent(axis, b.from, b.to);
  const double low = std::max(over_a.low, over_b.low), high = std::min(over_a.high, over_b.high);
  const double half_finger_m = static_cast<double>(params.finger_width_mm) / 2000;
  if (!(high - low >= 2 * half_finger_m)) return std::nullopt;
  // The contacts always lie opposite along `closing`, so where they stand does not matter to the squeeze.
  const PlanarContact p = contact_at(a, axis, 0.5 * (low + high)),
                      q = contact_at(b, axis, 0.5 * (low + high));
  const bool face_each_other = dot(q.point - p.point, closing) > 0;
  if (!face_each_other || !spans_planar_wrenches(p, q, static_cast<double>(params.friction)))
    return std::nullopt;
  return Pair{a, b, axis, low + half_finger_m, high - half_finger_m, -dot(a.inward, b.inward) * (high - low)};
}

std::optional<Grasp> GraspFinder::place(const GraspClearance& clearance, const GraspParams& params,
                                        const Pair& pair) {
  const double finger_m = static_cast<double>(params.finger_width_mm) / 1000;
  const double gap_px = static_cast<double>(params.line_tolerance_px) + 1;
  const double nearest = std::clamp(0.0, pair.low, pair.high);  // 0: beside the surface's centre
  const double step_m = std::max(finger_m, (pair.high - pair.low) / most_places);
  for (int i = 0; i <= 2 * most_places; ++i) {
    const double at = nearest + (i % 2 == 0 ? 1 : -1) * ((i + 1) / 2) * step_m;
    if (at < pair.low || at > pair.high) continue;
    const PlanarContact a = contact_at(pair.a, pair.axis, at), b = contact_at(pair.b, pair.axis, at);
    const double width_mm = 1000 * norm(b.point - a.point);
    if (width_mm < static_cast<double>(params.min_opening_mm) ||
        width_mm > static_cast<double>(params.max_opening_mm))
      continue;
    if (clearance.is_free_outside(a, finger_m, gap_px) && clearance.is_free_outside(b, finger_m, gap_px) &&
        clearance.is_free_between(a, b))
      return to_grasp(clearance.frame, a, b, pair.score);
  }
  return std::nullopt;
}

PlanarContact GraspFinder::contact_at(const Side& side, Vec2 axis, double at) {
  const double from = dot(side.from, axis), to = dot(side.to, axis);
  return {side.from + ((at - from) / (to - from)) * (side.to - side.from), side.inward};
}

}  // namespace facet

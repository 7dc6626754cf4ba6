#include "score/grasp_score.hpp"

#include <algorithm>
#include <cmath>

#include "score/offsets.hpp"
#include "score/polyline_distance.hpp"

namespace facet {
namespace {

bool is_finite(ImagePoint p) {
  return std::isfinite(p.x) && std::isfinite(p.y);
}

class GraspScorer {
 public:
  GraspScorer(const FrameTruth& frame, const RegionComparison& comparison, const Prediction& prediction)
      : frame_(frame),
        prediction_(prediction),
        tolerance_px_(frame.tolerance_px()),
        around_(offsets_within(tolerance_px_ + 1)),
        found_(frame.scored_surfaces.size()),
        detected_(frame.scored_surfaces.size(), false) {
    for (const RegionMatch& match : comparison.matches) {
      const auto t = static_cast<std::size_t>(match.truth);
      detected_[t] = true;
      found_[t] =
          surfaces_of(comparison.predicted.regions[static_cast<std::size_t>(match.region)], prediction);
    }
  }

  GraspScore score() const {
    GraspScore score;
    for (std::size_t s = 0; s < frame_.scored_surfaces.size(); ++s) {
      if (!frame_.scored_surfaces[s].graspable) continue;
      score.surfaces.add(detected_[s]);
      const int index = static_cast<int>(s);
      score.surfaces_by_grasp.add(is_held([index](const ScoredEdge& e) {
        return std::find(e.surfaces.begin(), e.surfaces.end(), index) != e.surfaces.end();
      }));
    }
    for (const ScoredObject& object : frame_.scored_objects) {
      if (!object.graspable) continue;
      bool pose = false, grasp = false, all = true;
      for (const int surface : object.surfaces) {
        const auto s = static_cast<std::size_t>(surface);
        all = all && detected_[s];
        if (!detected_[s] || !frame_.scored_surfaces[s].graspable || !has_pose(found_[s])) continue;
        pose = true;
        grasp = grasp || has_grasp_on(found_[s], object.id);
      }
      score.objects_pose.add(pose);
      score.objects_grasp.add(grasp);
      score.objects_all_surfaces.add(all);
      score.objects_by_grasp.add(is_held([&](const ScoredEdge& e) { return e.object == object.id; }));
    }
    return score;
  }

 private:
  static bool has_pose(const std::vector<const Surface*>& surfaces) {
    return std::any_of(surfaces.begin(), surfaces.end(),
                       [](const Surface* s) { return s->pose && is_valid_pose(*s->pose); });
  }

  bool has_grasp_on(const std::vector<const Surface*>& surfaces, int object) const {
    for (const Surface* surface : surfaces)
      for (const Grasp& grasp : surface->grasps)
        if (is_on_object(grasp.contacts_px[0], object) && is_on_object(grasp.contacts_px[1], object))
          return true;
    return false;
  }

  bool is_on_object(ImagePoint p, int object) const {
    if (!is_finite(p)) return false;
    const double cx = std::round(p.x), cy = std::round(p.y);
    if (std::abs(cx) > 1e6 || std::abs(cy) > 1e6) return false;
    for (const GridOffset& o : around_) {
      const int x = static_cast<int>(cx) + o.dx, y = static_cast<int>(cy) + o.dy;
      if (!frame_.size.contains(x, y)) continue;
      const bool there =
          (frame_.has_masks && frame_.mask_object(x, y) == object) || frame_.surface_object(x, y) == object;
      if (there && std::hypot(x - p.x, y - p.y) <= tolerance_px_ + distance_slack_px) return true;
    }
    return false;
  }

  bool touches(ImagePoint p, const ScoredEdge& edge) const {
    return is_finite(p) && distance_px(p, edge.line) <= tolerance_px_ + distance_slack_px;
  }

  /// Whether a predicted grasp lies between two graspable edges out of those that `is_of` picks.
  template <class IsOf>
  bool is_held(const IsOf& is_of) const {
    std::vector<const ScoredEdge*> edges;
    for (const ScoredEdge& edge : frame_.edges)
      if (edge.graspable && is_of(edge)) edges.push_back(&edge);
    for (const Surface& surface : prediction_.surfaces)
      for (const Grasp& grasp : surface.grasps)
        if (is_between(grasp, edges)) return true;
    return std::any_of(prediction_.grasps.begin(), prediction_.grasps.end(),
                       [&](const FreeGrasp& free) { return is_between(free.grasp, edges); });
  }

  bool is_between(const Grasp& grasp, const std::vector<const ScoredEdge*>& edges) const {
    const auto [p, q] = grasp.contacts_px;
    for (const ScoredEdge* a : edges) {
      if (!touches(p, *a)) continue;
      for (const ScoredEdge* b : edges)
        if (touches(q, *b) && (a != b || turns_back(*a, p, q, tolerance_px_))) return true;
    }
    return false;
  }

  const FrameTruth& frame_;
  const Prediction& prediction_;
  double tolerance_px_;
  std::vector<GridOffset> around_;
  std::vector<std::vector<const Surface*>> found_;  ///< per truth surface, what was matched with it
  std::vector<bool> detected_;
};

/// Direction of the edge at its sample nearest to the point, over the tolerance to both sides.
ImagePoint direction_at(const ScoredEdge& edge, ImagePoint p, double tolerance_px) {
  const auto nearest = std::min_element(
      edge.samples.begin(), edge.samples.end(), [p](const ImagePoint& a, const ImagePoint& b) {
        return std::hypot(a.x - p.x, a.y - p.y) < std::hypot(b.x - p.x, b.y - p.y);
      });
  const auto reach = static_cast<std::ptrdiff_t>(std::ceil(tolerance_px));
  const ImagePoint from = *(nearest - std::min(reach, nearest - edge.samples.begin()));
  const ImagePoint to = *(nearest + std::min(reach, edge.samples.end() - 1 - nearest));
  return {to.x - from.x, to.y - from.y};
}

}  // namespace

bool turns_back(const ScoredEdge& edge, ImagePoint p, ImagePoint q, double tolerance_px) {
  const ImagePoint at_p = direction_at(edge, p, tolerance_px), at_q = direction_at(edge, q, tolerance_px);
  return at_p.x * at_q.x + at_p.y * at_q.y < 0 && std::hypot(p.x - q.x, p.y - q.y) > 2 * tolerance_px;
}

bool is_valid_pose(const SurfacePose& pose) {
  double squared = 0;
  for (const float q : pose.quaternion_wxyz) squared += static_cast<double>(q) * q;
  const bool finite =
      std::isfinite(pose.centre_m.x) && std::isfinite(pose.centre_m.y) && std::isfinite(pose.centre_m.z);
  return finite && std::abs(std::sqrt(squared) - 1) <= 1e-3;
}

std::vector<const Surface*> surfaces_of(const PredictedRegion& region, const Prediction& prediction) {
  std::vector<const Surface*> surfaces;
  for (const Surface& surface : prediction.surfaces)
    if (std::binary_search(region.ids.begin(), region.ids.end(), surface.id)) surfaces.push_back(&surface);
  std::stable_sort(surfaces.begin(), surfaces.end(),
                   [](const Surface* a, const Surface* b) { return a->area_px > b->area_px; });
  return surfaces;
}

GraspScore score_grasps(const FrameTruth& frame, const RegionComparison& comparison,
                        const Prediction& prediction) {
  return GraspScorer(frame, comparison, prediction).score();
}

}  // namespace facet

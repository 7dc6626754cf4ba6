#include "score/frame_score.hpp"

#include <algorithm>

namespace facet {
namespace {

std::vector<SurfaceOutcome> outcomes_of(const FrameTruth& frame, const RegionComparison& comparison) {
  std::vector<SurfaceOutcome> outcomes;
  for (std::size_t i = 0; i < frame.scored_surfaces.size(); ++i) {
    const ScoredSurface& s = frame.scored_surfaces[i];
    outcomes.push_back({s.number, s.object, frame.surfaces.area_px[i], s.graspable, s.curved, 0, 0});
  }
  for (const RegionMatch& match : comparison.matches) {
    SurfaceOutcome& outcome = outcomes[static_cast<std::size_t>(match.truth)];
    outcome.region = comparison.predicted.regions[static_cast<std::size_t>(match.region)].ids.front();
    outcome.iou = match.iou;
  }
  return outcomes;
}

void score_surfaces(const FrameTruth& frame, const Prediction& prediction, FrameScore& score) {
  const RegionComparison surfaces =
      compare_regions(frame, frame.surfaces, surface_regions(frame, prediction));
  score.surfaces = outcomes_of(frame, surfaces);
  score.surfaces_50 = score_detection(frame.surfaces, surfaces.matches, surfaces.classes);
  const std::vector<RegionMatch> strict =
      match_regions(frame.surfaces, surfaces.predicted, surfaces.overlaps, 0.75);
  score.surfaces_75 = score_detection(frame.surfaces, strict,
                                      classify_regions(frame, surfaces.predicted, surfaces.overlaps, strict));
  for (int i = 0; i < hoover_curve_points; ++i)
    score.hoover_curve[static_cast<std::size_t>(i)] = hoover_counts(surfaces, hoover_curve_tolerance(i));
  score.surface_overlap = score_overlap(surfaces);
  score.grasps = score_grasps(frame, surfaces, prediction);
  score.poses = score_poses(frame, surfaces, prediction);
}

}  // namespace

PredictedParts parts_of(const Prediction& prediction) {
  const std::vector<Surface>& s = prediction.surfaces;
  const auto speaks_of_poses = [](const Surface& surface) {
    return surface.pose.has_value() ||
           (!surface.no_pose_reason.empty() && surface.no_pose_reason != pose_not_provided);
  };
  const bool has_grasps = !prediction.grasps.empty() ||
                          std::any_of(s.begin(), s.end(), [](const Surface& x) { return !x.grasps.empty(); });
  return {.regions = !s.empty() || !has_grasps,
          .edges = !prediction.edges.empty(),
          .poses = std::any_of(s.begin(), s.end(), speaks_of_poses),
          .grasps = has_grasps};
}

FrameScore score_frame(const FrameTruth& frame, const Prediction& prediction, PredictedParts parts) {
  require_size_of_truth(frame, prediction);
  FrameScore score;
  score.annotated = {.surfaces = frame.has_surfaces,
                     .edges = !frame.edges.empty(),
                     .masks = frame.has_masks,
                     .poses = frame.has_surfaces && !frame.poses.empty()};
  score.predicted = parts;
  score.clutter = clutter_of(frame);
  if (score.annotated.surfaces) score_surfaces(frame, prediction, score);
  if (score.annotated.masks) {
    const RegionComparison objects = compare_regions(frame, frame.objects, object_regions(frame, prediction));
    score.object_overlap = score_overlap(objects);
    score.object_masks = score_object_masks(objects);
  }
  if (score.annotated.edges) {
    const Image<std::uint8_t> none(prediction.edges.empty() ? frame.size : Size{}, 0);
    const Image<std::uint8_t>& codes = prediction.edges.empty() ? none : prediction.edges;
    score.edges = score_edges(frame, codes);
    score.boundary_depth = score_boundary(frame, codes, EdgeGroup::depth);
    score.boundary_crease = score_boundary(frame, codes, EdgeGroup::crease);
  }
  return score;
}

FrameScore score_frame(const FrameTruth& frame, const Prediction& prediction) {
  return score_frame(frame, prediction, parts_of(prediction));
}

FrameScore score_missing_prediction(const FrameTruth& frame) {
  Prediction nothing;
  nothing.labels = Image<std::uint16_t>(frame.size, 0);
  FrameScore score = score_frame(frame, nothing, {.edges = true, .poses = true, .grasps = true});
  score.failed = true;
  return score;
}

}  // namespace facet

#pragma once

#include "prediction/predicted_parts.hpp"
#include "score/boundary_match.hpp"
#include "score/clutter.hpp"
#include "score/edge_score.hpp"
#include "score/grasp_score.hpp"
#include "score/hoover.hpp"
#include "score/object_masks.hpp"
#include "score/overlap_score.hpp"
#include "score/pose_score.hpp"
#include "score/surface_detection.hpp"

namespace facet {

/// What one prediction shows of that: edges if it has an edge image; poses if a surface has one or says why
/// not; grasps if it has one; no regions if it has grasps and no surface. A method that found nothing in this
/// frame looks as if it yielded nothing: where it is known what the method yields, say so to score_frame();
/// otherwise summaries over frames take it from the other frames (see score/summary.hpp).
PredictedParts parts_of(const Prediction& prediction);

/// What the truth of a frame allows to score.
struct AnnotatedParts {
  bool surfaces = false, edges = false, masks = false, poses = false;
};

/// All scores of one frame as plain counts. Scores of parts that are not annotated stay empty (n = 0); those
/// of parts that are not predicted have no hits but their full n.
struct FrameScore {
  bool failed = false;  ///< there is no prediction
  AnnotatedParts annotated;
  PredictedParts predicted;

  DetectionScore surfaces_50, surfaces_75;  ///< at IoU 0.5 and 0.75
  std::vector<SurfaceOutcome> surfaces;     ///< every surface that counts
  std::array<HooverCounts, hoover_curve_points> hoover_curve{};
  OverlapScore surface_overlap, object_overlap;
  ObjectMaskScore object_masks;
  EdgeScore edges;
  BoundaryCounts boundary_depth, boundary_crease;
  GraspScore grasps;
  PoseScore poses;
  Clutter clutter;

  /// Hoover's classes at T = 0.8.
  const HooverCounts& hoover() const { return hoover_curve[80 - 51]; }
};
static_assert(hoover_curve_tolerance(80 - 51) == 0.8);

/// Every score of scoring a prediction against the truth of its frame. Throws Error{data} where the sizes
/// differ, or for an unknown edge code.
FrameScore score_frame(const FrameTruth& frame, const Prediction& prediction, PredictedParts parts);
FrameScore score_frame(const FrameTruth& frame, const Prediction& prediction);

/// The score of a frame for which a method has no prediction: no hits, full denominators.
FrameScore score_missing_prediction(const FrameTruth& frame);

}  // namespace facet

#include "record/score_json.hpp"

namespace facet {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Tally, hit, n)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(AnnotatedParts, surfaces, edges, masks, poses)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PredictedParts, edges, poses, grasps)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(DetectionScore, truth, detected, wrong, iou_total, table, background,
                                   ignored, tiny)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(HooverCounts, truth, predicted, correct, over, over_regions, under,
                                   under_truth, missed, noise)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(OverlapScore, common_px, predicted_px, truth_px, boundary_predicted_hit,
                                   boundary_predicted, boundary_truth_hit, boundary_truth, found_75, truth,
                                   predicted)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ObjectMaskScore, leakage, coverage, outline_recall, outline_precision)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EdgeRecall, graspable, all, depth, convex, concave)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EdgePrecision, all, depth, convex, concave)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EdgeScore, recall_6px, recall_3px, recall_kind_ignored_6px,
                                   recall_kind_ignored_3px, precision_6px, precision_3px,
                                   precision_kind_ignored_6px, precision_kind_ignored_3px, recall_curve,
                                   precision_curve)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BoundaryCounts, matched, predicted, truth)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(GraspScore, surfaces, objects_grasp, objects_pose, objects_all_surfaces,
                                   surfaces_by_grasp, objects_by_grasp)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PoseError, surface, normal_deg, offset_m, lateral_m, rotation_deg)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PoseScore, success_5, success_10, auc_total, errors, curved_centre_m)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Clutter, objects, surfaces, occluded_share, contacts)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(FrameScore, failed, annotated, predicted, surfaces_50, surfaces_75,
                                   hoover_curve, surface_overlap, object_overlap, object_masks, edges,
                                   boundary_depth, boundary_crease, grasps, poses, clutter)

nlohmann::json score_to_json(const FrameScore& score) {
  return score;
}

FrameScore score_from_json(const nlohmann::json& json) {
  return json.get<FrameScore>();
}

}  // namespace facet

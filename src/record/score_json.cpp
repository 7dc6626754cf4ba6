#include "record/score_json.hpp"

#include <tuple>

namespace facet {

// Counts that come in great numbers are arrays, so that a line of frames.jsonl stays short and quick to read.

template <class Json, class... Values>
void write_array(Json& json, const Values&... values) {
  json = Json::array({values...});
}
template <class Json, class... Values>
void read_array(const Json& json, Values&... values) {
  std::size_t i = 0;
  (json.at(i++).get_to(values), ...);
}

// A list of members, once for both directions.
#define FACET_ARRAY_JSON(Type, ...)                                              \
  void to_json(nlohmann::json& json, const Type& v) {                            \
    std::apply([&](const auto&... m) { write_array(json, m...); }, __VA_ARGS__); \
  }                                                                              \
  void from_json(const nlohmann::json& json, Type& v) {                          \
    std::apply([&](auto&... m) { read_array(json, m...); }, __VA_ARGS__);        \
  }
FACET_ARRAY_JSON(Tally, std::tie(v.hit, v.n))
FACET_ARRAY_JSON(HooverCounts, std::tie(v.truth, v.predicted, v.correct, v.over, v.over_regions, v.under,
                                        v.under_truth, v.missed, v.noise))
FACET_ARRAY_JSON(SurfaceOutcome,
                 std::tie(v.number, v.object, v.area_px, v.graspable, v.curved, v.region, v.iou))
FACET_ARRAY_JSON(EdgeOutcome, std::tie(v.number, v.object, v.kind, v.graspable, v.samples, v.hit_6px,
                                       v.labelled_6px, v.detected_6px))
#undef FACET_ARRAY_JSON

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(AnnotatedParts, surfaces, edges, masks, poses)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(PredictedParts, regions, edges, poses, grasps)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(DetectionScore, truth, detected, wrong, iou_total, table, background,
                                   ignored, tiny)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(OverlapScore, common_px, predicted_px, truth_px, boundary_predicted_hit,
                                   boundary_predicted, boundary_truth_hit, boundary_truth, found_75, truth,
                                   predicted)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ObjectMaskScore, leakage, coverage, outline_recall, outline_precision)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EdgeRecall, graspable, all, depth, convex, concave)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EdgePrecision, all, depth, convex, concave)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EdgeScore, recall_6px, recall_3px, recall_kind_ignored_6px,
                                   recall_kind_ignored_3px, precision_6px, precision_3px,
                                   precision_kind_ignored_6px, precision_kind_ignored_3px, recall_curve,
                                   precision_curve, outcomes)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(BoundaryCounts, matched, predicted, truth)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(GraspScore, surfaces, objects_grasp, objects_pose, objects_all_surfaces,
                                   surfaces_by_grasp, objects_by_grasp)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PoseError, surface, normal_deg, offset_m, lateral_m, rotation_deg)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PoseScore, success_5, success_10, auc_total, errors, curved_centre_m)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Clutter, objects, surfaces, occluded_share, contacts)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(FrameScore, failed, annotated, predicted, surfaces_50, surfaces_75,
                                   surfaces, hoover_curve, surface_overlap, object_overlap, object_masks,
                                   edges, boundary_depth, boundary_crease, grasps, poses, clutter)

nlohmann::json score_to_json(const FrameScore& score) {
  return score;
}

FrameScore score_from_json(const nlohmann::json& json) {
  return json.get<FrameScore>();
}

}  // namespace facet

#include "score/metrics.hpp"

#include "core/error.hpp"

namespace facet {
namespace {

/// What a group of metrics needs.
struct Needs {
  AnnotatedParts truth;
  PredictedParts prediction;
};
constexpr Needs surfaces{{.surfaces = true}, {}};
constexpr Needs masks{{.masks = true}, {}};
constexpr Needs edges{{.edges = true}, {.edges = true}};
constexpr Needs poses{{.surfaces = true}, {.poses = true}};
constexpr Needs grasps{{.surfaces = true}, {.poses = true, .grasps = true}};
constexpr Needs grasped_edges{{.surfaces = true, .edges = true}, {.grasps = true}};
constexpr Needs true_poses{{.surfaces = true, .poses = true}, {.poses = true}};

using List = std::vector<Metric>;

void add_tally(List& list, std::string name, const Needs& needs,
               std::function<Tally(const FrameScore&)> tally) {
  list.push_back({std::move(name), needs.truth, needs.prediction, MetricRule::proportion,
                  [tally = std::move(tally)](const FrameScore& f) {
                    const Tally t = tally(f);
                    return MetricSums{static_cast<double>(t.hit), static_cast<double>(t.n)};
                  }});
}

void add_ratio(List& list, std::string name, const Needs& needs,
               std::function<MetricSums(const FrameScore&)> sums) {
  list.push_back({std::move(name), needs.truth, needs.prediction, MetricRule::ratio, std::move(sums)});
}

/// NAME_precision, NAME_recall and NAME_f of the same sums.
void add_precision_recall(List& list, const std::string& name, const Needs& needs,
                          const std::function<MetricSums(const FrameScore&)>& sums) {
  list.push_back({name + "_precision", needs.truth, needs.prediction, MetricRule::precision, sums});
  list.push_back({name + "_recall", needs.truth, needs.prediction, MetricRule::recall, sums});
  list.push_back({name + "_f", needs.truth, needs.prediction, MetricRule::f_score, sums});
}

void add_detection(List& list, const std::string& threshold, DetectionScore FrameScore::*score) {
  add_tally(list, "surface_recall_" + threshold, surfaces,
            [score](const FrameScore& f) { return (f.*score).recall(); });
  add_tally(list, "surface_precision_" + threshold, surfaces,
            [score](const FrameScore& f) { return (f.*score).precision(); });
  add_ratio(list, "surface_f1_" + threshold, surfaces, [score](const FrameScore& f) {
    const DetectionScore& s = f.*score;
    return MetricSums{2.0 * s.detected, 1.0 * s.detected + s.wrong + s.truth};
  });
}

void add_surfaces(List& list) {
  add_detection(list, "0.5", &FrameScore::surfaces_50);
  add_detection(list, "0.75", &FrameScore::surfaces_75);
  add_tally(list, "surface_recall_graspable_0.5", surfaces,
            [](const FrameScore& f) { return f.grasps.surfaces; });
  add_ratio(list, "mean_iou", surfaces, [](const FrameScore& f) {
    return MetricSums{f.surfaces_50.iou_total, 1.0 * f.surfaces_50.detected};
  });
  add_ratio(list, "pq", surfaces, [](const FrameScore& f) {
    const DetectionScore& s = f.surfaces_50;
    return MetricSums{s.iou_total, 0.5 * s.detected + 0.5 * s.wrong + 0.5 * s.truth};
  });
  add_ratio(list, "surface_count_ratio", surfaces, [](const FrameScore& f) {
    return MetricSums{1.0 * f.surfaces_50.detected + f.surfaces_50.wrong, 1.0 * f.surfaces_50.truth};
  });
  const auto add_hoover = [&list](const char* name, int HooverCounts::*hit, int HooverCounts::*of) {
    add_tally(list, name, surfaces, [hit, of](const FrameScore& f) {
      return Tally{f.hoover().*hit, f.hoover().*of};
    });
  };
  add_hoover("hoover_correct_0.8", &HooverCounts::correct, &HooverCounts::truth);
  add_hoover("hoover_over_0.8", &HooverCounts::over, &HooverCounts::truth);
  add_hoover("hoover_under_0.8", &HooverCounts::under_truth, &HooverCounts::truth);
  add_hoover("hoover_missed_0.8", &HooverCounts::missed, &HooverCounts::truth);
  add_hoover("hoover_noise_0.8", &HooverCounts::noise, &HooverCounts::predicted);
}

void add_overlap(List& list, const std::string& item, const Needs& needs, OverlapScore FrameScore::*score) {
  add_precision_recall(list, item + "_overlap", needs, [score](const FrameScore& f) {
    const OverlapScore& s = f.*score;
    return MetricSums{1.0 * s.common_px, 1.0 * s.predicted_px, 1.0 * s.common_px, 1.0 * s.truth_px};
  });
  add_precision_recall(list, item + "_boundary", needs, [score](const FrameScore& f) {
    const OverlapScore& s = f.*score;
    return MetricSums{1.0 * s.boundary_predicted_hit, 1.0 * s.boundary_predicted, 1.0 * s.boundary_truth_hit,
                      1.0 * s.boundary_truth};
  });
  add_tally(list, item + "_f_0.75", needs, [score](const FrameScore& f) {
    return Tally{(f.*score).found_75, (f.*score).truth};
  });
}

void add_object_masks(List& list) {
  // Pixels depend on each other: no Wilson interval for their shares.
  const auto add = [&list](const char* name, Tally ObjectMaskScore::*tally) {
    add_ratio(list, name, masks, [tally](const FrameScore& f) {
      const Tally& t = f.object_masks.*tally;
      return MetricSums{1.0 * t.hit, 1.0 * t.n};
    });
  };
  add("object_leakage", &ObjectMaskScore::leakage);
  add("object_coverage", &ObjectMaskScore::coverage);
  add_precision_recall(list, "object_outline", masks, [](const FrameScore& f) {
    const Tally& p = f.object_masks.outline_precision;
    const Tally& r = f.object_masks.outline_recall;
    return MetricSums{1.0 * p.hit, 1.0 * p.n, 1.0 * r.hit, 1.0 * r.n};
  });
}

void add_edge_recall(List& list, const std::string& tolerance, EdgeRecall EdgeScore::*recall,
                     EdgeRecall EdgeScore::*kind_ignored) {
  const auto add = [&](const std::string& name, Tally EdgeRecall::*of, EdgeRecall EdgeScore::*from) {
    add_tally(list, "edge_recall_" + name + "_" + tolerance, edges,
              [of, from](const FrameScore& f) { return f.edges.*from.*of; });
  };
  add("graspable", &EdgeRecall::graspable, recall);
  add("all", &EdgeRecall::all, recall);
  add("depth", &EdgeRecall::depth, recall);
  add("convex", &EdgeRecall::convex, recall);
  add("concave", &EdgeRecall::concave, recall);
  add("kind_ignored", &EdgeRecall::all, kind_ignored);
  add("graspable_kind_ignored", &EdgeRecall::graspable, kind_ignored);
}

void add_edge_precision(List& list, const std::string& tolerance, EdgePrecision EdgeScore::*precision,
                        Tally EdgeScore::*kind_ignored) {
  const auto add = [&](const std::string& name, Tally EdgePrecision::*of) {
    add_tally(list, "edge_precision_" + name + tolerance, edges,
              [of, precision](const FrameScore& f) { return f.edges.*precision.*of; });
  };
  add("", &EdgePrecision::all);
  add("depth_", &EdgePrecision::depth);
  add("convex_", &EdgePrecision::convex);
  add("concave_", &EdgePrecision::concave);
  add_tally(list, "edge_precision_kind_ignored_" + tolerance, edges,
            [kind_ignored](const FrameScore& f) { return f.edges.*kind_ignored; });
}

void add_boundary(List& list, const std::string& group, BoundaryCounts FrameScore::*counts) {
  const auto add = [&](const char* what, bool predicted, bool truth) {
    add_ratio(list, std::string("boundary_") + what + "_" + group, edges, [=](const FrameScore& f) {
      const BoundaryCounts& b = f.*counts;
      return MetricSums{(predicted && truth ? 2.0 : 1.0) * b.matched,
                        (predicted ? 1.0 : 0.0) * b.predicted + (truth ? 1.0 : 0.0) * b.truth};
    });
  };
  add("precision", true, false);
  add("recall", false, true);
  add("f", true, true);
}

void add_grasps(List& list) {
  const auto add = [&list](const char* name, const Needs& needs, Tally GraspScore::*tally) {
    add_tally(list, name, needs, [tally](const FrameScore& f) { return f.grasps.*tally; });
  };
  add("objects_grasp", grasps, &GraspScore::objects_grasp);
  add("objects_pose", poses, &GraspScore::objects_pose);
  add("objects_all_surfaces", surfaces, &GraspScore::objects_all_surfaces);
  add("surfaces_by_grasp", grasped_edges, &GraspScore::surfaces_by_grasp);
  add("objects_by_grasp", grasped_edges, &GraspScore::objects_by_grasp);
}

void add_poses(List& list) {
  add_tally(list, "pose_success_5", true_poses, [](const FrameScore& f) { return f.poses.success_5; });
  add_tally(list, "pose_success_10", true_poses, [](const FrameScore& f) { return f.poses.success_10; });
  add_ratio(list, "pose_auc", true_poses, [](const FrameScore& f) {
    return MetricSums{f.poses.auc_total, 1.0 * f.poses.success_5.n};
  });
}

List all_metrics() {
  List list;
  add_surfaces(list);
  add_overlap(list, "surface", surfaces, &FrameScore::surface_overlap);
  add_overlap(list, "object", masks, &FrameScore::object_overlap);
  add_object_masks(list);
  add_edge_recall(list, "6px", &EdgeScore::recall_6px, &EdgeScore::recall_kind_ignored_6px);
  add_edge_recall(list, "3px", &EdgeScore::recall_3px, &EdgeScore::recall_kind_ignored_3px);
  add_edge_precision(list, "6px", &EdgeScore::precision_6px, &EdgeScore::precision_kind_ignored_6px);
  add_edge_precision(list, "3px", &EdgeScore::precision_3px, &EdgeScore::precision_kind_ignored_3px);
  add_boundary(list, "depth", &FrameScore::boundary_depth);
  add_boundary(list, "crease", &FrameScore::boundary_crease);
  add_grasps(list);
  add_poses(list);
  return list;
}

std::vector<MetricCurve> all_curves() {
  std::vector<double> tolerances, pixels;
  for (int i = 0; i < hoover_curve_points; ++i) tolerances.push_back(hoover_curve_tolerance(i));
  for (int i = 1; i <= edge_curve_px; ++i) pixels.push_back(i);
  std::vector<MetricCurve> curves;
  curves.push_back(
      {"hoover_correct", surfaces.truth, surfaces.prediction, tolerances, [](const FrameScore& f) {
         std::vector<Tally> out;
         for (const HooverCounts& h : f.hoover_curve) out.push_back({h.correct, h.truth});
         return out;
       }});
  const auto add_recall = [&](const char* name, Tally EdgeRecall::*of) {
    curves.push_back({name, edges.truth, edges.prediction, pixels, [of](const FrameScore& f) {
                        std::vector<Tally> out;
                        for (const EdgeRecall& r : f.edges.recall_curve) out.push_back(r.*of);
                        return out;
                      }});
  };
  add_recall("edge_recall_graspable", &EdgeRecall::graspable);
  add_recall("edge_recall_all", &EdgeRecall::all);
  curves.push_back({"edge_precision", edges.truth, edges.prediction, pixels, [](const FrameScore& f) {
                      return std::vector<Tally>(f.edges.precision_curve.begin(),
                                                f.edges.precision_curve.end());
                    }});
  return curves;
}

}  // namespace

std::optional<double> Metric::value(const MetricSums& s) const {
  const PrecisionRecall pr = precision_recall(s[0], s[1], s[2], s[3]);
  switch (rule) {
    case MetricRule::precision:
      return pr.precision;
    case MetricRule::recall:
      return pr.recall;
    case MetricRule::f_score:
      return pr.f;
    default:
      return s[1] > 0 ? std::optional(s[0] / s[1]) : std::nullopt;
  }
}

bool Metric::is_annotated(const FrameScore& frame) const {
  const AnnotatedParts& has = frame.annotated;
  return (has.surfaces || !needs_truth.surfaces) && (has.edges || !needs_truth.edges) &&
         (has.masks || !needs_truth.masks) && (has.poses || !needs_truth.poses);
}

bool Metric::is_predicted(const FrameScore& frame) const {
  const PredictedParts& has = frame.predicted;
  return (has.edges || !needs_prediction.edges) && (has.poses || !needs_prediction.poses) &&
         (has.grasps || !needs_prediction.grasps);
}

const std::vector<Metric>& score_metrics() {
  static const std::vector<Metric> metrics = all_metrics();
  return metrics;
}

const Metric& score_metric(const std::string& name) {
  for (const Metric& metric : score_metrics())
    if (metric.name == name) return metric;
  throw Error(ErrorKind::internal, "no metric is called " + name);
}

const std::vector<MetricCurve>& score_curves() {
  static const std::vector<MetricCurve> curves = all_curves();
  return curves;
}

}  // namespace facet

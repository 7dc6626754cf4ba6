#include "score/metrics.hpp"

#include "core/error.hpp"
#include "score/metric_list.hpp"

namespace facet {
namespace {

std::vector<Metric> all_metrics() {
  MetricList list;
  add_region_metrics(list);
  add_edge_metrics(list);
  add_grasp_metrics(list);
  for (Metric& metric : list.metrics)
    for (const char* name :
         {"hoover_over_0.8", "hoover_under_0.8", "hoover_missed_0.8", "hoover_noise_0.8", "object_leakage"})
      if (metric.name == name) metric.less_is_better = true;
  return std::move(list.metrics);
}

std::vector<MetricCurve> all_curves() {
  std::vector<double> tolerances, pixels;
  for (int i = 0; i < hoover_curve_points; ++i) tolerances.push_back(hoover_curve_tolerance(i));
  for (int i = 1; i <= edge_curve_px; ++i) pixels.push_back(i);
  std::vector<MetricCurve> curves;
  curves.push_back({"hoover_correct", metric_needs::surfaces.truth, metric_needs::surfaces.prediction,
                    tolerances, [](const FrameScore& f) {
                      std::vector<Tally> out;
                      for (const HooverCounts& h : f.hoover_curve) out.push_back({h.correct, h.truth});
                      return out;
                    }});
  const auto add_recall = [&](const char* name, Tally EdgeRecall::*of) {
    curves.push_back(
        {name, metric_needs::edges.truth, metric_needs::edges.prediction, pixels, [of](const FrameScore& f) {
           std::vector<Tally> out;
           for (const EdgeRecall& r : f.edges.recall_curve) out.push_back(r.*of);
           return out;
         }});
  };
  add_recall("edge_recall_graspable", &EdgeRecall::graspable);
  add_recall("edge_recall_all", &EdgeRecall::all);
  curves.push_back({"edge_precision", metric_needs::edges.truth, metric_needs::edges.prediction, pixels,
                    [](const FrameScore& f) {
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
  return (has.regions || !needs_prediction.regions) && (has.edges || !needs_prediction.edges) &&
         (has.poses || !needs_prediction.poses) && (has.grasps || !needs_prediction.grasps);
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

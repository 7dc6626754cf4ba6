#include "score/metric_column.hpp"

namespace facet {
namespace {

std::string missing_truth(const AnnotatedParts& needs) {
  return std::string("the truth has no ") + (needs.poses      ? "poses"
                                             : needs.edges    ? "edges"
                                             : needs.surfaces ? "surfaces"
                                                              : "object masks");
}

/// The first of the parts that no prediction has.
std::string missing_prediction(const PredictedParts& needs, const PredictedParts& has) {
  return std::string("the predictions have no ") + (needs.regions && !has.regions ? "regions"
                                                    : needs.edges && !has.edges   ? "edges"
                                                    : needs.grasps && !has.grasps ? "grasps"
                                                                                  : "poses");
}

}  // namespace

PredictedParts united(const PredictedParts& a, const PredictedParts& b) {
  return {a.regions || b.regions, a.edges || b.edges, a.poses || b.poses, a.grasps || b.grasps};
}

std::string reason_not_provided(const ScoredFrames& frames, const AnnotatedParts& needs_truth,
                                const PredictedParts& needs_prediction) {
  Metric metric;  // carries the needs alone
  metric.needs_truth = needs_truth;
  metric.needs_prediction = needs_prediction;
  bool annotated = false, predicted = false, any_prediction = false;
  PredictedParts has{.regions = false};
  for (const auto& [score, sequence] : frames) {
    if (!metric.is_annotated(score)) continue;
    annotated = true;
    if (score.failed) continue;
    any_prediction = true;
    has = united(has, score.predicted);
    predicted = predicted || metric.is_predicted(score);
  }
  if (!annotated) return frames.empty() ? "no frame was scored" : missing_truth(needs_truth);
  return predicted || !any_prediction ? "" : missing_prediction(needs_prediction, has);
}

MetricColumn::MetricColumn(const ScoredFrames& frames, const Metric& metric) {
  for (const auto& [score, sequence] : frames) {
    sums.push_back(metric.is_annotated(score) ? std::optional(metric.sums(score)) : std::nullopt);
    values.push_back(sums.back() ? metric.value(*sums.back()) : std::nullopt);
  }
}

std::optional<double> MetricColumn::micro(const std::vector<int>& frames, const Metric& metric) const {
  MetricSums total{};
  bool any = false;
  for (const int frame : frames) {
    const auto& s = sums[static_cast<std::size_t>(frame)];
    if (!s) continue;
    any = true;
    for (std::size_t k = 0; k < total.size(); ++k) total[k] += (*s)[k];
  }
  return any ? metric.value(total) : std::nullopt;
}

std::optional<double> MetricColumn::macro(const std::vector<int>& frames) const {
  double total = 0;
  int count = 0;
  for (const int frame : frames) {
    const auto& v = values[static_cast<std::size_t>(frame)];
    if (v) total += *v, ++count;
  }
  return count > 0 ? std::optional(total / count) : std::nullopt;
}

std::vector<int> all_indices(const ScoredFrames& frames) {
  std::vector<int> indices(frames.size());
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = static_cast<int>(i);
  return indices;
}

std::vector<std::string> sequences_of(const ScoredFrames& frames) {
  std::vector<std::string> names;
  for (const auto& frame : frames) names.push_back(frame.sequence);
  return names;
}

}  // namespace facet

#include "score/summary.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "score/metric_column.hpp"

namespace facet {
namespace {

MetricSummary summarise_metric(const ScoredFrames& frames, const Metric& metric, const MetricColumn& column) {
  MetricSummary out;
  out.name = metric.name;
  out.is_proportion = metric.rule == MetricRule::proportion;
  out.not_provided = reason_not_provided(frames, metric.needs_truth, metric.needs_prediction);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (!column.sums[i]) {
      ++out.frames_not_annotated;
    } else if (out.not_provided.empty()) {
      ++(column.values[i] ? out.macro_frames : out.frames_without);
      out.hit += out.is_proportion ? (*column.sums[i])[0] : 0;
      out.n += out.is_proportion ? (*column.sums[i])[1] : 0;
    }
  }
  if (!out.not_provided.empty()) return out;
  out.micro = column.micro(all_indices(frames), metric);
  out.macro = column.macro(all_indices(frames));
  if (out.is_proportion && out.n > 0) out.micro_interval = wilson_interval(out.hit, out.n);
  return out;
}

std::vector<MetricSummary> summarise_metrics(const ScoredFrames& frames, const BootstrapOptions& options) {
  std::vector<MetricColumn> columns;
  std::vector<MetricSummary> out;
  for (const Metric& metric : score_metrics()) {
    columns.emplace_back(frames, metric);
    out.push_back(summarise_metric(frames, metric, columns.back()));
  }
  if (frames.size() < 2) return out;
  std::vector<std::vector<double>> micro(out.size()), macro(out.size());
  for_each_resample(sequences_of(frames), options, [&](const std::vector<int>& drawn) {
    for (std::size_t m = 0; m < out.size(); ++m) {
      if (!out[m].not_provided.empty()) continue;
      if (!out[m].is_proportion)
        if (const auto v = columns[m].micro(drawn, score_metrics()[m])) micro[m].push_back(*v);
      if (const auto v = columns[m].macro(drawn)) macro[m].push_back(*v);
    }
  });
  for (std::size_t m = 0; m < out.size(); ++m) {
    if (!out[m].is_proportion) out[m].micro_interval = percentile_interval(std::move(micro[m]));
    out[m].macro_interval = percentile_interval(std::move(macro[m]));
  }
  return out;
}

std::vector<ErrorSummary> summarise_errors(const ScoredFrames& frames) {
  const Metric& pose_metric = score_metric("pose_auc");
  const std::string reason =
      reason_not_provided(frames, pose_metric.needs_truth, pose_metric.needs_prediction);
  std::vector<ErrorSummary> out;
  const auto add = [&](const char* name, const auto& values_of) {
    std::vector<double> values;
    for (const auto& [score, sequence] : frames) values_of(score.poses, values);
    std::sort(values.begin(), values.end());
    ErrorSummary summary{.name = name, .not_provided = reason, .n = static_cast<int>(values.size())};
    if (reason.empty() && values.empty()) summary.not_provided = "no detected surface has a pose";
    if (!values.empty()) {
      summary.p50 = sorted_quantile(values, 0.5);
      summary.p95 = sorted_quantile(values, 0.95);
    }
    out.push_back(std::move(summary));
  };
  const auto of = [](double PoseError::*error) {
    return [error](const PoseScore& score, std::vector<double>& values) {
      for (const PoseError& e : score.errors) values.push_back(e.*error);
    };
  };
  add("normal_error_deg", of(&PoseError::normal_deg));
  add("offset_error_m", of(&PoseError::offset_m));
  add("lateral_error_m", of(&PoseError::lateral_m));
  add("rotation_error_deg", of(&PoseError::rotation_deg));
  add("curved_centre_error_m", [](const PoseScore& score, std::vector<double>& values) {
    values.insert(values.end(), score.curved_centre_m.begin(), score.curved_centre_m.end());
  });
  return out;
}

std::vector<CurveSummary> summarise_curves(const ScoredFrames& frames) {
  std::vector<CurveSummary> out;
  for (const MetricCurve& curve : score_curves()) {
    CurveSummary summary{curve.name, reason_not_provided(frames, curve.needs_truth, curve.needs_prediction),
                         curve.thresholds, std::vector<Tally>(curve.thresholds.size())};
    for (const auto& [score, sequence] : frames) {
      const std::vector<Tally> tallies = curve.tallies(score);
      for (std::size_t i = 0; i < tallies.size(); ++i) {
        summary.tallies[i].hit += tallies[i].hit;
        summary.tallies[i].n += tallies[i].n;
      }
    }
    out.push_back(std::move(summary));
  }
  return out;
}

}  // namespace

const MetricSummary& ScoreSummary::metric(const std::string& name) const {
  for (const MetricSummary& m : metrics)
    if (m.name == name) return m;
  throw Error(ErrorKind::internal, "no metric is called " + name);
}

ScoreSummary summarise_scores(const ScoreCollection& collection, const BootstrapOptions& options) {
  const ScoredFrames& frames = collection.frames;
  const auto failed = static_cast<int>(
      std::count_if(frames.begin(), frames.end(), [](const auto& frame) { return frame.score.failed; }));
  const auto count = static_cast<int>(frames.size());
  return {.counts = {count + collection.harness_errors, count - failed, failed, collection.harness_errors},
          .metrics = summarise_metrics(frames, options),
          .errors = summarise_errors(frames),
          .curves = summarise_curves(frames)};
}

}  // namespace facet

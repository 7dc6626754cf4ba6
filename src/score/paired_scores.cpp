#include "score/paired_scores.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "score/metric_column.hpp"

namespace facet {
namespace {

/// A metric's columns on both sides.
struct ColumnPair {
  const Metric& metric;
  MetricColumn before, after;
  std::vector<double> replicates{};

  std::optional<double> change(const std::vector<int>& frames) const {
    const auto x = before.micro(frames, metric), y = after.micro(frames, metric);
    return x && y ? std::optional(*y - *x) : std::nullopt;
  }
};

std::string reason_without(const ScoredFrames& frames, const Metric& metric,
                           const std::optional<double>& value) {
  if (value) return {};
  std::string reason = reason_not_provided(frames, metric.needs_truth, metric.needs_prediction);
  return reason.empty() ? "its denominator is 0" : reason;
}

PairedScore point_estimate(const ScoredFrames& before, const ScoredFrames& after, const ColumnPair& pair) {
  PairedScore out;
  out.metric = pair.metric.name;
  const auto provided = [&](const ScoredFrames& frames) {
    return reason_not_provided(frames, pair.metric.needs_truth, pair.metric.needs_prediction).empty();
  };
  if (provided(before)) out.before = pair.before.micro(all_indices(before), pair.metric);
  if (provided(after)) out.after = pair.after.micro(all_indices(after), pair.metric);
  out.missing_before = reason_without(before, pair.metric, out.before);
  out.missing_after = reason_without(after, pair.metric, out.after);
  if (out.before && out.after) out.change = *out.after - *out.before;
  for (std::size_t i = 0; i < before.size(); ++i) {
    out.n += pair.before.sums[i].has_value();
    out.changed += pair.before.sums[i] != pair.after.sums[i];
  }
  return out;
}

std::vector<const Metric*> metrics_called(const std::vector<std::string>& names) {
  std::vector<const Metric*> metrics;
  for (const std::string& name : names) metrics.push_back(&score_metric(name));
  if (names.empty())
    for (const Metric& metric : score_metrics()) metrics.push_back(&metric);
  return metrics;
}

}  // namespace

double two_sided_p(const std::vector<double>& replicates) {
  const auto share = [&](const auto& is_beyond) {
    return (1.0 + static_cast<double>(std::count_if(replicates.begin(), replicates.end(), is_beyond))) /
           (1.0 + static_cast<double>(replicates.size()));
  };
  return std::min(
      1.0, 2 * std::min(share([](double v) { return v <= 0; }), share([](double v) { return v >= 0; })));
}

std::vector<PairedScore> pair_scores(const ScoreCollection& before, const ScoreCollection& after,
                                     const BootstrapOptions& options,
                                     const std::vector<std::string>& metrics) {
  if (before.frames.size() != after.frames.size())
    throw Error(ErrorKind::internal, "scores of different frames cannot be compared");
  std::vector<ColumnPair> pairs;
  std::vector<PairedScore> out;
  for (const Metric* metric : metrics_called(metrics)) {
    pairs.push_back({*metric, MetricColumn(before.frames, *metric), MetricColumn(after.frames, *metric)});
    out.push_back(point_estimate(before.frames, after.frames, pairs.back()));
  }
  if (before.frames.size() < 2) return out;
  for_each_resample(sequences_of(before.frames), options, [&](const std::vector<int>& drawn) {
    for (std::size_t m = 0; m < out.size(); ++m)
      if (out[m].change && out[m].changed > 0)
        if (const auto v = pairs[m].change(drawn)) pairs[m].replicates.push_back(*v);
  });
  for (std::size_t m = 0; m < out.size(); ++m) {
    if (!out[m].change) continue;
    out[m].p = two_sided_p(pairs[m].replicates);
    out[m].interval = out[m].changed > 0 ? percentile_interval(std::move(pairs[m].replicates)) : Interval{};
  }
  return out;
}

}  // namespace facet

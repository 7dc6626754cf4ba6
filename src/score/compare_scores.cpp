#include "core/error.hpp"
#include "score/metric_column.hpp"

namespace facet {

ScoreDifference compare_scores(const ScoreCollection& a, const ScoreCollection& b, const std::string& name,
                               const BootstrapOptions& options) {
  if (a.frames.size() != b.frames.size())
    throw Error(ErrorKind::internal, "scores of different frames cannot be compared");
  const Metric& metric = score_metric(name);
  const MetricColumn of_a(a.frames, metric), of_b(b.frames, metric);
  const auto is_provided = [&](const ScoreCollection& c) {
    return reason_not_provided(c.frames, metric.needs_truth, metric.needs_prediction).empty();
  };
  const auto difference = [&](const std::vector<int>& frames) -> std::optional<double> {
    const auto x = of_a.micro(frames, metric), y = of_b.micro(frames, metric);
    return x && y ? std::optional(*x - *y) : std::nullopt;
  };
  if (!is_provided(a) || !is_provided(b)) return {};
  ScoreDifference out{difference(all_indices(a.frames)), std::nullopt};
  if (a.frames.size() < 2) return out;
  std::vector<double> values;
  for_each_resample(sequences_of(a.frames), options, [&](const std::vector<int>& drawn) {
    if (const auto v = difference(drawn)) values.push_back(*v);
  });
  out.interval = percentile_interval(std::move(values));
  return out;
}

}  // namespace facet

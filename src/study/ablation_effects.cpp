#include "study/ablation_effects.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "score/metric_column.hpp"
#include "score/paired_scores.hpp"
#include "study/design_names.hpp"

namespace facet {
namespace {

/// Scored frames of the methods of one comparison on one data set, in one order.
struct AlignedScores {
  std::map<std::string, ScoredFrames> of_method;
  std::size_t frames = 0;
  bool is_sequence = false;
};

using RowsByFrame = std::map<std::string, std::map<std::string, const FrameRow*>>;

RowsByFrame rows_on(const std::vector<FrameRow>& rows, const std::string& dataset) {
  RowsByFrame by_frame;
  for (const FrameRow& row : rows)
    if (row.dataset == dataset) by_frame[row.frame][row.method] = &row;
  return by_frame;
}

AlignedScores align(const AblationComparison& comparison, const RowsByFrame& by_frame) {
  AlignedScores out;
  for (const auto& [with, without] : comparison.pairs) out.of_method[with], out.of_method[without];
  for (const auto& [frame, methods] : by_frame) {
    out.is_sequence = out.is_sequence || methods.begin()->second->is_sequence;
    const bool complete = std::all_of(out.of_method.begin(), out.of_method.end(), [&](const auto& entry) {
      const auto row = methods.find(entry.first);
      return row != methods.end() && row->second->score;
    });
    if (!complete) continue;
    ++out.frames;
    for (auto& [method, scores] : out.of_method) {
      const FrameRow& row = *methods.at(method);
      scores.push_back({*row.score, row.is_sequence ? row.dataset : ""});
    }
  }
  return out;
}

/// One metric over the pairs of a comparison.
class PairedMetric {
 public:
  PairedMetric(const AblationComparison& comparison, const AlignedScores& scores, const Metric& metric)
      : comparison_(comparison), metric_(metric) {
    for (const auto& [method, frames] : scores.of_method)
      columns_.emplace(method, MetricColumn(frames, metric));
  }
  std::optional<double> with(const std::vector<int>& frames) const {
    return mean_over_pairs([&](const auto& pair) { return micro(pair.first, frames); });
  }
  std::optional<double> without(const std::vector<int>& frames) const {
    return mean_over_pairs([&](const auto& pair) { return micro(pair.second, frames); });
  }
  bool differs() const {
    return std::any_of(comparison_.pairs.begin(), comparison_.pairs.end(), [&](const auto& pair) {
      return columns_.at(pair.first).sums != columns_.at(pair.second).sums;
    });
  }

 private:
  std::optional<double> micro(const std::string& method, const std::vector<int>& frames) const {
    return columns_.at(method).micro(frames, metric_);
  }
  std::optional<double> mean_over_pairs(const auto& value_of) const {
    double sum = 0;
    for (const auto& pair : comparison_.pairs) {
      const std::optional<double> value = value_of(pair);
      if (!value) return std::nullopt;
      sum += *value;
    }
    return sum / static_cast<double>(comparison_.pairs.size());
  }

  const AblationComparison& comparison_;
  const Metric& metric_;
  std::map<std::string, MetricColumn> columns_;
};

AblationRow row_for(const AblationComparison& comparison, const std::string& dataset,
                    const std::string& measure) {
  AblationRow row;
  row.design = enum_name(comparison.design);
  row.base = comparison.base;
  row.switch_name = comparison.switch_name;
  row.dataset = dataset;
  row.measure = measure;
  row.reason = comparison.not_applicable;
  return row;
}

void estimate(const PairedMetric& metric, const ScoredFrames& frames, const BootstrapOptions& options,
              AblationRow& row) {
  const std::vector<int> all = all_indices(frames);
  row.n = static_cast<int>(frames.size());
  row.with = metric.with(all);
  row.without = metric.without(all);
  if (!row.with || !row.without) {
    row.reason = reason_not_provided(frames, score_metric(row.measure).needs_truth,
                                     score_metric(row.measure).needs_prediction);
    if (row.reason.empty()) row.reason = "its denominator is 0";
    return;
  }
  row.change = *row.with - *row.without;
  if (!metric.differs()) {
    row.lo = row.hi = 0;
    row.p = 1;
    row.reason = "no frame differs";
    return;
  }
  if (frames.size() < 2) return;
  std::vector<double> replicates;
  for_each_resample(sequences_of(frames), options, [&](const std::vector<int>& drawn) {
    const auto with = metric.with(drawn), without = metric.without(drawn);
    if (with && without) replicates.push_back(*with - *without);
  });
  row.p = two_sided_p(replicates);
  if (const auto interval = percentile_interval(std::move(replicates))) {
    row.lo = interval->lo;
    row.hi = interval->hi;
  }
}

void correct(std::vector<AblationRow>& rows) {
  std::map<std::tuple<std::string, std::string, std::string>, std::vector<AblationRow*>> families;
  for (AblationRow& row : rows)
    if (row.p) families[{row.design, row.base, row.dataset}].push_back(&row);
  for (auto& [family, members] : families) {
    std::vector<double> p;
    for (const AblationRow* row : members) p.push_back(*row->p);
    const std::vector<double> adjusted = holm(p);
    for (std::size_t i = 0; i < members.size(); ++i) members[i]->p_holm = adjusted[i];
  }
}

}  // namespace

std::vector<AblationRow> ablation_effects(const AblationPlan& plan, const std::vector<FrameRow>& rows,
                                          const std::vector<std::string>& datasets,
                                          const BootstrapOptions& options) {
  std::vector<AblationRow> out;
  for (const std::string& dataset : datasets) {
    const RowsByFrame by_frame = rows_on(rows, dataset);
    for (const AblationComparison& comparison : plan.comparisons) {
      const AlignedScores scores = align(comparison, by_frame);
      for (const std::string& name : comparison.metrics) {
        AblationRow row = row_for(comparison, dataset, name);
        if (row.reason.empty() && comparison.sequences_only && !scores.is_sequence)
          row.reason = "not a sequence";
        if (row.reason.empty() && scores.frames == 0)
          row.reason = "no frame is scored for all of its methods";
        if (row.reason.empty())
          estimate(PairedMetric(comparison, scores, score_metric(name)), scores.of_method.begin()->second,
                   options, row);
        out.push_back(std::move(row));
      }
    }
  }
  correct(out);
  return out;
}

std::vector<double> holm(const std::vector<double>& p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  std::vector<double> adjusted(p.size());
  double largest = 0;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    largest = std::max(largest, std::min(1.0, static_cast<double>(p.size() - rank) * p[order[rank]]));
    adjusted[order[rank]] = largest;
  }
  return adjusted;
}

}  // namespace facet

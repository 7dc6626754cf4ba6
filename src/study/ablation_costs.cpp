#include <algorithm>

#include "compare/quiet_times.hpp"
#include "score/paired_scores.hpp"
#include "study/ablation_effects.hpp"
#include "study/design_names.hpp"

namespace facet {
namespace {

/// Total time per frame of one method, as if the machine had been as fast all the time as it was at the
/// median.
std::map<std::string, double> totals(const RunRecord& run, const std::string& method,
                                     const std::string& dataset) {
  const QuietTimes times = quiet_times(run, {method, dataset});
  std::map<std::string, double> out;
  for (const auto& [frame, ms] : times.frames_ms) {
    const auto beside = times.calibration_ms.find(frame);
    const bool calibrated = run.calibration && beside != times.calibration_ms.end();
    out[frame] = calibrated ? ms.back() * run.calibration->median_ms / beside->second : ms.back();
  }
  return out;
}

struct FrameCost {
  double with = 0, without = 0;
};

/// Mean over the pairs, of the frames that all of them have.
std::vector<FrameCost> costs_of(const AblationComparison& comparison, const RunRecord& run,
                                const std::string& dataset) {
  std::map<std::string, FrameCost> sums;
  std::map<std::string, std::size_t> counts;
  for (const auto& [with, without] : comparison.pairs) {
    const auto on = totals(run, with, dataset), off = totals(run, without, dataset);
    for (const auto& [frame, ms] : on) {
      const auto found = off.find(frame);
      if (found == off.end()) continue;
      sums[frame].with += ms;
      sums[frame].without += found->second;
      ++counts[frame];
    }
  }
  std::vector<FrameCost> out;
  const auto pairs = static_cast<double>(comparison.pairs.size());
  for (const auto& [frame, sum] : sums)
    if (counts[frame] == comparison.pairs.size()) out.push_back({sum.with / pairs, sum.without / pairs});
  return out;
}

FrameCost mean_of(const std::vector<FrameCost>& costs, const std::vector<int>& frames) {
  FrameCost sum;
  for (const int frame : frames) {
    sum.with += costs[static_cast<std::size_t>(frame)].with;
    sum.without += costs[static_cast<std::size_t>(frame)].without;
  }
  const auto n = static_cast<double>(frames.size());
  return {sum.with / n, sum.without / n};
}

void estimate(const std::vector<FrameCost>& costs, const BootstrapOptions& options, AblationRow& row) {
  std::vector<int> all(costs.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
  const FrameCost mean = mean_of(costs, all);
  row.n = static_cast<int>(costs.size());
  row.with = mean.with;
  row.without = mean.without;
  row.change = mean.with - mean.without;
  if (costs.size() < 2) return;
  std::vector<double> replicates;
  for_each_resample(std::vector<std::string>(costs.size()), options, [&](const std::vector<int>& drawn) {
    const FrameCost m = mean_of(costs, drawn);
    replicates.push_back(m.with - m.without);
  });
  row.p = two_sided_p(replicates);
  const auto interval = percentile_interval(std::move(replicates));
  row.lo = interval->lo;
  row.hi = interval->hi;
}

}  // namespace

std::vector<AblationRow> ablation_costs(const AblationPlan& plan, const RunRecord& run,
                                        const BootstrapOptions& options) {
  std::vector<AblationRow> out;
  if (run.timing.samples.empty()) return out;
  for (const std::string& dataset : run.manifest.datasets) {
    const bool is_sequence = std::any_of(run.frames.begin(), run.frames.end(), [&](const FrameRow& row) {
      return row.dataset == dataset && row.is_sequence;
    });
    for (const AblationComparison& comparison : plan.comparisons) {
      AblationRow row;
      row.design = enum_name(comparison.design);
      row.base = comparison.base;
      row.switch_name = comparison.switch_name;
      row.dataset = dataset;
      row.measure = "total_ms";
      row.reason = comparison.not_applicable;
      if (row.reason.empty() && comparison.sequences_only && !is_sequence) row.reason = "not a sequence";
      const std::vector<FrameCost> costs =
          row.reason.empty() ? costs_of(comparison, run, dataset) : std::vector<FrameCost>{};
      if (row.reason.empty() && costs.empty()) row.reason = "not timed";
      if (row.reason.empty()) estimate(costs, options, row);
      out.push_back(std::move(row));
    }
  }
  return out;
}

}  // namespace facet

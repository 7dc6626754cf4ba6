#include "compare/quiet_times.hpp"

#include <algorithm>

namespace facet {
namespace {

double quantile(std::vector<double> values, double q) {
  std::sort(values.begin(), values.end());
  return sorted_quantile(values, q);
}

double lower_quartile(const std::vector<double>& values) {
  return quantile(values, 0.25);
}

double scatter_of(const std::vector<double>& repeats) {
  const double quiet = lower_quartile(repeats);
  return quiet > 0 ? (quantile(repeats, 0.75) - quiet) / quiet : 0;
}

/// The block's times beside each frame; frames without one, as those of sequences, have what the whole method
/// has, or the run.
std::map<std::string, double> calibrations(const RunRecord& run, const MethodOnDataset& what,
                                           const QuietTimes& times) {
  std::map<std::string, std::vector<double>> beside;
  std::vector<double> all;
  for (const IoTime& t : run.io_times) {
    if (t.what != "calibration" || t.method != what.first || t.dataset != what.second) continue;
    beside[t.frame].push_back(t.ms);
    all.push_back(t.ms);
  }
  std::map<std::string, double> out;
  for (const auto& [frame, unused] : times.frames_ms) {
    if (const auto found = beside.find(frame); found != beside.end())
      out[frame] = lower_quartile(found->second);
    else if (!all.empty())
      out[frame] = lower_quartile(all);
    else if (run.calibration)
      out[frame] = run.calibration->median_ms;
  }
  return out;
}

bool has_stages(const RunRecord& run, const MethodOnDataset& what) {
  return std::any_of(run.timing.samples.begin(), run.timing.samples.end(), [&](const TimingSample& s) {
    return s.method == what.first && s.dataset == what.second && !s.stage_ms.empty();
  });
}

}  // namespace

QuietTimes quiet_times(const RunRecord& run, const MethodOnDataset& what) {
  QuietTimes out;
  if (has_stages(run, what)) out.stages = run.timing.stages;
  out.stages.push_back("total");
  std::map<std::string, std::vector<std::vector<double>>> samples;
  for (const TimingSample& sample : run.timing.samples) {
    if (sample.phase != TimingPhase::steady || sample.method != what.first || sample.dataset != what.second)
      continue;
    auto& columns = samples[sample.frame];
    columns.resize(out.stages.size());
    for (std::size_t i = 0; i < sample.stage_ms.size(); ++i) columns[i].push_back(sample.stage_ms[i]);
    columns.back().push_back(sample.total_ms);
  }
  std::vector<std::vector<double>> scatters(out.stages.size());
  for (const auto& [frame, columns] : samples) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      out.frames_ms[frame].push_back(lower_quartile(columns[i]));
      scatters[i].push_back(scatter_of(columns[i]));
    }
  }
  for (const std::vector<double>& stage : scatters)
    out.scatter.push_back(stage.empty() ? 0 : quantile(stage, 0.5));
  out.calibration_ms = calibrations(run, what, out);
  return out;
}

}  // namespace facet

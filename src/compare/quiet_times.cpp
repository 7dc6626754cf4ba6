#include "compare/quiet_times.hpp"

#include <algorithm>

namespace facet {
namespace {

double lower_quartile(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return sorted_quantile(values, 0.25);
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

}  // namespace

QuietTimes quiet_times(const RunRecord& run, const MethodOnDataset& what) {
  QuietTimes out;
  out.stages = run.timing.stages;
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
  for (auto& [frame, columns] : samples)
    for (std::vector<double>& column : columns)
      out.frames_ms[frame].push_back(lower_quartile(std::move(column)));
  out.calibration_ms = calibrations(run, what, out);
  return out;
}

}  // namespace facet

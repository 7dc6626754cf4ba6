#include "report/timing_summary.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <numeric>

#include "record/csv.hpp"
#include "score/intervals.hpp"

namespace facet {
namespace {

using Samples = std::vector<const TimingSample*>;

/// Sum of the named stages of one sample; a stage that was not measured adds nothing.
double sum_of(const TimingSample& sample, const std::vector<std::string>& stages,
              std::span<const std::string_view> keys) {
  double sum = 0;
  for (std::size_t i = 0; i < stages.size(); ++i)
    if (std::find(keys.begin(), keys.end(), stages[i]) != keys.end()) sum += sample.stage_ms[i];
  return sum;
}

template <class Quantity>
TimeStatistics statistics_of(const Samples& samples, const Quantity& quantity) {
  std::vector<double> values;
  for (const TimingSample* s : samples) values.push_back(quantity(*s));
  return summarize_times(values);
}

struct FrameTimes {
  std::vector<double> total_ms;
  double surfaces = 0;
};

/// Deviation within frames, deviation between frames, and the line over the number of surfaces.
void add_frame_statistics(TimingSummary& summary, const Samples& samples) {
  std::map<std::string, FrameTimes> frames;
  for (const TimingSample* s : samples) {
    frames[s->frame].total_ms.push_back(s->total_ms);
    frames[s->frame].surfaces = s->surfaces;
  }
  double squares = 0, degrees = 0;
  std::vector<double> means, surfaces;
  for (const auto& [id, frame] : frames) {
    const double deviation = deviation_of(frame.total_ms);
    const auto frame_degrees = static_cast<double>(frame.total_ms.size() - 1);
    squares += deviation * deviation * frame_degrees;
    degrees += frame_degrees;
    means.push_back(mean_of(frame.total_ms));
    surfaces.push_back(frame.surfaces);
  }
  summary.frames = static_cast<int>(frames.size());
  summary.repeat_deviation_ms = degrees > 0 ? std::sqrt(squares / degrees) : 0;
  if (means.size() >= 2) summary.frame_deviation_ms = deviation_of(means);
  summary.by_surfaces = fit_line(surfaces, means);
}

TimingSummary summarize(const TimingTable& table, const Samples& samples, const std::string& dataset,
                        const std::string& method) {
  static constexpr std::array<std::string_view, 1> pose{"pose"}, grasps{"grasps"};
  const auto pose_of = [&](const TimingSample& s) { return sum_of(s, table.stages, pose); };
  const auto grasps_of = [&](const TimingSample& s) { return sum_of(s, table.stages, grasps); };
  TimingSummary summary;
  summary.dataset = dataset;
  summary.method = method;
  Samples steady, warmup;
  for (const TimingSample* s : samples) {
    if (s->phase == TimingPhase::steady) steady.push_back(s);
    if (s->phase == TimingPhase::warmup) warmup.push_back(s);
    if (s->phase == TimingPhase::first) summary.first_ms = s->total_ms;
  }
  Samples staged = steady;  // of methods without stages: none
  std::erase_if(staged, [](const TimingSample* s) { return s->stage_ms.empty(); });
  for (const TimingRowLayout& row : table3_layout())
    summary.layout.push_back({std::string(row.label), statistics_of(staged, [&](const TimingSample& s) {
                                return sum_of(s, table.stages, row.stages);
                              })});
  for (std::size_t i = 0; i < table.stages.size(); ++i)
    summary.stages.push_back(
        {table.stages[i], statistics_of(staged, [&](const TimingSample& s) { return s.stage_ms[i]; })});
  const auto total = [](const TimingSample& s) { return s.total_ms; };
  summary.total = statistics_of(steady, total);
  summary.warmup = statistics_of(warmup, total);
  summary.pose = statistics_of(staged, pose_of);
  summary.grasps = statistics_of(staged, grasps_of);
  summary.total_without_pose =
      statistics_of(staged, [&](const TimingSample& s) { return s.total_ms - pose_of(s) - grasps_of(s); });
  summary.unattributed = statistics_of(staged, [](const TimingSample& s) {
    return s.total_ms - std::accumulate(s.stage_ms.begin(), s.stage_ms.end(), 0.0);
  });
  double posed = 0;
  for (const TimingSample* s : staged) posed += s->posed;
  if (posed > 0) summary.pose_per_surface_ms = summary.pose.mean_ms * summary.pose.n / posed;
  add_frame_statistics(summary, steady);
  return summary;
}

}  // namespace

TimeStatistics summarize_times(std::span<const double> ms) {
  TimeStatistics result;
  result.n = static_cast<int>(ms.size());
  if (ms.empty()) return result;
  std::vector<double> sorted(ms.begin(), ms.end());
  std::sort(sorted.begin(), sorted.end());
  result.mean_ms = mean_of(ms);
  result.deviation_ms = deviation_of(ms);
  result.min_ms = sorted.front();
  result.max_ms = sorted.back();
  for (std::size_t i = 0; i < percentiles.size(); ++i)
    if (result.n >= least_samples_for(percentiles[i]))
      result.percentile_ms[i] = sorted_quantile(sorted, percentiles[i] / 100.0);
  constexpr std::array<double, 5> box{0.05, 0.25, 0.5, 0.75, 0.95};
  for (std::size_t i = 0; i < box.size(); ++i) result.box_ms[i] = sorted_quantile(sorted, box[i]);
  for (std::size_t i = 0; i < deadlines_ms.size(); ++i)
    result.deadline_misses[i] = static_cast<int>(
        std::count_if(ms.begin(), ms.end(), [&](double value) { return value > deadlines_ms[i]; }));
  result.outliers = count_outliers(ms);
  return result;
}

std::vector<TimingSummary> summarize_timing(const TimingTable& table) {
  std::vector<std::pair<std::string, std::string>> order;
  std::map<std::pair<std::string, std::string>, Samples> groups;
  for (const TimingSample& s : table.samples) {
    Samples& group = groups[{s.dataset, s.method}];
    if (group.empty()) order.emplace_back(s.dataset, s.method);
    group.push_back(&s);
  }
  std::vector<TimingSummary> summaries;
  for (const auto& key : order) summaries.push_back(summarize(table, groups[key], key.first, key.second));
  return summaries;
}

std::string stages_csv(const std::vector<TimingSummary>& summaries) {
  std::string text =
      csv_line({"dataset", "method", "stage", "n", "mean_ms", "sd_ms", "min_ms", "p50_ms", "p90_ms", "p95_ms",
                "p99_ms", "max_ms", "over_30.0_ms", "over_33.3_ms", "outliers"});
  for (const TimingSummary& s : summaries) {
    const auto add = [&](const std::string& name, const TimeStatistics& t) {
      CsvRow row{s.dataset, s.method, name, std::to_string(t.n)};
      for (const double v : {t.mean_ms, t.deviation_ms, t.min_ms}) row.push_back(fmt::format("{:.4f}", v));
      for (const auto& p : t.percentile_ms) row.push_back(p ? fmt::format("{:.4f}", *p) : "");
      row.push_back(fmt::format("{:.4f}", t.max_ms));
      for (const int misses : t.deadline_misses) row.push_back(std::to_string(misses));
      row.push_back(std::to_string(t.outliers));
      text += csv_line(row);
    };
    for (const NamedTimes& stage : s.stages) add(stage.name, stage.times);
    add("unattributed", s.unattributed);
    add("total", s.total);
    add("total_without_pose", s.total_without_pose);
  }
  return text;
}

}  // namespace facet

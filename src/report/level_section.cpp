#include <fmt/format.h>
#include <map>
#include <set>

#include "report/run_report.hpp"
#include "score/intervals.hpp"
#include "score/metrics.hpp"

namespace facet {
namespace {

struct LevelMetric {
  const char *metric, *name;
};
constexpr LevelMetric level_metrics[]{{"surface_recall_0.5", "surface recall, IoU 0.5"},
                                      {"edge_recall_graspable_6px", "graspable edges, 6 px"}};

/// Pooled counts by level of what a data set varies.
std::map<double, Tally> by_level(const RunRecord& run, const std::string& dataset, const std::string& method,
                                 const std::string& axis, const Metric& metric) {
  std::map<double, Tally> levels;
  for (const FrameRow& row : run.frames) {
    if (row.dataset != dataset || row.method != method || row.axis != axis || !row.score) continue;
    if (!metric.is_annotated(*row.score) || (!row.score->failed && !metric.is_predicted(*row.score)))
      continue;
    const MetricSums sums = metric.sums(*row.score);
    levels[row.level].hit += static_cast<int>(sums[0]);
    levels[row.level].n += static_cast<int>(sums[1]);
  }
  return levels;
}

ChartSeries series_of(const std::string& method, int color, const std::map<double, Tally>& levels) {
  ChartSeries series{method, color, true, true, {}};
  for (const auto& [level, t] : levels) {
    if (t.n == 0) continue;
    const Interval interval = wilson_interval(t.hit, t.n);
    series.points.push_back(
        {level, 100.0 * t.hit / t.n, 100 * interval.lo, 100 * interval.hi,
         fmt::format("{} at {}: {:.1f} % ({}/{})", method, level, 100.0 * t.hit / t.n, t.hit, t.n)});
  }
  return series;
}

void add_axis(ReportSection& section, const RunRecord& run, const std::string& dataset,
              const std::string& axis) {
  for (const LevelMetric& shown : level_metrics) {
    const Metric& metric = score_metric(shown.metric);
    XyChart body{{axis, {}, {}}, {fmt::format("{} [%]", shown.name), 0, 100}, {}};
    ReportTable table;
    table.caption = fmt::format("{} over {} on {}", shown.name, axis, dataset);
    table.header = {axis};
    std::map<double, std::vector<std::string>> rows;
    std::size_t number = 0;
    for (const std::string& method : run.manifest.methods) {
      table.header.push_back(method);
      const std::map<double, Tally> levels = by_level(run, dataset, method, axis, metric);
      for (const auto& [level, t] : levels) {
        rows[level].resize(number, "n/a");
        rows[level].push_back(t.n == 0 ? "n/a"
                                       : fmt::format("{}/{} {:.1f} %", t.hit, t.n, 100.0 * t.hit / t.n));
      }
      body.series.push_back(series_of(method, static_cast<int>(number++), levels));
    }
    for (auto& [level, cells] : rows) {
      cells.resize(run.manifest.methods.size(), "n/a");
      cells.insert(cells.begin(), fmt::format("{:g}", level));
      table.rows.push_back(std::move(cells));
    }
    if (table.rows.empty()) continue;
    section.charts.push_back({fmt::format("{} over {}, {}", shown.name, axis, dataset), std::move(body), {}});
    section.tables.push_back(std::move(table));
  }
}

}  // namespace

ReportSection level_section(const RunRecord& run) {
  ReportSection section;
  section.title = "Invariance";
  section.on_console = false;
  for (const std::string& dataset : run.manifest.datasets) {
    std::set<std::string> axes;
    for (const FrameRow& row : run.frames)
      if (row.dataset == dataset && !row.axis.empty()) axes.insert(row.axis);
    for (const std::string& axis : axes) add_axis(section, run, dataset, axis);
  }
  if (!section.charts.empty())
    section.paragraphs.push_back(
        "One thing varied at a time over the same scenes, pooled over frames, with Wilson 95 % intervals. "
        "Levels that the sensor cannot resolve are left out and named in the summary.");
  return section;
}

}  // namespace facet

#include <algorithm>
#include <fmt/format.h>
#include <map>

#include "report/method_differences.hpp"
#include "report/run_report.hpp"
#include "report/timing_summary.hpp"

namespace facet {
namespace {

/// Rows of the table: what a reader compares methods by. Shares all of them.
struct ComparedMetric {
  const char *label, *metric;
};
constexpr ComparedMetric compared_metrics[]{
    {"Objects with pose and grasp", "objects_grasp"},
    {"Objects, a grasp on two of their edges", "objects_by_grasp"},
    {"Graspable surfaces, IoU 0.5", "surface_recall_graspable_0.5"},
    {"Graspable surfaces, a grasp on two of their edges", "surfaces_by_grasp"},
    {"All surfaces, IoU 0.5", "surface_recall_0.5"},
    {"  precision", "surface_precision_0.5"},
    {"All surfaces, IoU 0.75", "surface_recall_0.75"},
    {"Hoover, correct at 0.8", "hoover_correct_0.8"},
    {"Panoptic quality", "pq"},
    {"Graspable edges, 6 px", "edge_recall_graspable_6px"},
    {"All edges, 6 px", "edge_recall_all_6px"},
    {"  precision, edge pixels", "edge_precision_6px"},
    {"Boundary F, depth edges", "boundary_f_depth"},
    {"Boundary F, creases", "boundary_f_crease"},
    {"Objects by pixel, F", "object_overlap_f"},
};

/// What the charts set against time.
constexpr ComparedMetric charted_metrics[]{
    {"graspable surfaces, IoU 0.5 [%]", "surface_recall_graspable_0.5"},
    {"graspable surfaces, by grasps [%]", "surfaces_by_grasp"},
    {"graspable edges, 6 px [%]", "edge_recall_graspable_6px"}};

const ScoreResult* result_of(const RunRecord& run, const std::string& dataset, const std::string& method) {
  const auto found = std::find_if(run.scores.begin(), run.scores.end(), [&](const ScoreResult& r) {
    return r.dataset == dataset && r.method == method;
  });
  return found == run.scores.end() ? nullptr : &*found;
}

std::string value_text(const ScoreCell& cell) {
  return cell.value ? fmt::format("{:.1f}", 100 * *cell.value) : "n/a";
}

/// "; -12.3 [-15.0, -9.8]"
std::string difference_text(const PairedScore& d) {
  if (!d.change) return "";
  if (!d.interval) return fmt::format("; {:+.1f}", 100 * *d.change);
  return fmt::format("; {:+.1f} [{:+.1f}, {:+.1f}]", 100 * *d.change, 100 * d.interval->lo,
                     100 * d.interval->hi);
}

/// Median time of a frame: measured here, or the wall time of a program.
struct MethodTime {
  double ms = 0;
  bool is_program = false;
};
std::optional<MethodTime> time_of(const RunRecord& run, const std::string& dataset,
                                  const std::string& method) {
  std::vector<double> ours, programs;
  for (const TimingSample& s : run.timing.samples)
    if (s.phase == TimingPhase::steady && s.dataset == dataset && s.method == method)
      ours.push_back(s.total_ms);
  for (const IoTime& t : run.io_times)
    if (t.what == "program" && t.dataset == dataset && t.method == method) programs.push_back(t.ms);
  const bool is_program = ours.empty();
  const TimeStatistics times = summarize_times(is_program ? programs : ours);
  if (times.n == 0) return std::nullopt;
  return MethodTime{times.box_ms[2], is_program};
}

void add_times(const RunRecord& run, const std::string& dataset, const std::vector<std::string>& methods,
               ReportTable& table) {
  std::vector<std::string> cells{"Time of a frame, median [ms]"};
  bool any = false, any_program = false;
  for (const std::string& method : methods) {
    const auto time = time_of(run, dataset, method);
    cells.push_back(time ? fmt::format("{:.1f}{}", time->ms, time->is_program ? " (program)" : "") : "n/a");
    any = any || time;
    any_program = any_program || (time && time->is_program);
  }
  if (!any) return;
  table.rows.push_back(std::move(cells));
  if (any_program)
    table.notes.push_back("(program): wall time of the whole program, its start and files included.");
}

std::vector<std::string> metric_names() {
  std::vector<std::string> names;
  for (const ComparedMetric& compared : compared_metrics) names.emplace_back(compared.metric);
  return names;
}

/// A row with a metric of every method; none where no method has it.
void add_score(const RunRecord& run, const std::string& dataset, const ComparedMetric& compared,
               const MethodDifferences& differences, ReportTable& table) {
  std::vector<std::string> cells{compared.label};
  bool any = false;
  for (const std::string& method : run.manifest.methods) {
    const ScoreResult* result = result_of(run, dataset, method);
    const bool known = result != nullptr && result->cell(compared.metric).value;
    cells.push_back(known ? value_text(result->cell(compared.metric)) : "n/a");
    const PairedScore* difference = differences.find(method, compared.metric);
    if (known && difference != nullptr) cells.back() += difference_text(*difference);
    any = any || known;
  }
  if (any) table.rows.push_back(std::move(cells));
}

ReportTable methods_table(const RunRecord& run, const std::string& dataset,
                          const std::vector<std::string>& methods) {
  ReportTable table;
  table.caption = fmt::format("Methods side by side on {} [%]", dataset);
  table.header = {"score"};
  table.header.insert(table.header.end(), methods.begin(), methods.end());
  table.full_rows_file = "metrics/summary.json";
  const MethodDifferences differences(run, dataset, metric_names());
  for (const ComparedMetric& compared : compared_metrics)
    add_score(run, dataset, compared, differences, table);
  add_times(run, dataset, methods, table);
  table.notes.push_back(fmt::format(
      "Pooled over {} frames; after the semicolon the difference to {} in percentage points, with "
      "the 95 % interval of a bootstrap paired over frames. n/a: the method does not yield what "
      "is scored, or the truth lacks it (see Detection and All scores).",
      differences.frames(), methods.front()));
  return table;
}

std::optional<ReportChart> latency_chart(const RunRecord& run, const std::string& dataset,
                                         const ComparedMetric& what,
                                         const std::vector<std::string>& methods) {
  XyChart chart;
  chart.x = {"median time of a frame [ms], logarithmic", {}, {}, true};
  chart.y = {what.label, 0, 100};
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const ScoreResult* result = result_of(run, dataset, methods[i]);
    const auto time = time_of(run, dataset, methods[i]);
    if (result == nullptr || !time || !result->cell(what.metric).value) continue;
    const ScoreCell& cell = result->cell(what.metric);
    ChartPoint point;
    point.x = time->ms;
    point.y = 100 * *cell.value;
    if (cell.lo && cell.hi) point.lo = 100 * *cell.lo, point.hi = 100 * *cell.hi;
    point.hover = fmt::format("{}: {:.1f} % in {:.1f} ms", methods[i], point.y, point.x);
    const std::string name = methods[i] + (time->is_program ? " (whole program)" : "");
    chart.series.push_back({name, static_cast<int>(i), false, true, {point}});
  }
  if (chart.series.size() < 2) return std::nullopt;
  return ReportChart{fmt::format("Accuracy and latency on {}: {}", dataset, what.label),
                     std::move(chart),
                     {"Bars: 95 % intervals of the score."}};
}

ReportTable disputed_table(const std::vector<GalleryEntry>& entries) {
  ReportTable table;
  table.caption = "Frames on which the methods differ most";
  table.header = {"frame", "score", "best", "its value", "worst value"};
  for (const GalleryEntry& e : entries)
    table.rows.push_back({e.dataset + '/' + e.frame, e.metric, e.method, fmt::format("{:.3f}", *e.value),
                          fmt::format("{:.3f}", *e.baseline)});
  return table;
}

}  // namespace

ReportSection methods_section(const RunRecord& run) {
  ReportSection section;
  section.title = "Methods side by side";
  section.on_console = false;
  const std::vector<std::string>& methods = run.manifest.methods;
  // Studies have tables of their own.
  if (methods.size() < 2 || !run.ablation.empty() || !run.sweep.empty()) return section;
  for (const std::string& dataset : run.manifest.datasets) {
    const bool is_scored = std::any_of(run.scores.begin(), run.scores.end(), [&](const ScoreResult& r) {
      return r.dataset == dataset && !r.micro.empty();
    });
    if (!is_scored) continue;
    section.tables.push_back(methods_table(run, dataset, methods));
    for (const ComparedMetric& what : charted_metrics)
      if (auto chart = latency_chart(run, dataset, what, methods))
        section.charts.push_back(std::move(*chart));
  }
  return section;
}

ReportSection disputed_section(const RunRecord& run) {
  ReportSection section;
  section.title = "Where the methods disagree";
  section.on_console = false;
  if (run.disputed.empty()) return section;
  section.tables.push_back(disputed_table(run.disputed));
  for (const GalleryEntry& e : run.disputed)
    if (!e.picture.empty())
      section.pictures.push_back({fmt::format("{} / {}: {} from {:.3f} to {:.3f} ({})", e.dataset, e.frame,
                                              e.metric, *e.baseline, *e.value, e.method),
                                  e.picture});
  return section;
}

}  // namespace facet

#include <algorithm>
#include <fmt/format.h>

#include "report/run_report.hpp"
#include "report/timing_summary.hpp"

namespace facet {
namespace {

std::string mean_and_deviation(const TimeStatistics& t) {
  return t.n == 0 ? "n/a" : fmt::format("{:.2f} ± {:.2f}", t.mean_ms, t.deviation_ms);
}
std::string optional_ms(const std::optional<double>& ms) {
  return ms ? fmt::format("{:.2f}", *ms) : "n/a";
}
std::string paper_time(const std::optional<PaperTime>& paper) {
  return paper ? fmt::format("{:.2f} ± {:.1f}", paper->mean_ms, paper->deviation_ms) : "-";
}

using Summaries = std::vector<const TimingSummary*>;

/// One row of the table: a cell per method, then the paper's.
template <class Cell>
void add_row(ReportTable& table, const Summaries& methods, const std::string& label, const Cell& cell,
             const std::string& paper = "-") {
  std::vector<std::string> row{label};
  for (const TimingSummary* s : methods) row.push_back(cell(*s));
  row.push_back(paper);
  table.rows.push_back(std::move(row));
}

void add_totals(ReportTable& table, const Summaries& m) {
  using S = const TimingSummary&;
  add_row(
      table, m, "Unattributed", [](S s) { return mean_and_deviation(s.unattributed); }, "4.72");
  add_row(
      table, m, "Total without pose and grasps", [](S s) { return mean_and_deviation(s.total_without_pose); },
      "15.90 ± 2.6");
  add_row(table, m, "Pose per frame", [](S s) { return mean_and_deviation(s.pose); });
  add_row(
      table, m, "Pose per surface", [](S s) { return optional_ms(s.pose_per_surface_ms); }, "1.20");
  add_row(table, m, "Grasps per frame", [](S s) { return mean_and_deviation(s.grasps); });
  add_row(
      table, m, "Total", [](S s) { return mean_and_deviation(s.total); }, "16.8, one surface");
  for (std::size_t i = 0; i < deadlines_ms.size(); ++i)
    add_row(table, m, fmt::format("Runs over {:.1f} ms", deadlines_ms[i]),
            [&](S s) { return fmt::format("{} of {}", s.total.deadline_misses[i], s.total.n); });
}

ReportTable table3(const RunRecord& run, const std::string& dataset, const Summaries& methods) {
  ReportTable table;
  table.caption = fmt::format("Time per stage on {} [ms], mean ± standard deviation", dataset);
  table.header = {"stage"};
  for (const TimingSummary* s : methods) table.header.push_back(s->method);
  table.header.push_back("paper, GTX 1070, other data");
  const auto layout = table3_layout();
  for (std::size_t i = 0; i < layout.size(); ++i)
    add_row(
        table, methods, fmt::format("{}{}", layout[i].indented ? "  " : "", layout[i].label),
        [&](const TimingSummary& s) { return mean_and_deviation(s.layout[i].times); },
        paper_time(layout[i].paper));
  add_totals(table, methods);
  const Manifest& m = run.manifest;
  table.notes.push_back(
      fmt::format("{} thread{}, back end {}, {} frame{}, {} runs each after {} for warm-up.",
                  m.timing_threads, m.timing_threads == 1 ? "" : "s", m.backend, methods.front()->frames,
                  methods.front()->frames == 1 ? "" : "s", m.timing_repeats, m.timing_warmup));
  if (m.backend != "cpu")
    table.notes.push_back(
        "Stages are timed on the device, by events between which the host may work too; the total, copies "
        "included, by the clock.");
  table.notes.push_back(
      "Total = decoded depth in memory to contours, poses, grasps and labels in memory. The paper's stages "
      "sum "
      "to 11.18 of its 15.9 ms.");
  return table;
}

ChartRange box_of(const TimeStatistics& t, int color, const std::string& name) {
  const auto& q = t.box_ms;
  return {color,
          q[0],
          q[2],
          q[4],
          q[1],
          q[3],
          fmt::format(
              "{}: median {:.2f} ms, quartiles {:.2f} and {:.2f} ms, 90 % within {:.2f} to {:.2f} ms, n = {}",
              name, q[2], q[1], q[3], q[0], q[4], t.n)};
}

/// Box plots of every row of Table 3, of poses and grasps.
ReportChart stage_chart(const std::string& dataset, const Summaries& methods) {
  RangeChart chart;
  chart.axis = {"time [ms], logarithmic", 0.01, {}, true};
  for (const TimingSummary* s : methods) chart.legend.push_back(s->method);
  const auto add = [&](const std::string& label, const auto& times_of) {
    RangeChart::Row row{label, {}};
    for (std::size_t m = 0; m < methods.size(); ++m)
      if (times_of(*methods[m]).n > 0)  // methods that are not the pipeline have none of its stages
        row.ranges.push_back(
            box_of(times_of(*methods[m]), static_cast<int>(m), label + ", " + methods[m]->method));
    chart.rows.push_back(std::move(row));
  };
  const auto layout = table3_layout();
  for (std::size_t i = 0; i < layout.size(); ++i)
    if (!layout[i].indented)
      add(std::string(layout[i].label), [i](const TimingSummary& s) { return s.layout[i].times; });
  add("Unattributed", [](const TimingSummary& s) { return s.unattributed; });
  add("Pose", [](const TimingSummary& s) { return s.pose; });
  add("Grasps", [](const TimingSummary& s) { return s.grasps; });
  add("Total", [](const TimingSummary& s) { return s.total; });
  return {"Time per stage on " + dataset,
          std::move(chart),
          {"Boxes: median and quartiles; lines: 5 % to 95 % of the runs."}};
}

/// Summaries grouped by data set, in order.
std::vector<Summaries> by_dataset(const std::vector<TimingSummary>& all) {
  std::vector<Summaries> groups;
  for (const TimingSummary& s : all) {
    const auto group = std::find_if(groups.begin(), groups.end(),
                                    [&](const Summaries& g) { return g.front()->dataset == s.dataset; });
    if (group == groups.end())
      groups.push_back({&s});
    else
      group->push_back(&s);
  }
  return groups;
}

std::string percentile_text(const TimeStatistics& t, std::size_t i) {
  if (t.percentile_ms[i]) return fmt::format("{:.2f}", *t.percentile_ms[i]);
  return fmt::format("n/a (n = {} < {})", t.n, least_samples_for(percentiles[i]));
}

std::vector<std::string> detail_row(const std::string& name, const TimeStatistics& t) {
  std::vector<std::string> row{name, std::to_string(t.n), fmt::format("{:.3f}", t.mean_ms),
                               fmt::format("{:.3f}", t.deviation_ms)};
  for (std::size_t i = 0; i < percentiles.size(); ++i) row.push_back(percentile_text(t, i));
  row.push_back(fmt::format("{:.2f}", t.max_ms));
  for (const int misses : t.deadline_misses) row.push_back(std::to_string(misses));
  row.push_back(std::to_string(t.outliers));
  return row;
}

std::string slope_text(const TimingSummary& s) {
  if (!s.by_surfaces) return "n/a: fewer than three frames with different numbers of surfaces";
  const LineFit& fit = *s.by_surfaces;
  return fmt::format("{:+.3f} ms per surface, 95 % interval [{:+.3f}, {:+.3f}], n = {} frames", fit.slope,
                     fit.slope_low, fit.slope_high, fit.n);
}

ReportTable detail_table(const TimingSummary& s) {
  ReportTable table;
  table.caption = fmt::format("{} on {}, every stage [ms]", s.method, s.dataset);
  table.header = {"stage", "n",   "mean", "sd",     "p50",    "p90",
                  "p95",   "p99", "max",  "> 30.0", "> 33.3", "outliers"};
  for (const NamedTimes& stage : s.stages)
    if (stage.times.n > 0) table.rows.push_back(detail_row(stage.name, stage.times));
  if (s.unattributed.n > 0) table.rows.push_back(detail_row("unattributed", s.unattributed));
  table.rows.push_back(detail_row("total", s.total));
  table.notes.push_back(fmt::format("First run {} ms; warm-up {} ms (n = {}).", optional_ms(s.first_ms),
                                    mean_and_deviation(s.warmup), s.warmup.n));
  table.notes.push_back(fmt::format(
      "Repeats of one frame: sd {:.3f} ms (pooled). Different frames: sd {} ms.", s.repeat_deviation_ms,
      s.frame_deviation_ms ? fmt::format("{:.3f}", *s.frame_deviation_ms) : std::string("n/a (one frame)")));
  table.notes.push_back("Slope of the total over the number of surfaces: " + slope_text(s) + ".");
  table.notes.push_back(
      "Outliers have a modified z score over 3.5; they are counted here and kept everywhere.");
  return table;
}

ReportTable io_table(const RunRecord& run) {
  ReportTable table;
  table.caption = "Outside the methods [ms]";
  table.header = {"what", "n", "mean", "sd", "max"};
  const auto add = [&](const std::string& label, const auto& is_meant) {
    std::vector<double> ms;
    for (const IoTime& t : run.io_times)
      if (is_meant(t)) ms.push_back(t.ms);
    const TimeStatistics t = summarize_times(ms);
    if (t.n > 0)
      table.rows.push_back({label, std::to_string(t.n), fmt::format("{:.2f}", t.mean_ms),
                            fmt::format("{:.2f}", t.deviation_ms), fmt::format("{:.2f}", t.max_ms)});
    return t.n > 0;
  };
  for (const std::string what : {"decode", "write"})
    add(what, [&](const IoTime& t) { return t.what == what; });
  bool any_program = false;
  for (const std::string& method : run.manifest.methods)
    any_program |= add("program of " + method,
                       [&](const IoTime& t) { return t.what == "program" && t.method == method; });
  if (any_program)
    table.notes.push_back(
        "A program's time is its wall time in the accuracy pass, its start and its files included; of one "
        "that takes all frames at once, the share of a frame.");
  table.notes.push_back(
      fmt::format("Frames are decoded before their timed runs; outputs were written in the "
                  "accuracy pass, {} frames at a time.",
                  run.manifest.jobs));
  return table;
}

}  // namespace

ReportTable table3_of_paper(const RunRecord& run, const std::string& dataset) {
  ReportTable table;
  table.caption = fmt::format("Time per stage on {} [ms]", dataset);
  table.header = {"method"};
  std::vector<std::string> paper{"paper, GTX 1070, other data"};
  for (const TimingRowLayout& row : table3_layout()) {
    if (row.indented) continue;
    table.header.emplace_back(row.label);
    paper.push_back(paper_time(row.paper));
  }
  table.header.emplace_back("Total");
  paper.emplace_back("15.90 ± 2.6");
  for (const TimingSummary& s : summarize_timing(run.timing)) {
    if (s.dataset != dataset) continue;
    std::vector<std::string> cells{s.method};
    for (std::size_t i = 0; i < s.layout.size(); ++i)
      if (!table3_layout()[i].indented) cells.push_back(mean_and_deviation(s.layout[i].times));
    cells.push_back(mean_and_deviation(s.total_without_pose));
    table.rows.push_back(std::move(cells));
  }
  if (table.rows.empty()) return table;
  table.rows.push_back(std::move(paper));
  table.notes.push_back("Total: without poses and grasps, with what no stage accounts for.");
  return table;
}

ReportSection timing_section(const RunRecord& run) {
  ReportSection section;
  section.title = "Timing";
  const std::vector<TimingSummary> summaries = summarize_timing(run.timing);
  for (const Summaries& methods : by_dataset(summaries)) {
    section.tables.push_back(table3(run, methods.front()->dataset, methods));
    section.charts.push_back(stage_chart(methods.front()->dataset, methods));
  }
  if (summaries.empty()) section.paragraphs.push_back("Not timed.");
  return section;
}

ReportSection timing_detail_section(const RunRecord& run) {
  ReportSection section;
  section.title = "Timing in detail";
  section.folded = true;
  section.on_console = false;
  for (const TimingSummary& s : summarize_timing(run.timing)) section.tables.push_back(detail_table(s));
  if (!run.io_times.empty()) section.tables.push_back(io_table(run));
  if (run.calibration)
    section.paragraphs.push_back(
        fmt::format("Calibration block (fixed OpenCV operations, one thread): median {:.2f} ms of "
                    "{} repeats.",
                    run.calibration->median_ms, run.calibration->repeats));
  return section;
}

}  // namespace facet

#include <algorithm>
#include <fmt/format.h>
#include <map>

#include "report/run_report.hpp"
#include "score/metrics.hpp"

namespace facet {
namespace {

using Results = std::vector<const ScoreResult*>;

/// The results on one data set, in the order of the methods.
Results results_on(const RunRecord& run, const std::string& dataset) {
  Results results;
  for (const std::string& method : run.manifest.methods)
    for (const ScoreResult& result : run.scores)
      if (result.dataset == dataset && result.method == method) results.push_back(&result);
  return results;
}

bool is_scored(const Results& results) {
  return std::any_of(results.begin(), results.end(), [](const ScoreResult* r) { return !r->micro.empty(); });
}

std::string percent(double share) {
  return fmt::format("{:.1f}", 100 * share);
}

/// "97/105 92.4 %"; n/a where there is no value.
std::string proportion_text(const ScoreCell& cell) {
  if (!cell.value || !cell.hit || !cell.n) return "n/a";
  return fmt::format("{:.0f}/{:.0f} {} %", *cell.hit, *cell.n, percent(*cell.value));
}

/// A row of the table in the sense of the paper's Table 2.
struct DetectionRow {
  const char *label, *metric, *paper, *behal;
};
constexpr DetectionRow detection_rows[]{
    {"Objects with pose and grasp", "objects_grasp", "52/52 100 %", "48/52 92.3 %"},
    {"Objects with pose", "objects_pose", "-", "-"},
    {"Graspable surfaces, IoU 0.5", "surface_recall_graspable_0.5", "102/102 100 %", "79/102 77.5 %"},
    {"Objects, a grasp on two of their edges", "objects_by_grasp", "-", "-"},
    {"Graspable surfaces, a grasp on two of their edges", "surfaces_by_grasp", "-", "-"},
    {"All surfaces, IoU 0.5", "surface_recall_0.5", "-", "-"},
    {"  precision", "surface_precision_0.5", "-", "-"},
    {"Graspable edges, 6 px", "edge_recall_graspable_6px", "225/229 98.3 %", "178/229 77.7 %"},
    {"All edges, 6 px", "edge_recall_all_6px", "-", "-"},
    {"  precision, edge pixels", "edge_precision_6px", "-", "-"},
};

struct CountRow {
  const char *label, *key;
};
constexpr CountRow count_rows[]{{"Frames", "n_total"},
                                {"  scored", "n_scored"},
                                {"  failed by the method", "n_method_failed"},
                                {"  could not be read", "n_harness_error"},
                                {"  without truth", "n_not_annotated"}};

void add_reasons(const Results& results, const std::vector<std::string>& metrics, ReportTable& table) {
  std::map<std::string, std::string> reasons;  // one line per reason and method
  for (const ScoreResult* result : results)
    for (const std::string& metric : metrics)
      if (const ScoreCell& cell = result->cell(metric); !cell.value && !cell.reason.empty())
        reasons[fmt::format("{}: {}", result->method, cell.reason)] += (reasons.empty() ? "" : " ") + metric;
  for (const auto& [reason, names] : reasons) table.notes.push_back(fmt::format("n/a, {}.", reason));
}

void add_sources(const ScoreResult& result, ReportTable& table) {
  for (const auto& [source, frames] : result.truth_sources)
    table.notes.push_back(fmt::format("Truth of {} frame{}: {}.", frames, frames == 1 ? "" : "s", source));
}

ReportTable detection_table(const std::string& dataset, const Results& results) {
  ReportTable table;
  table.caption = fmt::format("Detected on {}", dataset);
  table.header = {"what"};
  for (const ScoreResult* result : results) table.header.push_back(result->method);
  table.header.insert(table.header.end(), {"paper, other data", "[19], other data"});
  std::vector<std::string> metrics;
  for (const DetectionRow& row : detection_rows) {
    std::vector<std::string> cells{row.label};
    for (const ScoreResult* result : results) cells.push_back(proportion_text(result->cell(row.metric)));
    cells.insert(cells.end(), {row.paper, row.behal});
    table.rows.push_back(std::move(cells));
    metrics.emplace_back(row.metric);
  }
  for (const CountRow& row : count_rows) {
    std::vector<std::string> cells{row.label};
    for (const ScoreResult* result : results) {
      const auto found = result->counts.find(row.key);
      cells.push_back(found == result->counts.end() ? "n/a" : std::to_string(found->second));
    }
    cells.insert(cells.end(), {"-", "-"});
    table.rows.push_back(std::move(cells));
  }
  add_sources(*results.front(), table);
  add_reasons(results, metrics, table);
  table.notes.push_back(
      "The paper's columns count eight scenes whose truth was never published: other data, not a "
      "comparison.");
  return table;
}

std::string share_text(double value, const Metric& metric) {
  // A ratio may exceed 1 and is no share.
  return metric.name == "surface_count_ratio" ? fmt::format("{:.2f}", value) : percent(value);
}

std::string detail_text(const ScoreResult& result, const Metric& metric) {
  const ScoreCell& micro = result.cell(metric.name);
  if (!micro.value) return "n/a";
  std::string text = share_text(*micro.value, metric);
  if (micro.lo && micro.hi)
    text += fmt::format(" [{}, {}]", share_text(*micro.lo, metric), share_text(*micro.hi, metric));
  if (const auto macro = result.macro.find(metric.name); macro != result.macro.end() && macro->second.value)
    text += fmt::format(" / {}", share_text(*macro->second.value, metric));
  return text;
}

ReportTable detail_table(const std::string& dataset, const Results& results) {
  ReportTable table;
  table.caption = fmt::format("All scores on {} [%]: pooled [95 % interval] / mean over frames", dataset);
  table.header = {"score"};
  table.full_rows_file = "metrics/summary.json";
  for (const ScoreResult* result : results) table.header.push_back(result->method);
  std::vector<std::string> metrics;
  for (const Metric& metric : score_metrics()) {
    if (!results.front()->micro.contains(metric.name)) continue;
    std::vector<std::string> cells{metric.name + (metric.less_is_better ? " (less is better)" : "")};
    for (const ScoreResult* result : results) cells.push_back(detail_text(*result, metric));
    table.rows.push_back(std::move(cells));
    metrics.push_back(metric.name);
  }
  add_reasons(results, metrics, table);
  return table;
}

ReportTable error_table(const std::string& dataset, const Results& results) {
  ReportTable table;
  table.caption = fmt::format("Pose errors of detected surfaces on {}: median, 95 % quantile, n", dataset);
  table.header = {"error"};
  for (const ScoreResult* result : results) table.header.push_back(result->method);
  for (const auto& [name, unused] : results.front()->errors) {
    std::vector<std::string> cells{name};
    for (const ScoreResult* result : results) {
      const auto found = result->errors.find(name);
      const bool known = found != result->errors.end() && found->second.p50 && found->second.p95;
      cells.push_back(known ? fmt::format("{:.4g}, {:.4g}, n = {}", *found->second.p50, *found->second.p95,
                                          found->second.n)
                            : "n/a");
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

const ScoreStratum* stratum_of(const ScoreResult& result, const ScoreStratum& like) {
  for (const ScoreStratum& stratum : result.strata)
    if (stratum.axis == like.axis && stratum.label == like.label) return &stratum;
  return nullptr;
}

ReportTable clutter_table(const std::string& dataset, const Results& results, const std::string& metric) {
  ReportTable table;
  table.caption = fmt::format("{} by clutter on {}", metric, dataset);
  table.header = {"clutter", "frames"};
  for (const ScoreResult* result : results) table.header.push_back(result->method);
  for (const ScoreStratum& stratum : results.front()->strata) {
    std::vector<std::string> cells{fmt::format("{} {}", stratum.axis, stratum.label),
                                   std::to_string(stratum.frames)};
    for (const ScoreResult* result : results) {
      const ScoreStratum* same = stratum_of(*result, stratum);
      const auto cell =
          same == nullptr ? std::map<std::string, ScoreCell>::const_iterator{} : same->micro.find(metric);
      cells.push_back(same == nullptr || cell == same->micro.end() ? "n/a" : proportion_text(cell->second));
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

}  // namespace

ReportSection detection_section(const RunRecord& run) {
  ReportSection section;
  section.title = "Detection";
  for (const std::string& dataset : run.manifest.datasets) {
    const Results results = results_on(run, dataset);
    if (!is_scored(results)) continue;
    section.tables.push_back(detection_table(dataset, results));
    if (ReportTable frames = table2_of_paper(run, dataset); !frames.rows.empty())
      section.tables.push_back(std::move(frames));
  }
  if (section.tables.empty()) section.paragraphs.push_back("Not scored: no frame has truth.");
  return section;
}

ReportSection score_detail_section(const RunRecord& run) {
  ReportSection section;
  section.title = "Scores in detail";
  section.folded = true;
  section.on_console = false;
  for (const std::string& dataset : run.manifest.datasets) {
    const Results results = results_on(run, dataset);
    if (!is_scored(results)) continue;
    section.tables.push_back(detail_table(dataset, results));
    if (!results.front()->errors.empty()) section.tables.push_back(error_table(dataset, results));
    for (const char* metric : {"surface_recall_0.5", "surface_precision_0.5", "edge_recall_graspable_6px"})
      if (results.front()->micro.contains(metric))
        section.tables.push_back(clutter_table(dataset, results, metric));
  }
  if (section.tables.empty()) section.paragraphs.push_back("Not scored.");
  return section;
}

}  // namespace facet

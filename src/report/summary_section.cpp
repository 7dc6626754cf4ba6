#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/run_report.hpp"
#include "report/timing_summary.hpp"

namespace facet {
namespace {

/// More results than this are read from tables.
constexpr std::size_t most_tiles = 9;

void add_percent(ReportTile& tile, const ScoreResult& result, const char* label, const char* metric) {
  const ScoreCell& cell = result.cell(metric);
  if (!cell.value) return;
  std::string text = fmt::format("{:.1f} %", 100 * *cell.value);
  if (cell.lo && cell.hi && !tile.values.empty())
    text += fmt::format(" [{:.1f}, {:.1f}]", 100 * *cell.lo, 100 * *cell.hi);
  tile.values.emplace_back(label, std::move(text));
}

ReportTile tile_of(const RunRecord& run, const std::vector<TimingSummary>& times, const std::string& dataset,
                   const std::string& method) {
  ReportTile tile{method + " on " + dataset, {}};
  for (const ScoreResult& result : run.scores) {
    if (result.dataset != dataset || result.method != method) continue;
    add_percent(tile, result, "surfaces found, IoU 0.5", "surface_recall_0.5");
    add_percent(tile, result, "precision of surfaces", "surface_precision_0.5");
    add_percent(tile, result, "graspable edges found", "edge_recall_graspable_6px");
    add_percent(tile, result, "objects with pose and grasp", "objects_grasp");
    const auto error = result.errors.find("normal_error_deg");
    if (error != result.errors.end() && error->second.p50)
      tile.values.emplace_back("error of normals, median", fmt::format("{:.2f} deg", *error->second.p50));
  }
  for (const TimingSummary& t : times)
    if (t.dataset == dataset && t.method == method && t.total.n > 0)
      tile.values.emplace_back("time per frame",
                               fmt::format("{:.1f} ± {:.1f} ms", t.total.mean_ms, t.total.deviation_ms));
  return tile;
}

}  // namespace

ReportSection summary_section(const RunRecord& run) {
  const Manifest& m = run.manifest;
  ReportSection section;
  section.title = "Summary";
  const int failed = m.frames_data_error + m.frames_method_error;
  section.paragraphs.push_back(fmt::format(
      "{}: {} method{} on {}, {} of {} frames processed, {} failed.", status_name(m.status), m.methods.size(),
      m.methods.size() == 1 ? "" : "s", fmt::join(m.datasets, ", "), m.frames_ok, m.frames_planned, failed));
  if (failed > 0)
    section.paragraphs.push_back(fmt::format("Failed: {} could not be read, {} could not be processed.",
                                             m.frames_data_error, m.frames_method_error));
  for (const std::string& note : m.notes) section.paragraphs.push_back(note + '.');
  if (m.datasets.size() * m.methods.size() > most_tiles) return section;
  const std::vector<TimingSummary> times = summarize_timing(run.timing);
  for (const std::string& dataset : m.datasets)
    for (const std::string& method : m.methods)
      if (ReportTile tile = tile_of(run, times, dataset, method); !tile.values.empty())
        section.tiles.push_back(std::move(tile));
  return section;
}

}  // namespace facet
